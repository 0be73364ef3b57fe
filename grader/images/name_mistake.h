#pragma once

#include "grader/images/image_verdict.h"
#include "pt/image/film.h"

#include <optional>
#include <span>
#include <string>

namespace grader {

// A mistake that many make, and the picture of a recipe with it (8000 samples a pixel are enough).
struct KnownMistake {
  std::string name;
  pt::Film picture;
};

// The mistake whose picture these batches are, as far as their samples can tell; nothing if the
// nearest is contradicted, or if the golden is not: a wrong hint costs a learner hours. To be asked
// of a picture that failed, with the batches of its last stage. Preconditions: batches that are not
// unusable, all pictures of one size.
std::optional<std::string> name_mistake(const pt::Film& golden, const Batches& batches,
                                        std::span<const KnownMistake> mistakes);

}  // namespace grader
