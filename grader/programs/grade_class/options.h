#pragma once

#include "grader/programs/grade_class/engine.h"
#include "grader/programs/grade_class/plan.h"

#include <cstddef>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace grader::programs {

// The options of `grade_class` and of its steps.
struct ClassOptions {
  PlanRequest plan;
  EngineRequest engine;
  std::string config;
  std::vector<std::size_t> numbers;  // of chunks
  bool not_isolated = false;
  bool end_with_parent = false;
};

// Each adds to the command line the options that fill in `options`, which has to outlive it.
void describe_class(CLI::App& app,
                    ClassOptions& options);  // for all of it: the plan and the engine
void describe_plan(CLI::App& app, ClassOptions& options);
void describe_chunk(CLI::App& app, ClassOptions& options);
void describe_collect(CLI::App& app, ClassOptions& options);

}  // namespace grader::programs
