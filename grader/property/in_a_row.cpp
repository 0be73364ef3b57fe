#include "grader/property/in_a_row.h"

#include "grader/property/show.h"

#include <cmath>

#include <fmt/format.h>

namespace grader {

using pt::Rgb;

namespace {

constexpr int kCalls = 600;
constexpr int kLags = 3;  // a light takes up to three random numbers

// The correlation of each answer with the one `lag` calls later.
double correlation(const std::vector<Rgb>& answers, int lag, int channel) {
  const Mean mean = mean_of(answers);
  double together = 0, all = 0;
  for (std::size_t i = 0; i < answers.size(); ++i) {
    const double off = answers[i][channel] - mean.value[channel];
    all += off * off;
    if (i + lag < answers.size()) {
      together += off * (answers[i + lag][channel] - mean.value[channel]);
    }
  }
  return all > 0 ? together / all : 0;
}

}  // namespace

std::vector<Rgb> expect_goes_on(std::uint64_t seed, const Drawing& task) {
  const pt::Sampler start(seed);
  pt::Sampler sampler = start;
  std::vector<Rgb> answers;
  answers.reserve(kCalls);
  for (int i = 0; i < kCalls; ++i) {
    const pt::Sampler before = sampler;
    answers.push_back(task(sampler));
    expect(sampler.state() != before.state(), "a sampler that has gone on after the call",
           "a sampler in the state from before: the next call will draw the same numbers again");
  }
  pt::Sampler again = start;
  const Rgb replayed = task(again);
  expect(replayed == answers.front(), "the same answer from a sampler in the same state",
         fmt::format("{}, and {} before", show(replayed), show(answers.front())));
  // Of independent answers a correlation is about normal, with a deviation of 1 / sqrt(calls).
  const double limit = (kStandardErrors + 1) / std::sqrt(kCalls);
  for (int lag = 1; lag <= kLags; ++lag) {
    for (int channel = 0; channel < 3; ++channel) {
      const double r = correlation(answers, lag, channel);
      expect(
          std::abs(r) < limit,
          fmt::format("calls that do not depend on each other: a correlation within {:.2f}", limit),
          fmt::format("{:.2f} between one call and the {} after it", r,
                      lag == 1   ? "next"
                      : lag == 2 ? "second"
                                 : "third"));
    }
  }
  return answers;
}

}  // namespace grader
