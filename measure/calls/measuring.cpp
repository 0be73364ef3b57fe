#include "measure/calls/measuring.h"

#include "measure/calls/conversation.h"
#include "measure/calls/exact.h"
#include "pt/error.h"
#include "pt/sampling/sampler.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <optional>

namespace measure::calls {

namespace {

using Clock = std::chrono::steady_clock;

constexpr double kBatch =
    0.002;  // seconds: long enough for the clock, and far shorter than what disturbs
constexpr double kNoise = 0.35;     // part of an estimator's time, for its noise
constexpr int kFewestBatches = 15;  // even if the time is short
constexpr int kFewestChunks = 8;    // for an estimator's noise
constexpr int kMaxChunks = 2000;
constexpr std::uint32_t kMaxPasses = 1U << 20;

std::uint32_t index_of(const About& about) {
  return static_cast<std::uint32_t>(&about - tasks().data());
}

// A candidate in one case, while it is measured.
struct Runner {
  Row row;
  Request request;
  std::vector<double> nanoseconds, ratios;
  std::vector<double> means, variances;
};

// A candidate: its workers answer for all cases.
struct Player {
  Conversation plain;
  std::optional<Conversation> counted;
  std::vector<Runner> runners;

  // After a crash all its cases are without results.
  void give_up(const std::string& why) {
    for (Runner& runner : runners) runner.row.problem = why;
  }
  bool plays() const { return runners[0].row.problem.empty(); }
};

// Does `work` on the player. A failure becomes a sentence in its rows.
template <class Work>
void attempt(Player& player, Work work) {
  if (!player.plays()) return;
  try {
    work();
  } catch (const NoAnswer& failure) {
    player.give_up(failure.why);
  }
}

// The mean of numbers of tests and rays so far, and the largest errors.
void enter(const Found& found, Runner& runner) {
  Found& all = runner.row.found;
  const auto n = static_cast<double>(runner.means.size());
  for (std::size_t i = 0; i < all.errors.size(); ++i) {
    keep_largest(all.errors[i], found.errors[i]);
  }
  keep_largest(all.wrong, found.wrong);
  for (double Found::*each : {&Found::rays, &Found::boxes, &Found::primitives, &Found::samples}) {
    all.*each += (found.*each - all.*each) / (n + 1);
  }
  runner.means.push_back(found.mean);
  runner.variances.push_back(found.variance);
}

class Measuring {
 public:
  Measuring(const Contest& contest, grader::sandbox::Tier tier, double seconds,
            const std::function<void(double)>& progress)
      : about_(*contest.about), seconds_(seconds), progress_(progress) {
    for (const Candidate& candidate : contest.candidates) {
      Player player{Conversation(candidate.plain, tier), {}, {}};
      if (!candidate.counted.empty()) player.counted.emplace(candidate.counted, tier);
      for (std::size_t i = 0; i < about_.cases.size(); ++i) {
        Runner runner;
        runner.row.name = candidate.name;
        runner.row.is_own = candidate.is_own();
        runner.row.problem = candidate.problem;
        runner.request.task = index_of(about_);
        runner.request.of_cases = static_cast<std::uint32_t>(i);
        player.runners.push_back(runner);
      }
      players_.push_back(std::move(player));
    }
  }

  Results run() {
    find_accuracy();
    for (std::size_t i = 0; i < about_.cases.size(); ++i) {
      for (Player& player : players_) attempt(player, [&] { find_passes(player, i); });
    }
    if (!players_[0].plays()) {
      throw pt::Error("the reference of " + about_.slug +
                      " cannot be measured: " + players_[0].runners[0].row.problem);
    }
    for (int times = 0; part() < 1 || times < kFewestBatches; ++times) {
      for (std::size_t i = 0; i < about_.cases.size(); ++i) play_once(i);
      progress_(part());
    }
    return results();
  }

 private:
  double part() const {
    return std::chrono::duration<double>(Clock::now() - start_).count() / seconds_;
  }

