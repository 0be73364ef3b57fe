#pragma once

#include "grader/explain/record.h"
#include "pt/sampling/sampler.h"

#include <cstdint>
#include <tuple>
#include <type_traits>
#include <vector>

namespace grader::check {

// Calls a task many times. The last parameter of the task is a Sampler&; the other parameters are
// Arguments.
template <auto Task, class Function = decltype(Task)>
struct Repeated;

template <class Parameters, class Kept = std::tuple<>>
struct AllButLast;
template <class Last, class... Kept>
struct AllButLast<std::tuple<Last>, std::tuple<Kept...>> {
  using Type = std::tuple<const std::remove_cvref_t<Kept>&...>;
};
template <class First, class... Rest, class... Kept>
requires(sizeof...(Rest) > 0) struct AllButLast<std::tuple<First, Rest...>, std::tuple<Kept...>>
    : AllButLast<std::tuple<Rest...>, std::tuple<Kept..., First>> {
};

// Defined together with the task. For a local implementation it is a loop (repeat_local.cpp); for
// `remote` it is one message for many calls.
template <auto Task, class Result, class... Parameters>
struct Repeated<Task, Result (*)(Parameters...)> {
  using Arguments = typename AllButLast<std::tuple<Parameters...>>::Type;
  static std::vector<Result> run(int n, std::uint64_t seed, const Arguments& arguments);

  // True if the record of a call can be explained: the task estimates light in a scene.
  static constexpr bool kIsRecorded =
      std::is_same_v<Result, pt::Rgb> &&
      std::is_same_v<std::remove_cvref_t<std::tuple_element_t<0, Arguments>>, pt::Scene>;
  static std::vector<explain::Told> run_recorded(int n, std::uint64_t seed,
                                                 const Arguments& arguments);
};

// Makes `n` independent calls of a task whose last parameter is a Sampler&, for a statistical
// promise:
//   repeat<pt::direct_lights>(10000, seed, scene, point, samples)
// Returns the results of the calls. Call i gets Sampler::for_pixel(seed, i, 0).
template <auto Task, class... Arguments>
auto repeat(int n, std::uint64_t seed, const Arguments&... arguments) {
  return Repeated<Task>::run(n, seed, {arguments...});
}

// The same calls with what they asked (grader/explain/record.h); what they were told is for the caller to fill in. Nothing is
// returned where no record is kept: in a worker that runs all tasks of a submission.
template <auto Task, class... Arguments>
std::vector<explain::Told> repeat_recorded(int n, std::uint64_t seed,
                                           const Arguments&... arguments) {
  static_assert(Repeated<Task>::kIsRecorded);
  return Repeated<Task>::run_recorded(n, seed, {arguments...});
}

}  // namespace grader::check
