#pragma once

#include "grader/results/results.h"

#include <concepts>
#include <type_traits>

#include <nlohmann/json.hpp>

// The members of the results model by the names that they have in JSON, in one list for all that
// goes through them: each(name, member) is called for every one.

namespace grader::results {

template <class S, class Of>
concept Is = std::same_as<std::remove_const_t<S>, Of>;

#define FIRSTLIGHT_MEMBER(name) each(#name, value.name);
#define FIRSTLIGHT_MEMBERS(Type, ...)                                         \
  void members(Is<Type> auto& value, auto&& each) {                           \
    NLOHMANN_JSON_EXPAND(NLOHMANN_JSON_PASTE(FIRSTLIGHT_MEMBER, __VA_ARGS__)) \
  }

FIRSTLIGHT_MEMBERS(Failure, input, what, got, expected, off_by, cause, statistical, cases_before,
                   simple, seed, integrated, replay)
FIRSTLIGHT_MEMBERS(PromiseResult, name, words, bonus, held, points, seconds, failures, checks,
                   likeness)
FIRSTLIGHT_MEMBERS(FailingCell, x, y, width, height, channel, off_by, evidence)
FIRSTLIGHT_MEMBERS(PictureResult, recipe, title, state, text, integrated, samples, rounds, noise,
                   seconds, points, max_points, replay, width, height, golden, render, evidence,
                   golden_counts, counts, cells)
FIRSTLIGHT_MEMBERS(Mistake, name, sentence, found_by, hint, always_the_same)
FIRSTLIGHT_MEMBERS(TaskResult, part, number, slug, called, state, reason, points, max_points,
                   bonus_points, spared, mistake, blocked_by, blamed, compiler_output, warnings,
                   keeps_state, printed, promises, pictures)
FIRSTLIGHT_MEMBERS(Phase, name, seconds)
FIRSTLIGHT_MEMBERS(Results, complete, submission, asked, seed, isolation, versions, command,
                   dialect, seconds, phases, tasks)

#undef FIRSTLIGHT_MEMBERS
#undef FIRSTLIGHT_MEMBER

}  // namespace grader::results
