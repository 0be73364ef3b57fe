#include "writeup/work.h"

#include "grader/base/parallel.h"
#include "grader/base/printable.h"
#include "grader/service/process/cause_of_end.h"
#include "grader/service/process/run_command.h"

#include <algorithm>
#include <chrono>
#include <future>
#include <mutex>
#include <set>

#include <fmt/format.h>
#include <sys/wait.h>

namespace writeup {

namespace fs = std::filesystem;

namespace {

constexpr double kBandSeconds = 5;  // short enough that the processors end at about the same time
constexpr std::size_t kMaxReason = 600;

struct Job {
  const Unit* unit;
  measure::Band band;
  double seconds;  // estimated, of all its rows
};

}  // namespace

std::string reason_of(const grader::process::CommandResult& result, double limit) {
  if (result.timed_out) {
    return fmt::format("stopped after {:.0f} s: an endless loop, or very slow", limit);
  }
  const std::string words = grader::base::printable(result.output, kMaxReason, true);
  if (WIFEXITED(result.status)) {
    return words.empty() ? grader::process::describe_status(result.status) : words;
  }
  return "crashed: " + grader::process::cause_of_end(result.status, words);
}

namespace {

class Workshop {
 public:
  Workshop(const Store& store, const std::vector<Unit>& units, const WorkSettings& settings)
      : store_(store), settings_(settings) {
    for (const Unit& unit : units) {
      if (!store.is_settled(unit)) add(unit);
    }
    std::stable_sort(jobs_.begin(), jobs_.end(),
                     [](const Job& a, const Job& b) { return a.seconds > b.seconds; });
  }

  void run() {
    if (jobs_.empty()) return;
    std::future<void> all = std::async(std::launch::async, [this] {
      grader::base::for_each(jobs_.size(), settings_.threads,
                             [this](std::size_t i) { work(jobs_[i]); });
    });
    while (all.wait_for(std::chrono::milliseconds(50)) != std::future_status::ready) {
      if (settings_.progress) settings_.progress(part_done());
    }
    all.get();
  }

 private:
  void add(const Unit& unit) {
    const double seconds = store_.seconds(unit);
    for (const measure::Band& band : store_.begin(unit, static_cast<int>(seconds / kBandSeconds))) {
      const double share = static_cast<double>(band.rows) / unit.spec.height;
      total_ += seconds * share;
      if (fs::exists(band.done())) {
        done_ += seconds * share;
      } else {
        jobs_.push_back({&unit, band, seconds * share});
      }
    }
  }

  double part_done() {
    const std::lock_guard lock(mutex_);
    double done = done_;
    for (const Job* job : running_) {
      done += job->seconds * measure::rows_in(job->band.file(), job->unit->spec.row_pixels()) /
              job->band.rows;
    }
    return std::min(done / total_, 0.999);
  }

  void work(const Job& job) {
    {
      const std::lock_guard lock(mutex_);
      running_.insert(&job);
    }
    render(job);
    const std::lock_guard lock(mutex_);
    running_.erase(&job);
    done_ += job.seconds;
  }

  void render(const Job& job) const {
    if (!store_.failure(*job.unit).empty()) return;
    std::vector<std::string> words = job.unit->code->command;
    words.push_back((job.band.folder / "spec.json").string());
    words.push_back((job.band.folder / job.band.name()).string());
    const double limit = std::max(settings_.least_seconds, settings_.patience * job.seconds);
    const auto milliseconds = std::chrono::milliseconds(static_cast<long long>(1000 * limit));
    const grader::process::CommandResult result = grader::process::run_command(
        {words, {"PATH=/usr/bin:/bin", "LANG=C.UTF-8"}, {}, "", {}}, milliseconds);
    if (!result.ok()) {
      store_.fail(*job.unit, reason_of(result, limit));
    } else if (store_.is_complete(*job.unit)) {
      store_.remember_seconds(*job.unit);
    }
  }

  const Store& store_;
  const WorkSettings& settings_;
  std::vector<Job> jobs_;
  std::mutex mutex_;
  std::set<const Job*> running_;
  double total_ = 0, done_ = 0;
};

}  // namespace

void make(const Store& store, const std::vector<Unit>& units, const WorkSettings& settings) {
  Workshop(store, units, settings).run();
}

}  // namespace writeup
