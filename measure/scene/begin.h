#pragma once

#include "measure/scene/options.h"
#include "measure/scene/study.h"
#include "pt/render/progress.h"

namespace measure::scene {

// A scene for measuring, ready to be traced and with finished long renders. Each member uses the
// members before it. Throws pt::Error, one sentence, if it cannot be measured.
struct Measuring {
  // `bounces` is for Study, which may take the part `share` of the time.
  Measuring(pt::LoadedScene scene, const Options& options, int bounces, double share = 1);
  Measuring(const Measuring&) = delete;
  Measuring& operator=(const Measuring&) = delete;

  const pt::LoadedScene loaded;
  const pt::View view;
  // Without a share, `clock` shows the progress.
  pt::Progress progress;
  pt::TimedProgress clock{"a first look at the scene"};
  Study study;
};

// Runs the command: prints its results, and writes the files of --out.
void run_call(const Call& call);

}  // namespace measure::scene
