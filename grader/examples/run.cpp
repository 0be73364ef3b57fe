#include "grader/examples/run.h"

#include "grader/base/descriptor.h"
#include "grader/base/printable.h"
#include "grader/base/wrap.h"
#include "grader/service/process/run_command.h"
#include "pt/error.h"

#include <algorithm>
#include <cstdlib>
#include <sstream>

#include <fmt/format.h>
#include <unistd.h>

namespace grader::examples {

namespace {

// Far more than any file has.
constexpr std::size_t kMaxExamples = 1000;
constexpr int kMaxTooLong = 3;

process::CommandResult start(const Program& program, const std::string& input) {
  base::Pipe pipe = base::make_pipe();
  // A pipe takes this much at once.
  if (write(pipe.write_end.number(), input.data(), input.size()) < 0) {
    throw pt::Error("the numbers of the examples cannot be written to a pipe");
  }
  pipe.write_end.close();
  sandbox::Box box = sandbox::box_of_functions(program.path, 30);
  box.descriptors = {pipe.read_end.number()};
  return process::run_command(sandbox::boxed(box, program.tier), program.most);
}

// Reads the lines of the program. Returns the example that was running at its end, if one was.
std::optional<std::size_t> read_lines(const std::string& output, Run& run) {
  std::vector<std::string> names;
  std::optional<std::size_t> running;
  for (const std::string& line : base::lines_of(output)) {
    std::istringstream words(line);
    std::string word, rest;
    words >> word >> std::ws;
    std::getline(words, rest);
    rest = base::printable(rest, 300);
    if (word == "example" && names.size() < kMaxExamples) names.push_back(rest);
    if (names.size() > run.names.size()) {
      run.names = names;
      run.outcomes.resize(names.size());
    }
    if (word == "runs") {
      const std::size_t number = std::strtoul(rest.c_str(), nullptr, 10);
      if (number < run.outcomes.size()) running = number;
    } else if (running && word == "holds") {
      run.outcomes[*running] = {Outcome::Kind::holds, "", std::atoi(rest.c_str())};
      running.reset();
    } else if (running && word == "fails") {
      run.outcomes[*running] = {Outcome::Kind::fails, rest};
      running.reset();
    } else if (word == "todo") {
      run.todo.push_back(rest);
    }
  }
  return running;
}

// The outcome of the example that was running when the program ended.
Outcome outcome_of(const process::CommandResult& result, std::chrono::milliseconds most) {
  using Seconds = std::chrono::duration<double>;
  if (result.timed_out)
    return {Outcome::Kind::too_long,
            fmt::format("it does not end in {:g} s of processor time", Seconds(most).count())};
  const std::string how = process::describe_status(result.status);
  return {Outcome::Kind::ends, "the program ended while it ran (" + how + ")"};
}

std::string numbers(const std::vector<std::size_t>& all) {
  std::string text;
  for (const std::size_t number : all) text += std::to_string(number) + ' ';
  return text;
}

}  // namespace

Run run_examples(const Program& program, std::optional<std::size_t> solution,
                 const std::optional<std::vector<std::size_t>>& only, bool until_one_fails) {
  Run run;
  std::vector<std::size_t> left;
  if (only) {
    left = *only;
  } else {
    for (std::size_t i = 0; i < kMaxExamples; ++i) left.push_back(i);
  }
  const std::string first =
      (solution ? std::to_string(*solution) + '\n' : "") + (until_one_fails ? "! " : "");
  for (int too_long = 0; too_long < kMaxTooLong;) {
    const process::CommandResult result = start(program, first + numbers(left));
    const std::optional<std::size_t> running = read_lines(result.output, run);
    if (!running) {
      if (run.names.empty() && !result.ok())
        run.fault = result.timed_out ? "it does not end" : process::describe_status(result.status);
      return run;
    }
    const auto at = std::ranges::lower_bound(left, *running);
    // The examples before it have used a part of the time: it gets all of it.
    const bool was_alone = at == left.begin();
    left.erase(left.begin(), result.timed_out && !was_alone ? at : at + 1);
    if (result.timed_out && !was_alone) continue;
    run.outcomes[*running] = outcome_of(result, program.most);
    too_long += result.timed_out ? 1 : 0;
    if (until_one_fails) return run;
  }
  return run;
}

}  // namespace grader::examples
