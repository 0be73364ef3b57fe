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

// Returns a submission with this folder, problem and note.
HandedIn with(HandedIn by, const Prepared& prepared);

// Makes one submission: the last version of each file of all attempts.
HandedIn one_submission(Pieces pieces, const IntakeTools& tools);

}  // namespace grader::intake
