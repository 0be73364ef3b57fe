#include "writeup/measurements.h"

#include "grader/base/parallel.h"
#include "grader/base/sha256.h"
#include "grader/service/process/run_command.h"
#include "pt/file.h"
#include "writeup/work.h"

#include <algorithm>
#include <chrono>
#include <future>
#include <mutex>
#include <span>

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

// Returns the measurements in groups, each of which is made at the same time. Curves have errors and
// counts, which do not depend on what else runs; whatever is timed runs alone.
std::vector<std::span<const Measurement>> groups_of(std::span<const Measurement> all) {
  std::vector<std::span<const Measurement>> groups;
  while (!all.empty()) {
    const auto timed = std::ranges::find_if(
        all, [](const Measurement& each) { return each.command != "stability"; });
    const auto curves = static_cast<std::size_t>(timed - all.begin());
    groups.push_back(all.first(std::max<std::size_t>(curves, 1)));
    all = all.subspan(groups.back().size());
  }
  return groups;
}

int at_once(std::span<const Measurement> group, int threads) {
  return std::min(threads, static_cast<int>(group.size()));
}

double seconds_of_group(std::span<const Measurement> group, int threads) {
  double sum = 0;
  for (const Measurement& each : group) sum += each.seconds;
  return sum / at_once(group, threads);
}

}  // namespace

double seconds_by_the_clock(const std::vector<Measurement>& all, int threads) {
  double sum = 0;
  for (const auto group : groups_of(all)) sum += seconds_of_group(group, threads);
  return sum;
}

void make(const Measurements& measurements, const std::vector<Measurement>& missing, int threads,
          const std::function<void(double)>& progress) {
  using Clock = std::chrono::steady_clock;
  const double all = seconds_by_the_clock(missing, threads);
  double done = 0;
  std::mutex mutex;
  std::string stopped;
  const auto make_unless_stopped = [&](const Measurement& each, int its_threads) {
    {
      const std::lock_guard lock(mutex);
      if (!stopped.empty()) {
        measurements.fail(each, "not tried: the measurement of " + stopped + " did not end");
        return;
      }
    }
    if (!make_one(measurements, each, its_threads)) return;
    const std::lock_guard lock(mutex);
    stopped = each.scene.empty() ? each.options.at(0) : fs::path(each.scene).filename().string();
  };
  for (const std::span<const Measurement> group : groups_of(missing)) {
    const Clock::time_point start = Clock::now();
    const int count = at_once(group, threads);
    auto work = std::async(std::launch::async, [&] {
      grader::base::for_each(group.size(), count, [&](std::size_t i) {
        const std::size_t place = grader::base::from_both_ends(i, group.size());
        make_unless_stopped(group[place], threads / count);
      });
    });
    const double expected = seconds_of_group(group, threads);
    while (work.wait_for(std::chrono::milliseconds(100)) != std::future_status::ready) {
      const std::chrono::duration<double> passed = Clock::now() - start;
      progress((done + std::min(passed.count(), expected)) / all);
    }
    work.get();
    done += expected;
  }
}

}  // namespace writeup
