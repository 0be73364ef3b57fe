#pragma once

#include "measure/scene/options.h"
#include "measure/scene/study.h"
#include "pt/render/progress.h"

namespace measure::scene {

// A scene for measuring, ready to be traced and with finished long renders. Each member uses the
// members before it. Throws pt::Error, one sentence, if it cannot be measured.
struct Measuring {
  // `bounces` is for Study, which may take the part `share` of the time; `program` is this one, beside which
  // the reference's program is looked for if the options want it.
  Measuring(pt::LoadedScene scene, const Options& options, int bounces, double share = 1,
            const std::string& program = {});
  Measuring(const Measuring&) = delete;
  Measuring& operator=(const Measuring&) = delete;

  const pt::LoadedScene loaded;
  const pt::View view;
  // Without a share, `clock` shows the progress.
  pt::Progress progress;
  pt::TimedProgress clock{"a first look at the scene"};
  Study study;
};

// Runs the command: prints its results, and writes the files of --out. Returns the exit status: 1 if the code is so
// wrong beside the reference that there is no answer.
int run_call(const Call& call);

}  // namespace measure::scene
