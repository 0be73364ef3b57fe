#include "grader/service/judging/picture_trial.h"

#include "grader/base/sha256.h"
#include "grader/results/json.h"
#include "grader/service/build/cache.h"
#include "grader/service/judging/findings.h"
#include "grader/service/process/cause_of_end.h"
#include "grader/service/process/run_command.h"
#include "grader/service/sandbox/box.h"
#include "pt/error.h"
#include "pt/file.h"

#include <filesystem>

#include <fmt/format.h>
#include <sys/wait.h>

namespace grader::judging {

namespace {

namespace fs = std::filesystem;

// A few rows of a picture may take this many times the limit of a call.
constexpr int kPatience = 5;

std::vector<std::string> command(const build::Config& config, const GradeRequest& request,
                                 const PictureTrial& trial) {
  std::vector<std::string> words{
      config.picture,
      "--worker",
      trial.worker.path,
      "--task",
      trial.task.slug,
      "--recipes",
      config.root + "/scenes/recipes.json",
      "--goldens",
      config.root + "/golden",
      "--recipe",
      trial.recipe.name,
      "--content",
      base::sha256(trial.content),
      "--seed",
      std::to_string(request.seed),
      "--rounds",
      trial.known_wrong ? "1" : "3",
      "--call-limit",
      std::to_string((trial.known_wrong ? 1 : kPatience) * request.call_limit),
      "--isolation",
      std::string(1, sandbox::letter(request.isolation.tier))};
  if (trial.integrated) words.push_back("--integrated");
  return words;
}

// Everything that the verdict depends on.
std::string key_of(const build::Config& config, const std::string& cache,
                   const std::vector<std::string>& words, const PictureTrial& trial) {
  std::string key = build::content_stamp(config.picture, cache) + trial.worker.key +
                    build::content_stamp(trial.recipe.scene, cache) +
                    build::content_stamp(config.root + "/scenes/recipes.json", cache);
  const std::string golden = config.root + "/golden/" + trial.recipe.name;
  for (const char* ending : {".exr", "_rates.json"}) {
    if (fs::exists(golden + ending)) key += build::content_stamp(golden + ending, cache);
  }
  for (const std::string& word : words) key += '\0' + word;
  return base::sha256(key);
}

results::PictureResult read_picture(const std::string& path) {
  return results::read_results(path).tasks.at(0).pictures.at(0);
}

// Runs the program, which writes the file.
results::PictureResult run_program(std::vector<std::string> words, const std::string& path,
                                   const PictureTrial& trial) {
  words.insert(words.end(), {"--report", path});
  const process::CommandResult run = process::run_command(
      {words, sandbox::judges_environment(), {}, "", {}}, process::kProgramTime);
  if (run.timed_out || WIFSIGNALED(run.status)) {
    const auto [state, why] = ended_by_answers(run);
    return without_picture(trial.recipe, state, why);
  }
  if (WEXITSTATUS(run.status) > 1) {
    throw pt::Error(fmt::format("the picture {} could not be judged: {}", trial.recipe.name,
                                process::fault_of(run)));
  }
  return read_picture(path);
}

}  // namespace

results::PictureResult not_judged(const pictures::Recipe& recipe) {
  results::PictureResult result;
  result.recipe = recipe.name;
  result.title = recipe.title;
  result.width = recipe.width;
  result.height = recipe.height;
  return result;
}

results::PictureResult without_picture(const pictures::Recipe& recipe, results::State state,
                                       const std::string& why) {
  results::PictureResult result = not_judged(recipe);
  result.state = state;
  result.text = why;
  return result;
}

results::PictureResult try_picture(const build::Config& config, const build::Builder& builder,
                                   const GradeRequest& request, const PictureTrial& trial) {
  const std::vector<std::string> words = command(config, request, trial);
  const std::string path =
      builder.cache() + "/" + key_of(config, builder.cache(), words, trial) + ".picture.json";
  const bool known = fs::exists(path);
  results::PictureResult result = known ? read_picture(path) : run_program(words, path, trial);
  if (!known && process::was_killed(result.text)) result = run_program(words, path, trial);
  build::mark_used(path);
  result.replay = replay_command(request, trial.task.slug);
  // Time and memory depend on the machine's load, so the next request tries again.
  if (result.state == results::State::timeout || process::was_killed(result.text)) fs::remove(path);
  return result;
}

}  // namespace grader::judging
