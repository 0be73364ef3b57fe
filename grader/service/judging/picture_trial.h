#pragma once

#include "grader/pictures/recipes/recipes.h"
#include "grader/service/build/builder.h"
#include "grader/service/judging/grade.h"

namespace grader::judging {

// One recipe on one worker.
struct PictureTrial {
  const pictures::Recipe& recipe;
  const build::TaskConfig& task;
  const build::Built& worker;
  std::string content;  // a hash of the judged files; equal on every machine
  bool integrated = false;
  // Then there is one round, and little time: a wrong task may visit every box of a large tree.
  bool known_wrong = false;
};

// A recipe's result before it is rendered, and one that says why there is no picture.
results::PictureResult not_judged(const pictures::Recipe& recipe);
results::PictureResult without_picture(const pictures::Recipe& recipe, results::State state,
                                       const std::string& why);

// Runs the program graded_picture, unless the cache has its result. Safe from any thread. Throws
// pt::Error if the program cannot judge, for example without a golden.
results::PictureResult try_picture(const build::Config& config, const build::Builder& builder,
                                   const GradeRequest& request, const PictureTrial& trial);

}  // namespace grader::judging
