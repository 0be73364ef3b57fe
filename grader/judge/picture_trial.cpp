#include "grader/judge/picture_trial.h"

#include "grader/base/files.h"
#include "grader/base/sha256.h"
#include "grader/judge/cache.h"
#include "grader/judge/kept.h"
#include "grader/process/cause_of_end.h"
#include "grader/process/run_command.h"
#include "grader/results/read_json.h"
#include "grader/sandbox/box.h"
#include "pt/error.h"

#include <filesystem>
#include <optional>

#include <fmt/format.h>
#include <sys/wait.h>

namespace grader::judge {

namespace {

namespace fs = std::filesystem;

std::vector<std::string> command(const Config& config, const GradeRequest& request,
                                 const PictureTrial& trial) {
  std::vector<std::string> words{config.picture,
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
                                 std::to_string(trial.rounds),
                                 "--call-limit",
                                 std::to_string(trial.patience * request.call_limit),
                                 "--isolation",
                                 std::string(1, sandbox::letter(request.isolation.tier))};
  if (trial.integrated) words.push_back("--integrated");
  return words;
}

// All that the verdict depends on.
std::string key_of(const Config& config, const std::string& cache,
                   const std::vector<std::string>& words, const PictureTrial& trial) {
  std::string key = content_stamp(config.picture, cache) + trial.worker.key +
                    content_stamp(trial.recipe.scene, cache) +
                    content_stamp(config.root + "/scenes/recipes.json", cache);
  const std::string golden = config.root + "/golden/" + trial.recipe.name;
  for (const char* ending : {".exr", "_rates.json"}) {
    if (fs::exists(golden + ending)) key += content_stamp(golden + ending, cache);
  }
  for (const std::string& word : words) key += '\0' + word;
  return base::sha256(key);
}

std::optional<results::PictureResult> read_picture(const std::string& path) {
  if (!fs::exists(path)) return std::nullopt;
  try {
    return results::results_from_json(base::read_file(path), path).tasks.at(0).pictures.at(0);
  } catch (const std::exception&) {
    fs::remove(path);  // damaged: it is found out again
    return std::nullopt;
  }
}

// The verdict, and what the program writes beside it for the report.
std::vector<std::string> files_of(const std::string& path) {
  const std::string beside = fs::path(path).replace_extension();
  return {path, beside + ".exr", beside + ".evidence.exr", beside + ".csv", beside + ".usual.csv"};
}

// The verdict of an earlier run, if all its files are as they were written: a report could not show a picture that a
// loss of power cut off.
std::optional<results::PictureResult> kept_picture(const std::string& path) {
  if (!are_whole(path, files_of(path))) return std::nullopt;
  return read_picture(path);
}

// Runs the program into the file.
results::PictureResult run_program(std::vector<std::string> words, const std::string& path,
                                   const PictureTrial& trial) {
  words.insert(words.end(), {"--report", path});
  const process::CommandResult run = process::run_command(
      {words, sandbox::judges_environment(), {}, "", {}}, process::kProgramTime);
  if (run.timed_out || !WIFEXITED(run.status) || WEXITSTATUS(run.status) > 1) {
    throw pt::Error(fmt::format("the picture {} could not be judged: {}", trial.recipe.name,
                                process::fault_of(run)));
  }
  std::optional<results::PictureResult> found = read_picture(path);
  if (!found) throw pt::Error(path + " cannot be read");
  return *found;
}

}  // namespace

results::PictureResult try_picture(const Config& config, const Builder& builder,
                                   const GradeRequest& request, const PictureTrial& trial) {
  const std::vector<std::string> words = command(config, request, trial);
  const std::string path =
      builder.cache() + "/" + key_of(config, builder.cache(), words, trial) + ".picture.json";
  const std::optional<results::PictureResult> known = kept_picture(path);
  results::PictureResult result = known ? *known : run_program(words, path, trial);
  if (!known && process::was_killed(result.text)) result = run_program(words, path, trial);
  if (!known) note_sums_of(path, files_of(path));
  mark_used(path);
  result.replay = replay_command(request, trial.task.slug);
  // Time and memory depend on what else the machine does: tried again when it is asked for again.
  if (result.state == results::State::timeout || process::was_killed(result.text)) fs::remove(path);
  return result;
}

}  // namespace grader::judge
