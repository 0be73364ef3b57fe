#pragma once

#include "writeup/plan.h"

#include <filesystem>
#include <string>
#include <vector>

// The pictures that are kept with the project: of the handbook, the README and the four bugs
// (handbook.json). They are made like figures, and copied to where they are shown.

namespace writeup {

// The reasons why figures have no picture, or a wrong one: a sentence each.
using Problems = std::vector<std::string>;

// Writes the picture of each figure to its file below the folder, where it is not that already.
Problems write_handbook(const Plan& plan, const std::vector<const Figure*>& figures,
                        const std::filesystem::path& folder);

// Compares them with the files below the folder; and every file in the folders of these must be
// one of the plan's.
Problems check_handbook(const Plan& plan, const Catalogue& catalogue,
                        const std::vector<const Figure*>& figures,
                        const std::filesystem::path& folder);

}  // namespace writeup
