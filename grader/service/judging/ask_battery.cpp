#include "grader/service/judging/ask_battery.h"

#include "grader/base/files.h"
#include "grader/base/sha256.h"
#include "grader/service/build/cache.h"
#include "grader/service/process/run_command.h"
#include "grader/service/sandbox/box.h"
#include "pt/file.h"

#include <filesystem>

namespace grader::judging {

namespace {

// Far longer than a battery takes.
constexpr std::chrono::seconds kBatteryTime{600};

}  // namespace

std::optional<mistakes::Answers> ask_battery(const build::Builder& builder, const Trial& trial,
                                             std::uint64_t seed, int draws) {
  const Written written =
      ask_program(builder, trial.task.graded, trial,
                  {"--seed", std::to_string(seed), "--draws", std::to_string(draws), "--battery"},
                  kBatteryTime);
  if (written.path.empty()) return std::nullopt;
  try {
    return mistakes::answers_from_json(pt::read_file(written.path));
  } catch (const std::exception&) {
    std::filesystem::remove(written.path);  // damaged: the next run makes it again
    return std::nullopt;
  }
}

namespace fs = std::filesystem;

Written ask_program(const build::Builder& builder, const std::string& program, const Trial& trial,
                    const std::vector<std::string>& words, std::chrono::seconds most) {
  std::vector<std::string> command{program, "--worker", trial.worker.path, "--isolation",
                                   std::string(1, sandbox::letter(trial.request.isolation.tier))};
  command.insert(command.end(), words.begin(), words.end());
  std::string key = build::content_stamp(program, builder.cache()) + trial.worker.key;
  for (const std::string& word : command) key += '\0' + word;
  const std::string path = builder.cache() + "/" + base::sha256(key) + ".json";
  if (!fs::exists(path)) {
    const std::string temporary = pt::temporary_name(path);
    command.push_back(temporary);
    const process::CommandResult result =
        process::run_command({command, sandbox::judges_environment(), {}, "", {}}, most);
    if (!result.ok() || !fs::exists(temporary)) {
      fs::remove(temporary);
      return {"", result.output};
    }
    fs::rename(temporary, path);
  }
  build::mark_used(path);
  return {path, ""};
}

}  // namespace grader::judging
