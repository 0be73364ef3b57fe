#pragma once

#include "pt/render/progress.h"
#include "writeup/accuracy/load.h"
#include "writeup/accuracy/study.h"

namespace writeup::accuracy {

// A scene that is being measured: ready to be traced, and with its long renders made. Each member uses
// those before it. Throws pt::Error, one sentence, for what cannot be measured.
struct Measuring {
  // `bounces` is passed on to Study, which may take the part `share` of the time. If a run of the same call
  // was stopped, this one continues there.
  Measuring(pt::LoadedScene scene, const Call& call, int bounces, double share = 1);
  Measuring(const Measuring&) = delete;
  Measuring& operator=(const Measuring&) = delete;

  const pt::LoadedScene loaded;
  const pt::View view;
  pt::Progress progress;
  Study study;
};

// Ctrl-C says from now on that the same command goes on.
void say_when_stopped();

// Runs the command: prints its results, and writes the files of --out.
void run_call(const Call& call);

}  // namespace writeup::accuracy
