#include "grader/service/judging/ask_battery.h"

#include "grader/service/judging/ask_program.h"
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

}  // namespace grader::judging
