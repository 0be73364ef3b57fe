#pragma once

#include "pt/sampling/sampler.h"

#include <cstdint>
#include <tuple>
#include <vector>

namespace grader::check {

// A function type without its last parameter, a Sampler&.
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

// Defined where the task is: with a local implementation as a loop (repeat_local.cpp), with
// `remote` as one message for many calls.
template <auto Task, class Result, class... Parameters>
struct Repeated<Task, Result (*)(Parameters...)> {
  using Arguments = typename AllButLast<std::tuple<Parameters...>>::Type;
  static std::vector<Result> run(int n, std::uint64_t seed, const Arguments& arguments);
};

// `n` independent calls of a task whose last parameter is a Sampler&, for a statistical promise:
//   repeat<pt::direct_lights>(10000, seed, scene, point, samples)
// returns what the calls returned; call i gets Sampler::for_pixel(seed, i, 0).
template <auto Task, class... Arguments>
auto repeat(int n, std::uint64_t seed, const Arguments&... arguments) {
  return Repeated<Task>::run(n, seed, {arguments...});
}

}  // namespace grader::check
