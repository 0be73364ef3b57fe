#include "grader/judge/ask_battery.h"

#include "grader/base/files.h"
#include "grader/judge/ask_program.h"

#include <filesystem>

namespace grader::judge {

namespace {

// Far beyond what a battery allows itself.
constexpr std::chrono::seconds kBatteryTime{600};

}  // namespace

std::optional<mistakes::Answers> ask_battery(const Builder& builder, const Trial& trial,
                                             std::uint64_t seed, int draws) {
  const Written written =
      ask_program(builder, trial.task.graded, trial,
                  {"--seed", std::to_string(seed), "--draws", std::to_string(draws), "--battery"},
                  kBatteryTime);
  if (written.path.empty()) return std::nullopt;
  try {
    return mistakes::answers_from_json(base::read_file(written.path));
  } catch (const std::exception&) {
    std::filesystem::remove(written.path);  // damaged: it is found out again next time
    return std::nullopt;
  }
}

}  // namespace grader::judge
