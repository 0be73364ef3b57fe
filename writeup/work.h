#pragma once

#include "grader/process/run_command.h"
#include "writeup/store.h"

#include <functional>
#include <vector>

namespace writeup {

struct WorkSettings {
  int threads = 1;
  double least_seconds = 20;             // of processor time, that a render may take
  double patience = 20;                  // times its estimate, if that is more
  std::function<void(double)> progress;  // the part done
};

// A sentence on a program that did not end well within `limit` seconds.
std::string reason_of(const grader::process::CommandResult& result, double limit);

// Makes all renders that are not there, several at a time, the longest first. One that crashes or
// takes too long leaves its reason in the store, and the others go on.
void make(const Store& store, const std::vector<Unit>& units, const WorkSettings& settings);

}  // namespace writeup
