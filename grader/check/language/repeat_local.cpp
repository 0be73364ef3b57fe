// repeat() of one task, FIRSTLIGHT_TASK, that is linked into this program. This file is compiled
// once per task.
#include "grader/calls.h"
#include "grader/check/language/repeat.h"

namespace grader::check {

template <auto Task, class Result, class... Parameters>
std::vector<Result> Repeated<Task, Result (*)(Parameters...)>::run(int n, std::uint64_t seed,
                                                                   const Arguments& arguments) {
  std::vector<Result> results;
  results.reserve(n);
  for (int i = 0; i < n; ++i) {
    pt::Sampler sampler = pt::Sampler::for_pixel(seed, i, 0);
    results.push_back(
        std::apply([&](const auto&... each) { return Task(each..., sampler); }, arguments));
  }
  return results;
}

template <auto Task, class Result, class... Parameters>
std::vector<explain::Told> Repeated<Task, Result (*)(Parameters...)>::run_recorded(
    int n, std::uint64_t seed, const Arguments& arguments) {
  std::vector<explain::Told> all;
  if constexpr (kIsRecorded) {
    for (int i = 0; i < n; ++i) {
      all.push_back(explain::record_one(std::get<0>(arguments), seed, i, [&](pt::Sampler& sampler) {
        return std::apply([&](const auto&... each) { return Task(each..., sampler); }, arguments);
      }));
    }
  }
  return all;
}

}  // namespace grader::check

FIRSTLIGHT_REPEATED(FIRSTLIGHT_TASK)
