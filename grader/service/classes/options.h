#pragma once

#include "grader/service/classes/engine.h"
#include "grader/service/classes/plan.h"

#include <cstddef>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace grader::classes {

// The options of `grade_class` and of its steps.
struct ClassOptions {
  PlanRequest plan;
  EngineRequest engine;
  std::string config;
  std::vector<std::size_t> numbers;  // of the chunks to judge
  bool not_isolated = false;
  bool end_with_parent = false;
};

// Each function adds options to the command line; they fill in `options`, which must outlive it.
void describe_class(CLI::App& app,
                    ClassOptions& options);  // for all steps: the plan and the engine
void describe_plan(CLI::App& app, ClassOptions& options);
void describe_chunk(CLI::App& app, ClassOptions& options);
void describe_collect(CLI::App& app, ClassOptions& options);

}  // namespace grader::classes
