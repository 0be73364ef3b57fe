#pragma once

#include "grader/service/wire/session.h"

#include <cstdint>
#include <functional>

namespace CLI {
class App;
}

namespace grader::wire {

// The worker that a program of one task (graded.<slug>, stability.<slug>) calls, and the seed of its inputs.
struct AskOptions {
  SessionSettings session;
  std::uint64_t seed = 1;
};

// Runs a program of one task: adds their common options (--worker, --isolation, --call-limit,
// --integrated, --seed), reads the command line into `ask`, and then calls `run`, whose result is
// the exit status. Trusted: no line of a submission runs in this process, and the worker's process
// cannot see it. If the machine is at fault, the program ends with exit status 2.
int run_asking(CLI::App& app, int argc, char** argv, AskOptions& ask,
               const std::function<int()>& run);

}  // namespace grader::wire
