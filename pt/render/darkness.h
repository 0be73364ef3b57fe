#pragma once

#include "pt/image/film.h"
#include "pt/scene/view.h"

#include <string>

namespace pt {

// Says why nothing can be seen in a picture at that exposure, and what to do; empty if something
// can. The scene has a light.
std::string note_on_darkness(const View& view, const Film& film, double exposure);

}  // namespace pt
