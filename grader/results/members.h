#pragma once

#include "grader/results/results.h"

#include <concepts>
#include <type_traits>

// The members of the results model by the names that they have in JSON, in one list for all that
// goes through them: each(name, member) is called for every one.

namespace grader::results {

template <class S, class Of>
concept Is = std::same_as<std::remove_const_t<S>, Of>;

void members(Is<Failure> auto& failure, auto&& each) {
  each("input", failure.input);
  each("what", failure.what);
  each("got", failure.got);
  each("expected", failure.expected);
  each("off_by", failure.off_by);
  each("cause", failure.cause);
  each("cases_before", failure.cases_before);
  each("seed", failure.seed);
  each("integrated", failure.integrated);
  each("replay", failure.replay);
}

void members(Is<PromiseResult> auto& promise, auto&& each) {
  each("name", promise.name);
  each("words", promise.words);
  each("bonus", promise.bonus);
  each("held", promise.held);
  each("points", promise.points);
  each("seconds", promise.seconds);
  each("failures", promise.failures);
}

void members(Is<FailingCell> auto& cell, auto&& each) {
  each("x", cell.x);
  each("y", cell.y);
  each("width", cell.width);
  each("height", cell.height);
  each("channel", cell.channel);
  each("off_by", cell.off_by);
  each("evidence", cell.evidence);
}

void members(Is<PictureResult> auto& picture, auto&& each) {
  each("recipe", picture.recipe);
  each("title", picture.title);
  each("state", picture.state);
  each("text", picture.text);
  each("integrated", picture.integrated);
  each("samples", picture.samples);
  each("rounds", picture.rounds);
  each("noise", picture.noise);
  each("seconds", picture.seconds);
  each("points", picture.points);
  each("max_points", picture.max_points);
  each("replay", picture.replay);
  each("width", picture.width);
  each("height", picture.height);
  each("golden", picture.golden);
  each("render", picture.render);
  each("evidence", picture.evidence);
  each("golden_counts", picture.golden_counts);
  each("counts", picture.counts);
  each("cells", picture.cells);
}

void members(Is<Mistake> auto& mistake, auto&& each) {
  each("name", mistake.name);
  each("sentence", mistake.sentence);
  each("found_by", mistake.found_by);
  each("hint", mistake.hint);
  each("always_the_same", mistake.always_the_same);
}

void members(Is<TaskResult> auto& task, auto&& each) {
  each("part", task.part);
  each("number", task.number);
  each("slug", task.slug);
  each("state", task.state);
  each("reason", task.reason);
  each("points", task.points);
  each("max_points", task.max_points);
  each("bonus_points", task.bonus_points);
  each("spared", task.spared);
  each("mistake", task.mistake);
  each("blocked_by", task.blocked_by);
  each("blamed", task.blamed);
  each("compiler_output", task.compiler_output);
  each("warnings", task.warnings);
  each("keeps_state", task.keeps_state);
  each("printed", task.printed);
  each("promises", task.promises);
  each("pictures", task.pictures);
}

void members(Is<Phase> auto& phase, auto&& each) {
  each("name", phase.name);
  each("seconds", phase.seconds);
}

void members(Is<Results> auto& results, auto&& each) {
  each("complete", results.complete);
  each("submission", results.submission);
  each("asked", results.asked);
  each("seed", results.seed);
  each("isolation", results.isolation);
  each("versions", results.versions);
  each("command", results.command);
  each("seconds", results.seconds);
  each("phases", results.phases);
  each("tasks", results.tasks);
}

}  // namespace grader::results
