#include "writeup/measurements.h"

#include "grader/base/sha256.h"
#include "grader/service/process/run_command.h"
#include "pt/file.h"
#include "writeup/work.h"

#include <algorithm>
#include <chrono>
#include <future>

#include <sys/wait.h>

namespace writeup {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kMaxMeasured = std::size_t{1} << 24;
constexpr double kMinLimit = 60, kPatience = 10;  // seconds, and times the expected time

fs::path with_ending(const fs::path& folder, const char* ending) {
  return fs::path(folder) += ending;
}

}  // namespace

Measurements::Measurements(fs::path folder, const Store& store)
    : folder_(std::move(folder)), store_(store) {
  fs::create_directories(folder_);
}

std::string Measurements::key(const Measurement& measurement) const {
  std::string text = measurement.command;
  if (!measurement.scene.empty()) text += store_.scene_hash(measurement.scene);
  for (const std::string& word : measurement.options) text += " " + word;
  if (!measurement.depends.empty()) {
    text += measurement.depends;
  } else if (measurement.code != nullptr) {
    for (const auto& [name, content] : measurement.code->hash) text += name + content;
  }
  return grader::base::sha256(text).substr(0, 32);
}

fs::path Measurements::folder(const Measurement& measurement) const {
  return folder_ / key(measurement);
}

nlohmann::json Measurements::load(const Measurement& measurement) const {
  const fs::path file = folder(measurement) / result_of(measurement);
  return nlohmann::json::parse(pt::read_file(file, kMaxMeasured));
}

bool Measurements::is_complete(const Measurement& measurement) const {
  return fs::exists(folder(measurement));
}

std::string Measurements::failure(const Measurement& measurement) const {
  if (measurement.code == nullptr) return "not measured: this build has no program for it";
  if (!measurement.obstacle.empty()) return measurement.obstacle;
  const fs::path file = with_ending(folder(measurement), ".failed");
  return fs::exists(file) ? pt::read_file(file, kMaxMeasured) : "";
}

void Measurements::fail(const Measurement& measurement, const std::string& reason) const {
  pt::write_file(with_ending(folder(measurement), ".failed"), reason);
}

void Measurements::forget_failure(const Measurement& measurement) const {
  fs::remove(with_ending(folder(measurement), ".failed"));
}

double Measurements::cpu_seconds(const Measurement& measurement) const {
  if (measurement.command == "measure" || !is_complete(measurement)) return measurement.seconds;
  return measurement.command == "view" ? 0 : load(measurement).at("cpu_seconds").get<double>();
}

namespace {

std::vector<std::string> words_of(const Measurement& measurement, int threads,
                                  const fs::path& folder) {
  const std::string& command = measurement.command;
  const std::vector<std::string>& program = measurement.code->command;
  std::vector<std::string> words{program.at(0)};
  if (!measurement.scene.empty() && command != "view") words.push_back(command);
  if (!measurement.scene.empty()) words.push_back(measurement.scene);
  words.insert(words.end(), program.begin() + 1, program.end());
  words.insert(words.end(), measurement.options.begin(), measurement.options.end());
  if (command == "view") {
    fs::create_directories(folder);
    words.insert(words.end(), {"--export", folder / Measurements::result_of(measurement)});
    return words;
  }
  // `measure` uses one processor, however many there are.
  if (command != "measure") words.insert(words.end(), {"-t", std::to_string(threads)});
  words.insert(words.end(), {"--out", folder.string()});
  return words;
}

// Makes one measurement. Returns whether it had to be stopped.
bool make_one(const Measurements& measurements, const Measurement& measurement, int threads) {
  const fs::path folder = measurements.folder(measurement);
  const fs::path unfinished = with_ending(folder, ".unfinished");
  fs::remove_all(unfinished);
  const std::vector<std::string> words = words_of(measurement, threads, unfinished);
  const double limit = std::max(kMinLimit, kPatience * measurement.seconds) * threads;
  const auto result =
      grader::process::run_command({words, {"PATH=/usr/bin:/bin", "LANG=C.UTF-8"}, {}, "", {}},
                                   std::chrono::milliseconds(static_cast<long long>(1000 * limit)));
  // Code that is measured and found wrong or crashing ends with 1, and its numbers are there.
  const bool has_numbers = fs::exists(unfinished / Measurements::result_of(measurement));
  const bool judged = WIFEXITED(result.status) && WEXITSTATUS(result.status) == 1 && has_numbers;
  if (result.ok() || (judged && !result.timed_out)) {
    fs::rename(unfinished, folder);
  } else {
    measurements.fail(measurement, reason_of(result, limit));
    fs::remove_all(unfinished);
  }
  return result.timed_out;
}

}  // namespace

void make(const Measurements& measurements, const std::vector<Measurement>& missing, int threads,
          const std::function<void(double)>& progress) {
  using Clock = std::chrono::steady_clock;
  double all = 0, done = 0;
  for (const Measurement& each : missing) all += each.seconds;
  std::string stopped;
  for (const Measurement& each : missing) {
    if (!stopped.empty()) {
      measurements.fail(each, "not tried: the measurement of " + stopped + " did not end");
      continue;
    }
    const Clock::time_point start = Clock::now();
    auto one =
        std::async(std::launch::async, make_one, std::cref(measurements), std::cref(each), threads);
    while (one.wait_for(std::chrono::milliseconds(100)) != std::future_status::ready) {
      const std::chrono::duration<double> passed = Clock::now() - start;
      progress((done + std::min(passed.count(), each.seconds)) / all);
    }
    if (one.get())
      stopped = each.scene.empty() ? each.options.at(0) : fs::path(each.scene).filename().string();
    done += each.seconds;
  }
}

}  // namespace writeup
