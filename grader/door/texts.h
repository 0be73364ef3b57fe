#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace grader::door {

// A rule that says where a task is not written yet: a function whose body mentions none of the
// words. `$first` and `$last` stand for names of its parameters. Without a function the whole file is meant.
struct Stub {
  std::string function{};
  std::vector<std::string> words{};
};

// A promise that is judged from this year of the course on, besides those of the contract. With a
// name that ends with _bonus, it is a bonus promise.
struct AddedPromise {
  std::string since{}, name{}, words{};
};

// An adapter makes a task of the learner's function. It is a file in grader/door/tasks/:
//   sources   the learner's files, without folders; the first has the function
//   function  the name that the learner knows it by; it may be another one in 2019
//   stub      see above
//   promise   the first year, the name, and what it says: fl_not_kept(name, ...) says that it is broken
//   cause     the name of a known mistake of the task with which calls do not end: the promises that it breaks in this way cost one
//   named     the name of a mistake, and a sentence: fl_not_kept(name, ...) says that it was seen
//   together  a task that works perhaps only with this one: then its promise works_with_any says so
//   ---       the includes of the task follow, and behind another line of this kind our functions
struct Adapter {
  std::vector<std::string> sources{}, functions{};
  std::vector<Stub> stubs{};
  std::vector<AddedPromise> promises{};
  std::set<std::string> causes{};              // names of mistakes
  std::map<std::string, std::string> named{};  // by the name: the sentence
  std::string together{};                      // a slug, or empty
  std::string includes{}, code{};
};

// The texts of the project that the learner's are put between.
struct Texts {
  std::map<std::string, Adapter> tasks{};  // by slug
  // Files that stand in for the course's, by the end of their path.
  std::map<std::string, std::string> seams{};
  std::map<std::string, std::string> around{};
};

// Reads grader/door/. Throws pt::Error if a file is not as above.
Texts read_texts(const std::filesystem::path& folder);

}  // namespace grader::door
