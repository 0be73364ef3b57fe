#pragma once

#include "grader/service/intake/handed_in.h"
#include "grader/service/intake/prepare_submission.h"

#include <filesystem>
#include <vector>

namespace grader::intake {

// A file or folder of a learner.
struct Piece {
  std::filesystem::path path;
  Label label;
};

struct Pieces {
  HandedIn by;
  std::vector<Piece> all;
};

// Makes one submission: the last folder, or a new one with the last version of each file.
HandedIn one_submission(Pieces pieces, const IntakeTools& tools);

}  // namespace grader::intake
