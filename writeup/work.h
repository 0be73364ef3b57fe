#pragma once

#include "grader/service/process/run_command.h"
#include "writeup/store.h"

#include <functional>
#include <vector>

namespace writeup {

struct WorkSettings {
  int threads = 1;
  double least_seconds = 20;             // processor time that every render may take
  double patience = 20;                  // or this multiple of its estimate, if that is more
  std::function<void(double)> progress;  // the part done
};

// A sentence about a program that failed, or did not end within `limit` seconds.
std::string reason_of(const grader::process::CommandResult& result, double limit);

// Makes all renders that are not there, several at a time, the longest first. One that crashes or
// takes too long leaves its reason in the store, and the others go on.
void make(const Store& store, const std::vector<Unit>& units, const WorkSettings& settings);

}  // namespace writeup
