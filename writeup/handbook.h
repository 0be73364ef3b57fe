#pragma once

#include "writeup/plan.h"

#include <filesystem>
#include <string>
#include <vector>

// The pictures that are kept with the project: of the handbook, the README and the four bugs
// (handbook.json). They are made like figures, and copied to the places that show them.

namespace writeup {

// The reasons why figures have no picture, or a wrong picture: a sentence each.
using Problems = std::vector<std::string>;

// Writes the picture of each figure to its file below the folder, unless the file already has it.
Problems write_handbook(const Plan& plan, const std::vector<const Figure*>& figures,
                        const std::filesystem::path& folder);

// Compares the pictures with the files below the folder. A file next to them that is not in the
// plan is a problem, too.
Problems check_handbook(const Plan& plan, const Catalogue& catalogue,
                        const std::vector<const Figure*>& figures,
                        const std::filesystem::path& folder);

}  // namespace writeup
