#pragma once

#include "grader/judge/config.h"
#include "grader/judge/grade.h"
#include "grader/mistakes/naming.h"

#include <filesystem>

// The answers of a kept solution, and the promises that it keeps: measured as the judge does.

namespace grader::self_check {

// A file of grader/tasks/<task>/{wrong,right}/, the reference's, or a variation
// (grader/self_check/naming_variations.h).
struct Kept {
  const judge::TaskConfig* task = nullptr;
  std::string kind;  // "wrong", "right", "reference", "variation"
  std::string name;  // of the file; of a variation, the mistake that it makes
  std::string text;

  std::string key() const { return task->slug + "." + kind + "." + name; }
};

// All of a task. Those of `kinds` only.
std::vector<Kept> kept_solutions(const judge::Config& config, const judge::TaskConfig& task,
                                 const std::vector<std::string>& kinds);

// The measurements of one of them.
struct MeasuredSolution {
  std::string source, battery, properties;  // hashes of what it depends on
  mistakes::Answers answers;                // with many draws
  mistakes::Evidence
      trial;  // as a submission gives it: other draws, and the promises at the default seed
  std::vector<std::string> broken, unsure;  // of all seeds
};

enum class Extent {
  trial,  // what a check of names needs; nothing is stored
  all,
};

// Resumable: a measurement in the folder `store` that depends on nothing that changed is not made
// again. Throws pt::Error if the solution does not compile or link, or the audit rejects it.
MeasuredSolution measure(const judge::Config& config, const judge::GradeRequest& request,
                         const Kept& kept, const std::string& store, Extent extent);

// The hashes of the files of a task's battery, and of those of its properties.
std::string battery_hash(const std::string& root, const std::string& slug);
std::string properties_hash(const std::string& root, const std::string& slug);

// The sentence of a wrong solution that says the mistake: the comment below its first line.
std::string sentence_of(const std::string& text);

}  // namespace grader::self_check
