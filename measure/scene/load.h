#pragma once

#include "measure/scene/options.h"
#include "pt/scene/load_collada.h"

namespace measure::scene {

inline constexpr int kMaxLeaf = 4;  // as in ./run render

// The scene, ready to be traced. Makes the folder of --out. Throws pt::Error, one sentence, if the
// scene cannot be measured.
pt::LoadedScene load_scene(const Options& options);

// Prints the loader's notes to standard error.
void print_notes(const pt::LoadedScene& loaded);

}  // namespace measure::scene
