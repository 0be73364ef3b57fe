#pragma once

#include "pt/render/progress.h"
#include "writeup/accuracy/load.h"
#include "writeup/accuracy/study.h"

namespace writeup::accuracy {

// A scene that is being measured: loaded, ready to be traced, and with its long renders made. Each
// member uses those before it. Throws pt::Error, one sentence, for what cannot be measured.
struct Measuring {
  // Makes the folder of --out. `bounces`: as Study has it, which may take `share` of the time.
  Measuring(const Options& options, int bounces, double share = 1);
  Measuring(const Measuring&) = delete;
  Measuring& operator=(const Measuring&) = delete;

  const pt::LoadedScene loaded;
  const pt::View view;
  pt::Progress progress;
  Study study;
};

}  // namespace writeup::accuracy
