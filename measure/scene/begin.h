#pragma once

#include "measure/scene/converge.h"
#include "measure/scene/options.h"
#include "measure/scene/study.h"
#include "pt/render/progress.h"

#include <functional>
#include <string>
#include <vector>

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

// Code that can be measured one after the other: `open` makes it that which renders from then on.
struct Subject {
  std::string name;
  std::function<void()> open;
};

// Runs the command: prints its results, and writes the files of --out. Returns the exit status: 1 if the code is so
// wrong beside the reference that there is no answer, or if one of `several` cannot be measured.
int run_call(const Call& call, const std::vector<Subject>& several = {});

// Measures each of the codes as `converge` does, and compares them. Returns the exit status.
int run_several(const Call& call, const std::vector<Subject>& several);

// Makes, prints and writes the curves of the code that renders now.
struct Converged {
  std::vector<MethodCurve> curves;
  double cpu_seconds = 0;
};
Converged run_converge(const Call& call);

}  // namespace measure::scene
