#pragma once

#include "grader/results/results.h"

#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace grader::platforms {

// The page that shows which submissions of a class are alike: equal files, files that differ only
// in comments, layout and their own names, and files that are wrong in the same way. It shows how
// much of the class has each, the rarest first, and is not an accusation.
class Likeness {
 public:
  // `files`: the text of each task file, by slug. What is not attempted does not count.
  void add(const std::string& name, const std::map<std::string, std::string>& files,
           const results::Results& results);

  std::string to_html() const;

  // Submissions that have one thing in common.
  struct Group {
    std::string slug, what;
    std::size_t size = 0;            // tokens, or wrong answers
    std::vector<std::string> names;  // in alphabetical order
    std::size_t of = 0;              // submissions that attempted the task
    std::size_t mistaken = 0;        // and for whom the same mistake was named; 0: none was
  };

  // Each in the order of the page.
  std::vector<Group> equal_files() const;
  std::vector<Group> equal_shapes() const;  // of files that are not all equal
  std::vector<Group> equal_faults() const;  // of files whose shapes are not all equal

 private:
  struct File {
    std::string name, text, shape, faults;  // but for the name digests; `faults` may be empty
    std::string what, mistake;
    std::size_t tokens = 0, wrong = 0;
  };
  using Files = std::map<std::string, std::vector<File>>;  // by slug

  std::vector<Group> groups(std::string File::*same, std::string File::*different,
                            std::size_t File::*size) const;

  Files files_;
  std::size_t submissions_ = 0;
};

}  // namespace grader::platforms
