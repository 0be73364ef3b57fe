#pragma once

#include "grader/pictures/name_mistake.h"
#include "grader/results/results.h"

#include <filesystem>

namespace grader::pictures {

// Compares a judged picture with known mistakes, by the files that it names.
JudgedPicture judged_picture(const results::PictureResult& result);

// The same of the golden that it names.
BlockMeans golden_means(const results::PictureResult& result);

// The beginning of the hash in the provenance of a golden, GOLDEN.json beside GOLDEN.exr.
std::string recipe_hash(const std::filesystem::path& golden);

// Returns which known mistakes of the task make such a picture, and which do not; none of either for a
// picture that fails without the reference elsewhere.
Likeness likeness_of(const results::PictureResult& result,
                     const std::vector<KnownMistake>& mistakes);

}  // namespace grader::pictures
