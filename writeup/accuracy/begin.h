#pragma once

#include "pt/render/progress.h"
#include "pt/scene/load_collada.h"
#include "writeup/accuracy/options.h"
#include "writeup/accuracy/study.h"

namespace writeup::accuracy {

// A scene that is being measured: loaded, ready to be traced, and with its long renders made. Each
// member uses those before it. Throws pt::Error, one sentence, for what cannot be measured.
struct Measuring {
  // Makes the folder of --out. `bounces`: as Study has it.
  Measuring(const Options& options, int bounces);
  Measuring(const Measuring&) = delete;
  Measuring& operator=(const Measuring&) = delete;

  const pt::LoadedScene loaded;
  const pt::View view;
  pt::Progress progress;
  Study study;
};

// The exit status for main: 2 after one sentence where `run` throws.
int run_program(int (*run)(int, const char* const*), int argc, const char* const* argv);

}  // namespace writeup::accuracy
