#pragma once

#include "grader/wire/session.h"

#include <cstdint>
#include <functional>

namespace CLI {
class App;
}

namespace grader::programs {

// The worker that a program of one task (graded.<slug>, stability.<slug>) calls, and the seed of its inputs.
struct AskOptions {
  wire::SessionSettings session;
  std::uint64_t seed = 1;
};

// Runs a program of one task: adds the options that are the same in each (--worker, --isolation, --call-limit,
// --integrated, --seed), reads the command line into `ask`, and then calls `run`, whose result is the exit status. Trusted:
// no line of a submission runs in here, and the worker's process sees nothing of this one. If the machine is at
// fault, the program ends with exit status 2.
int run_asking(CLI::App& app, int argc, char** argv, AskOptions& ask,
               const std::function<int()>& run);

}  // namespace grader::programs
