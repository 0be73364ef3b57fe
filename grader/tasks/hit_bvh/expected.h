#pragma once

#include "grader/check/language/property.h"
#include "grader/tasks/hit_bvh/queries.h"
#include "grader/tasks/hit_bvh/truth.h"
#include "pt/tasks/hit_bvh.h"

// Compares the answers of queries with those of testing every primitive in turn.

namespace grader::check::hit_bvh_inputs {

// Judges t of the nearest hit, in a case with a hit.
inline void expect_nearest(const Case& c) {
  const Truth truth = truth_of(c);
  if (!truth.any() || !truth.is_clear) return;
  const auto hit = ask(c);
  expect(hit.has_value(), shown(truth), "no hit");
  expect_near("t of the nearest hit", hit->t, truth.t(), t_error(truth));
}

// Judges whether there is a hit, and its t if there is one.
inline void expect_as_all(const Case& c) {
  const Truth truth = truth_of(c);
  if (!truth.is_clear) return;
  const auto hit = ask(c);
  expect(hit.has_value() == truth.any(), shown(truth), shown(hit));
  if (hit) expect_near("t of the nearest hit", hit->t, truth.t(), t_error(truth));
}

inline void expect_occluded_as_all(const Case& c) {
  const Truth truth = truth_of(c);
  if (!truth.is_clear) return;
  const bool occluded = occluded_bvh(c.bvh, c.primitives, c.ray);
  expect(occluded == truth.any(), "in the way: " + shown(truth),
         occluded ? "something in the way" : "nothing in the way");
}

// A wall at which the ray's range begins or ends is a hit, if the judge's hit_triangle answers.
// Within the precision of its contract, the submission's own may answer otherwise.
inline void expect_nearest_at_an_end(const Case& c) {
  if (!judge_answers) return;
  const Truth truth = truth_of(c);
  const auto hit = ask(c);
  expect(hit.has_value(), shown(truth) + ": a range has both its ends", "no hit");
  expect_near("t of the nearest hit", hit->t, truth.t(), t_error(truth));
}

inline void expect_occluded_at_an_end(const Case& c) {
  if (!judge_answers) return;
  expect(pt::occluded_bvh(c.bvh, c.primitives, c.ray),
         "in the way: " + shown(truth_of(c)) + ": a range has both its ends", "nothing in the way");
}

}  // namespace grader::check::hit_bvh_inputs
