#pragma once

#include "grader/intake/handed_in.h"
#include "grader/intake/prepare_submission.h"

#include <filesystem>
#include <vector>

namespace grader::intake {

// One of the files or folders of a learner.
struct Piece {
  std::filesystem::path path;
  Label label;
};

struct Pieces {
  HandedIn by;
  std::vector<Piece> all;
};

// Makes one submission of a learner's files and folders: the last folder, or a new one with the last version of each file.
HandedIn one_submission(Pieces pieces, const IntakeTools& tools);

}  // namespace grader::intake
