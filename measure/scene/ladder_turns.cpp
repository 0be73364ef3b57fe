#include "measure/scene/ladder_turns.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace measure::scene {

namespace {

constexpr int kRounds = 5;
constexpr double kTrial = 40;        // pixels of a first look
constexpr double kFewestTimed = 12;  // pixels of a turn of engines
constexpr double kFewestSeen = 300;  // pixels of a picture

std::size_t pixels_of(const Turning& turning) { return turning.study.goldens().size(); }

// The step that selects about `wanted` pixels.
std::size_t step_for(const Turning& turning, double wanted) {
  const auto all = static_cast<double>(pixels_of(turning));
  return std::max<std::size_t>(1, static_cast<std::size_t>(all / wanted));
}

double pixel_seconds(const RungReply& reply) {
  return reply.cpu_seconds / static_cast<double>(reply.mean.size());
}

// About the seconds per pixel of all workers together.
double seconds_of_all(const std::vector<Worker>& workers, Turning& turning) {
  const std::size_t step = step_for(turning, kTrial);
  double sum = 0;
  for (const Worker& worker : workers) {
    sum += pixel_seconds(worker.render(++turning.seed, step / 2, step));
  }
  return sum;
}

// The noise and the bias of each pixel, summed over the turns.
struct TurnSums {
  std::vector<double> sum, squares;  // half the squared differences, weighted
  std::vector<double> bias;          // the products with the long renders

  explicit TurnSums(std::size_t pixels) : sum(pixels), squares(pixels), bias(pixels) {}

  void add(const Study& study, const RungReply& a, const RungReply& b, std::size_t step) {
    const std::vector<double> products = study.products(a.mean, b.mean, step);
    for (std::size_t i = 0; i < sum.size(); ++i) {
      const double difference = a.mean[i] - b.mean[i];
      const double value = study.goldens().weight(i * step) * difference * difference / 2;
      sum[i] += value;
      squares[i] += value * value;
      bias[i] += products[i] / kRounds;
    }
  }

  // Its standard error comes from the differences between turns: differences between pixels are not
  // errors.
  Uncertain variance() const {
    double total = 0, spread = 0;
    for (std::size_t i = 0; i < sum.size(); ++i) {
      total += sum[i];
      spread += (squares[i] - sum[i] * sum[i] / kRounds) / (kRounds - 1);
    }
    const double n = kRounds * static_cast<double>(sum.size());
    return {total / n, std::sqrt(kRounds * std::max(spread, 0.0)) / n};
  }
};

}  // namespace

RungReply Worker::render(std::uint64_t seed, std::size_t first, std::size_t step) const {
  Spec render = spec;
  render.path = path_of(rung.way, rung.light_samples);
  render.seed = seed;
  return program({render, first, step});
}

std::vector<RungTurns> time_engines(const std::vector<Worker>& engines, Turning turning) {
  const double wanted = turning.seconds / kRounds / seconds_of_all(engines, turning);
  const std::size_t step = step_for(turning, std::max(wanted, kFewestTimed));
  std::vector<RungTurns> results(engines.size());
  for (int turn = 0; turn < kRounds; ++turn) {
    ++turning.seed;
    std::vector<double> seconds;
    seconds.reserve(engines.size());
    for (const Worker& engine : engines) {
      seconds.push_back(pixel_seconds(engine.render(turning.seed, turn * step / kRounds, step)));
    }
    for (std::size_t k = 0; k < engines.size(); ++k) {
      results[k].log_times.push_back(std::log(seconds[k] / seconds.back()));
    }
    turning.progress((turn + 1.0) / kRounds);
  }
  return results;
}

std::vector<RungTurns> take_turns(const std::vector<Worker>& workers, Turning turning) {
  const double wanted = turning.seconds / (2 * kRounds) / seconds_of_all(workers, turning);
  const std::size_t step = step_for(turning, std::max(wanted, kFewestSeen));
  const std::size_t pixels = (pixels_of(turning) + step - 1) / step;
  std::vector<RungTurns> results(workers.size());
  std::vector<TurnSums> noise(workers.size(), TurnSums(pixels));
  for (int turn = 0; turn < kRounds; ++turn) {
    std::vector<double> seconds;
    for (std::size_t k = 0; k < workers.size(); ++k) {
      const RungReply a = workers[k].render(++turning.seed, 0, step);
      const RungReply b = workers[k].render(++turning.seed, 0, step);
      noise[k].add(turning.study, a, b, step);
      const double renders = 2.0 * kRounds * static_cast<double>(pixels);
      results[k].rays += static_cast<double>(a.rays + b.rays) / renders;
      results[k].samples += static_cast<double>(a.samples + b.samples) / renders;
      seconds.push_back((pixel_seconds(a) + pixel_seconds(b)) / 2);
      results[k].seconds += seconds.back() / kRounds;
      results[k].log_times.push_back(std::log(seconds[k] / seconds[0]));
    }
    turning.progress((turn + 1.0) / kRounds);
  }
  for (std::size_t k = 0; k < workers.size(); ++k) {
    results[k].variance = noise[k].variance();
    results[k].bias2 = mean_of(noise[k].bias);
  }
  return results;
}

std::vector<double> costs_of(const std::vector<Worker>& workers, Turning turning) {
  std::vector<double> costs;
  for (const RungTurns& turns : take_turns(workers, std::move(turning))) {
    costs.push_back(turns.seconds * turns.variance.value);
  }
  return costs;
}

}  // namespace measure::scene
