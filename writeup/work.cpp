#include "writeup/work.h"

#include "grader/base/printable.h"
#include "grader/process/cause_of_end.h"
#include "grader/process/run_command.h"

#include <algorithm>
#include <atomic>
#include <mutex>
#include <set>
#include <thread>

#include <fmt/format.h>
#include <sys/wait.h>

namespace writeup {

namespace fs = std::filesystem;

namespace {

constexpr double kBandSeconds = 10;  // short enough that the processors end at about the same time
constexpr std::size_t kMaxReason = 600;

struct Job {
  const Unit* unit;
  Band band;
  double seconds;  // estimated, of all its rows
};

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
    std::atomic<int> working = settings_.threads;
    std::vector<std::jthread> threads;
    for (int i = 0; i < settings_.threads; ++i) {
      threads.emplace_back([&] {
        work();
        --working;
      });
    }
    while (working > 0) {
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
      if (settings_.progress) settings_.progress(part_done());
    }
  }

 private:
  void add(const Unit& unit) {
    const double seconds = store_.seconds(unit);
    for (const Band& band : store_.begin(unit, static_cast<int>(seconds / kBandSeconds))) {
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
      done +=
          job->seconds * rows_in(job->band.file(), job->unit->spec.row_pixels()) / job->band.rows;
    }
    return std::min(done / total_, 0.999);
  }

  void work() {
    for (std::size_t i = next_++; i < jobs_.size(); i = next_++) {
      const Job& job = jobs_[i];
      {
        const std::lock_guard lock(mutex_);
        running_.insert(&job);
      }
      render(job);
      const std::lock_guard lock(mutex_);
      running_.erase(&job);
      done_ += job.seconds;
    }
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
  std::atomic<std::size_t> next_ = 0;
  std::mutex mutex_;
  std::set<const Job*> running_;
  double total_ = 0, done_ = 0;
};

}  // namespace

void make(const Store& store, const std::vector<Unit>& units, const WorkSettings& settings) {
  Workshop(store, units, settings).run();
}

}  // namespace writeup
