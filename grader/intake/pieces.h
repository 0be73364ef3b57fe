#pragma once

#include "grader/intake/handed_in.h"
#include "grader/intake/settle.h"

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

// The submission that they are together: of resubmissions the last, in a folder of their own.
HandedIn gathered(Pieces pieces, const Means& means);

}  // namespace grader::intake
