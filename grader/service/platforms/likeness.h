#pragma once

#include "grader/results/results.h"
#include "grader/service/platforms/sketch.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace grader::platforms {

// The page that shows which submissions of a class are alike: equal files, pairs whose sketches have most in common
// (grader/service/platforms/sketch.h), pairs with a file of the repository, and files that are wrong in the same way. It is not an
// accusation.
class Likeness {
 public:
  // The files of a task that learners may have had before them.
  struct Known {
    std::string stub;  // as it was handed out: it is left out of all sketches
    std::map<std::string, std::string> others;  // solutions in the repository, by path
  };

  explicit Likeness(const std::map<std::string, Known>& known = {});  // by slug

  // `files`: the text of each task file, by slug. What is not attempted does not count.
  void add(const std::string& name, const std::map<std::string, std::string>& files,
           const results::Results& results);

  // `source` has the file of a task, of a learner or with a path of the repository.
  using Source = std::function<std::string(const std::string& slug, const std::string& name)>;
  std::string to_html(const Source& source) const;

  // Submissions that have one thing in common.
  struct Group {
    std::string slug, what;
    std::size_t size = 0;            // lines, or wrong answers
    std::vector<std::string> names;  // in alphabetical order
    std::size_t of = 0;              // submissions that attempted the task
    std::size_t mistaken = 0;        // and for whom the same mistake was named; 0: none was
  };
  std::vector<Group> equal_files() const;
  std::vector<Group> equal_faults() const;  // of wrong files that are not all equal

  // Two files that are not equal. `share`: of the prints of the one that has fewer.
  struct Pair {
    std::string slug, a, b;
    double share = 0;
    std::size_t prints = 0;  // in common
  };
  std::vector<Pair> pairs() const;        // the most alike first; for each task the first few
  std::vector<Pair> known_pairs() const;  // `b` is a path of the repository, the one most alike

 private:
  using Prints = std::set<std::uint64_t>;
  struct File {
    std::string name, text, faults;  // but for the name digests; `faults` may be empty
    std::string what, mistake;
    std::size_t lines = 0, wrong = 0;
    Prints prints{};
  };
  struct Task {
    Prints stub;
    std::map<std::string, Prints> others;
    std::vector<File> files;
  };

  std::vector<Group> groups(std::string File::*same, std::string File::*different,
                            std::size_t File::*size) const;
  static std::vector<const File*> different_files(const Task& task);
  static Prints left_out(const Task& task);

  std::map<std::string, Task> tasks_;  // by slug
  std::size_t submissions_ = 0;
};

}  // namespace grader::platforms
