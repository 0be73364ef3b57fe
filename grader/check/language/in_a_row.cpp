#include "grader/check/language/in_a_row.h"

#include "grader/check/language/show.h"

#include <cmath>

#include <fmt/format.h>

namespace grader::check {

using pt::Rgb;

namespace {

constexpr int kCalls = 600;
// Numbers that a call draws ahead of the sampler come again in one of the calls after it.
constexpr int kLags = 32;

// The correlation of channel a of each answer with channel b of the answer `lag` calls later.
double correlation(const std::vector<Rgb>& answers, const Mean& mean, int lag, int a, int b) {
  double together = 0, all_a = 0, all_b = 0;
  for (std::size_t i = 0; i < answers.size(); ++i) {
    const double off_a = answers[i][a] - mean.value[a], off_b = answers[i][b] - mean.value[b];
    all_a += off_a * off_a;
    all_b += off_b * off_b;
    if (i + lag < answers.size()) together += off_a * (answers[i + lag][b] - mean.value[b]);
  }
  return all_a > 0 && all_b > 0 ? together / std::sqrt(all_a * all_b) : 0;
}

void expect_independent(const std::vector<Rgb>& answers) {
  // The correlation of independent answers is about normal, with a deviation of 1 / sqrt(calls).
  const double limit = (kStandardErrors + 1) / std::sqrt(kCalls);
  const Mean mean = mean_of(answers);
  for (int lag = 1; lag <= kLags; ++lag) {
    for (int pair = 0; pair < 9; ++pair) {
      const double r = correlation(answers, mean, lag, pair / 3, pair % 3);
      expect(
          std::abs(r) < limit,
          fmt::format("calls that do not depend on each other: a correlation within {:.2f}", limit),
          lag == 1 ? fmt::format("{:.2f} between one call and the next after it", r)
                   : fmt::format("{:.2f} between one call and the one {} calls later", r, lag));
    }
  }
}

}  // namespace

double correlation(const std::vector<Rgb>& answers, int a, int b) {
  return correlation(answers, mean_of(answers), 0, a, b);
}

std::vector<Rgb> expect_goes_on(std::uint64_t seed, const Drawing& task) {
  const pt::Sampler start(seed);
  pt::Sampler sampler = start;
  std::vector<Rgb> answers;
  answers.reserve(kCalls);
  for (int i = 0; i < kCalls; ++i) {
    const pt::Sampler before = sampler;
    answers.push_back(task(sampler));
    expect(sampler.state() != before.state(), "a sampler that has moved on after the call",
           "a sampler that has not moved on: the next call will draw the same numbers again");
  }
  pt::Sampler again = start;
  const Rgb replayed = task(again);
  expect(replayed == answers.front(), "the same answer from a sampler in the same state",
         fmt::format("{}, and {} before", show(replayed), show(answers.front())));
  expect_independent(answers);
  return answers;
}

void expect_moves_on(std::uint64_t seed, const Drawing& task) {
  constexpr int kSamplers = 20;
  for (int i = 0; i < kSamplers; ++i) {
    const pt::Sampler start = pt::Sampler::for_pixel(seed, i, 0);
    pt::Sampler sampler = start;
    const Rgb answer = task(sampler);
    expect(sampler.state() != start.state(), "a sampler that has moved on, whatever the call found",
           "a sampler that has not moved on, after a call that returns " + show(answer));
  }
}

}  // namespace grader::check
