#pragma once

#include "grader/judge/builder.h"
#include "grader/judge/grade.h"
#include "grader/pictures/recipes.h"

namespace grader::judge {

// A few rows of a picture may take so many times the limit of a call.
inline constexpr int kPatience = 5;

// One recipe on one worker.
struct PictureTrial {
  const pictures::Recipe& recipe;
  const TaskConfig& task;
  const Built& worker;
  std::string content;  // stands for what of the submission is judged; the same on every machine
  bool integrated = false;
  int rounds = 3;  // at most
  int patience = kPatience;
};

// Runs the program graded_picture, unless the same was run before. Safe from any thread. Throws
// pt::Error if that program cannot judge, as without a golden.
results::PictureResult try_picture(const Config& config, const Builder& builder,
                                   const GradeRequest& request, const PictureTrial& trial);

}  // namespace grader::judge
