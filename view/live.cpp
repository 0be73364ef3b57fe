#include "view/live.h"

#include "grader/service/process/run_command.h"

#include <chrono>
#include <map>
#include <sstream>
#include <thread>

namespace view {

namespace {

namespace fs = std::filesystem;
using Times = std::map<fs::path, fs::file_time_type>;

// Editors replace files, so one of them may be gone for a moment.
Times times_of(const fs::path& folder) {
  Times times;
  std::error_code gone;
  for (const auto& entry : fs::recursive_directory_iterator(folder, gone)) {
    if (entry.path().extension() != ".cpp") continue;
    const auto time = entry.last_write_time(gone);
    if (!gone) times[entry.path()] = time;
  }
  return times;
}

std::string first_error(const std::string& output) {
  std::istringstream lines(output);
  for (std::string line; std::getline(lines, line);) {
    if (line.find("error:") != std::string::npos ||
        line.find("undefined reference") != std::string::npos) {
      return line;
    }
  }
  return "the build failed: " + output.substr(0, 300);
}

}  // namespace

Live::Live(fs::path tasks, std::vector<std::string> command, Child& child)
    : tasks_(std::move(tasks)),
      command_(std::move(command)),
      child_(child),
      watching_(std::async(std::launch::async, [this] { watch(); })) {}

Live::State Live::state() {
  const std::lock_guard lock(reading_);
  return state_;
}

void Live::compile() {
  grader::process::Child build;
  build.command = command_;
  build.environment = grader::process::own_environment();
  const auto result = grader::process::run_command(build, grader::process::kProgramTime, &is_over_);
  if (result.ok()) child_.restart();
  const std::lock_guard lock(reading_);
  ++state_.saves;
  state_.error = result.ok() ? "" : first_error(result.output);
}

void Live::watch() {
  constexpr std::chrono::milliseconds kPause{50};
  Times compiled = times_of(tasks_), before = compiled;
  while (!is_over_) {
    std::this_thread::sleep_for(kPause);
    const Times now = times_of(tasks_);
    const bool is_settled = now == before;
    before = now;
    if (now == compiled || !is_settled) continue;
    compiled = now;
    try {
      compile();
    } catch (const std::exception& error) {
      const std::lock_guard lock(reading_);
      ++state_.saves;
      state_.error = error.what();
    }
  }
}

}  // namespace view