  void find_accuracy() {
    const bool noisy = about_.kind == Kind::estimator;
    const int most = noisy ? kMaxChunks : 1;
    for (int chunk = 0; chunk < most && (part() < kNoise || chunk < kFewestChunks); ++chunk) {
      for (Player& player : players_) {
        for (Runner& runner : player.runners) {
          runner.request.seed = static_cast<std::uint64_t>(chunk) + 1;
          Conversation& worker = player.counted ? *player.counted : player.plain;
          attempt(player, [&] { enter(worker.find(runner.request), runner); });
        }
      }
      progress_(part());
    }
  }

  // The number of passes for a batch of the intended length.
  void find_passes(Player& player, std::size_t i) {
    Request& request = player.runners[i].request;
    for (request.passes = 1; request.passes < kMaxPasses; request.passes *= 2) {
      const double seconds = player.plain.time(request).seconds;
      if (seconds > kBatch / 4) {
        const double passes = std::round(request.passes * kBatch / seconds);
        request.passes = std::max(1U, static_cast<std::uint32_t>(passes));
        return;
      }
    }
  }

  // Returns nothing if it fails.
  std::optional<double> play(Player& player, std::size_t i) {
    std::optional<double> nanoseconds;
    attempt(player, [&] {
      const Timed timed = player.plain.time(player.runners[i].request);
      nanoseconds = 1e9 * timed.seconds / static_cast<double>(timed.calls);
      player.runners[i].nanoseconds.push_back(*nanoseconds);
    });
    return nanoseconds;
  }

  // Times each candidate once, in a new random order. Each pair runs between two batches of the
  // reference, and is compared with the geometric mean of these batches.
  void play_once(std::size_t i) {
    const std::vector<std::size_t> order = new_order();
    std::optional<double> before = play(players_[0], i);
    for (std::size_t k = 0; k < order.size(); k += 2) {
      std::array<std::optional<double>, 2> times;
      for (std::size_t l = 0; l < 2 && k + l < order.size(); ++l) {
        times.at(l) = play(players_[order[k + l]], i);
      }
      const std::optional<double> after = play(players_[0], i);
      for (std::size_t l = 0; l < 2; ++l) {
        if (!before || !after || !times.at(l)) continue;
        players_[order[k + l]].runners[i].ratios.push_back(*times.at(l) /
                                                           std::sqrt(*before * *after));
      }
      before = after;
    }
  }

  // A new order of all candidates except the reference.
  std::vector<std::size_t> new_order() {
    std::vector<std::size_t> order;
    for (std::size_t p = 1; p < players_.size(); ++p) {
      if (players_[p].plays()) order.push_back(p);
    }
    for (std::size_t k = order.size(); k > 1; --k) {
      std::swap(order[k - 1],
                order[static_cast<std::size_t>(static_cast<double>(k) * sampler_.next_1d())]);
    }
    return order;
  }

  Results results() {
    Results all{&about_, {}};
    for (std::size_t i = 0; i < about_.cases.size(); ++i) {
      Table table{about_.cases[i], {}};
      for (Player& player : players_) {
        Runner& runner = player.runners[i];
        Row row = runner.row;
        if (row.problem.empty()) {
          row.nanoseconds = median_of(runner.nanoseconds);
          row.ratio = table.rows.empty() ? Ranged{1, 1, 1} : median_of(runner.ratios);
          row.batches = static_cast<int>(runner.nanoseconds.size());
          if (about_.kind == Kind::estimator) {
            row.mean = mean_of(runner.means);
            row.variance = mean_of(runner.variances);
          }
        }
        table.rows.push_back(row);
      }
      all.tables.push_back(table);
    }
    return all;
  }

  const About& about_;
  double seconds_;
  const std::function<void(double)>& progress_;
  Clock::time_point start_ = Clock::now();
  std::vector<Player> players_;
  pt::Sampler sampler_{1};
};

}  // namespace

Results measure_contest(const Contest& contest, grader::sandbox::Tier tier, double seconds,
                        const std::function<void(double)>& progress) {
  return Measuring(contest, tier, seconds, progress).run();
}

}  // namespace measure::calls
