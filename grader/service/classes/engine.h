#pragma once

#include "grader/service/classes/one.h"
#include "grader/service/classes/plan.h"

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

// The engines that run the chunks of a plan: this process, GNU parallel or Slurm.

namespace grader::classes {

// Judges all submissions of one chunk, `jobs` at a time. `report` is called with each outcome, by
// one thread at a time.
using Report = std::function<void(std::size_t i, const Graded& graded)>;
void run_chunk(const Judging& judging, const ClassPlan& plan, const Chunk& chunk, int jobs,
               const Report& report);

enum class Engine { local, parallel, slurm };

struct EngineRequest {
  Engine engine = Engine::local;
  int jobs = 0;                      // at a time; 0: one per processor, or as the cluster allows
  std::vector<std::string> options;  // words for parallel or sbatch
  std::vector<std::string> program;  // the command for a chunk; folder and number are added
};

// The command line that runs the chunks with these numbers (from 1 on), and waits for them.
std::vector<std::string> engine_command(const EngineRequest& request, const std::string& out,
                                        const std::vector<std::size_t>& numbers);

// Runs all unfinished chunks. If a process is killed, its remaining work is tried again, at most
// twice. <out>/engine.log has the output of GNU parallel and sbatch. Throws pt::Error if they are
// missing or fail to start.
void run_plan(const Judging& judging, const ClassPlan& plan, const EngineRequest& request,
              const Report& report);

}  // namespace grader::classes
