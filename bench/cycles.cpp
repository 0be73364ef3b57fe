#include "bench/cycles.h"

#include "grader/service/process/spawn.h"
#include "pt/error.h"
#include "pt/file.h"
#include "pt/image/image_io.h"

#include <csignal>
#include <cstdlib>
#include <fstream>
#include <utility>

#include <fcntl.h>
#include <nlohmann/json.hpp>

namespace pt {

namespace fs = std::filesystem;
using grader::base::Descriptor;

namespace {

// The last line that says what went wrong. Blender prints more lines after it.
std::string last_words(const fs::path& log) {
  std::ifstream file(log);
  std::string line, last;
  while (std::getline(file, line)) {
    if (line.find("Error") != std::string::npos || last.empty()) last = line;
  }
  return last.empty() ? "it printed nothing" : last;
}

grader::process::Child blender_with(const fs::path& blender, const fs::path& folder) {
  grader::process::Child child;
  child.command = {blender.string(),
                   "--background",
                   "--factory-startup",
                   "-noaudio",
                   "--python-exit-code",
                   "3",
                   "--python",
                   FIRSTLIGHT_ROOT "/bench/cycles.py",
                   "--",
                   (folder / "scene.json").string()};
  // Blender's own files stay in the folder, too.
  child.environment = {"PATH=/usr/bin:/bin", "LANG=C.UTF-8", "HOME=" + folder.string()};
  return child;
}

}  // namespace

Cycles::Cycles(const fs::path& blender, const fs::path& folder, const std::string& scene)
    : folder_(folder) {
  write_file(folder / "scene.json", scene);
  const Descriptor log(
      open((folder / "blender.log").c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666));
  if (!log.is_open()) throw Error("cannot write " + (folder / "blender.log").string());
  grader::base::Pipe jobs = grader::base::make_pipe(), answers = grader::base::make_pipe();
  grader::process::Child child = blender_with(blender, folder);
  child.descriptors = {jobs.read_end.number(), log.number(), log.number(),
                       answers.write_end.number()};
  std::signal(SIGPIPE, SIG_IGN);  // if Blender is gone, reading its answer fails
  process_ = grader::process::spawn(child);
  jobs_ = std::move(jobs.write_end);
  answers_.reset(fdopen(dup(answers.read_end.number()), "r"));
  answers.write_end.close();
  const nlohmann::json ready = answer();
  version_ = ready["version"];
  start_seconds_ = ready["seconds"];
}

Cycles::~Cycles() { grader::process::kill_child(process_); }

nlohmann::json Cycles::answer() {
  std::string line;
  for (int c = std::fgetc(answers_.get()); c != EOF && c != '\n'; c = std::fgetc(answers_.get())) {
    line += static_cast<char>(c);
  }
  nlohmann::json parsed = nlohmann::json::parse(line, nullptr, false);
  if (parsed.is_discarded()) {
    throw Error("Blender ended: " + last_words(folder_ / "blender.log"));
  }
  return parsed;
}

TimedImage Cycles::render(int samples, std::uint32_t seed) {
  const fs::path picture = folder_ / "picture.exr";
  const std::string job =
      nlohmann::json{{"samples", samples}, {"seed", seed}, {"picture", picture.string()}}.dump() +
      '\n';
  [[maybe_unused]] const ssize_t written = write(jobs_.number(), job.data(), job.size());
  const double seconds = answer()["seconds"];
  TimedImage result{read_image(picture), seconds};
  fs::remove(picture);
  return result;
}

}  // namespace pt
