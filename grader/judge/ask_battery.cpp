#include "grader/judge/ask_battery.h"

#include "grader/base/files.h"
#include "grader/base/sha256.h"
#include "grader/judge/cache.h"
#include "grader/process/run_command.h"
#include "pt/error.h"
#include "pt/file.h"

#include <filesystem>

namespace grader::judge {

namespace {

namespace fs = std::filesystem;

// Far beyond what a battery allows itself.
constexpr std::chrono::seconds kBatteryTime{600};

}  // namespace

std::optional<mistakes::Answers> ask_battery(const Builder& builder, const Trial& trial,
                                             std::uint64_t seed, int draws) {
  std::vector<std::string> command{trial.task.graded,
                                   "--worker",
                                   trial.worker.path,
                                   "--seed",
                                   std::to_string(seed),
                                   "--draws",
                                   std::to_string(draws),
                                   "--isolation",
                                   std::string(1, sandbox::letter(trial.request.isolation.tier)),
                                   "--battery"};
  std::string key = base::stamp(trial.task.graded) + trial.worker.key;
  for (const std::string& word : command) key += '\0' + word;
  const std::string path = builder.cache() + "/" + base::sha256(key) + ".json";
  if (!fs::exists(path)) {
    const std::string temporary = pt::temporary_name(path);
    command.push_back(temporary);
    const process::CommandResult result = process::run_command(
        {command, {"PATH=/usr/bin", "LANG=C.UTF-8"}, {}, "", {}}, kBatteryTime);
    if (!result.ok() || !fs::exists(temporary)) {
      fs::remove(temporary);
      return std::nullopt;
    }
    fs::rename(temporary, path);
  }
  mark_used(path);
  try {
    return mistakes::answers_from_json(base::read_file(path));
  } catch (const std::exception&) {
    fs::remove(path);  // damaged: it is found out again next time
    return std::nullopt;
  }
}

}  // namespace grader::judge
