#pragma once

#include "pt/render/progress.h"
#include "pt/scene/load_collada.h"
#include "writeup/accuracy/options.h"
#include "writeup/accuracy/study.h"

namespace writeup::accuracy {

// What both programs do first and last. All throw pt::Error, one sentence, for what cannot be
// measured.

// The scene, ready to be traced. Makes the folder of --out.
pt::LoadedScene load(const Options& options);

// The picture that is asked for; `loaded` has to stay.
pt::View view_of(const pt::LoadedScene& loaded, const Options& options);

// Begins to measure; `progress` has to stay.
Study begin(const pt::View& view, const Options& options, int bounces, pt::Progress& progress);

// The exit status for main: 2 after one sentence where `run` throws.
int run_program(int (*run)(int, const char* const*), int argc, const char* const* argv);

}  // namespace writeup::accuracy
