#pragma once

#include "pt/scene/load_collada.h"
#include "writeup/accuracy/options.h"

namespace writeup::accuracy {

// The scene, ready to be traced. Makes the folder of --out. Throws pt::Error, one sentence, for what
// cannot be measured.
pt::LoadedScene load_scene(const Options& options);

// Prints the loader's notes to standard error.
void print_notes(const pt::LoadedScene& loaded);

// The exit status for main: 2 after one sentence where `run` throws.
int run_program(int (*run)(int, const char* const*), int argc, const char* const* argv);

}  // namespace writeup::accuracy
