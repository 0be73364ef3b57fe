#pragma once

#include "grader/check/language/property.h"
#include "grader/check/mocks/counting.h"
#include "grader/tasks/hit_bvh/inputs.h"
#include "grader/tasks/hit_bvh/truth.h"
#include "pt/tasks/hit_bvh.h"

#include <algorithm>
#include <optional>
#include <string>

// Queries of the task under test, and the calls of other tasks that they made.

namespace grader::check::hit_bvh_inputs {

inline std::optional<pt::Hit> ask(const Case& c) { return pt::hit_bvh(c.bvh, c.primitives, c.ray); }

inline std::optional<pt::Hit> ask(const AimedInGrid& aimed) {
  return pt::hit_bvh(aimed.grid->bvh, aimed.grid->primitives, aimed.ray());
}

inline bool is_occluded(const AimedInGrid& aimed) {
  return pt::occluded_bvh(aimed.grid->bvh, aimed.grid->primitives, aimed.ray());
}

// Returns whether a query enters only a few of the thousand leaves that a ray may enter. Other
// promises judge queries that do not, and the large grid would take them seconds.
inline bool is_quick_in_a_grid() {
  constexpr std::size_t kFew = 200;
  forget_tests();
  const AimedInGrid aimed = first_in(small_grid());
  ask(aimed);
  is_occluded(aimed);
  return tested().boxes.size() + tested().spheres.size() < kFew;
}

// While this object lives, the judge's tasks answer for another ray. The destructor also resets
// this if a query ends the case.
struct AnsweringFor {
  explicit AnsweringFor(const pt::Ray& other) { answer_for(other); }
  ~AnsweringFor() { answer_for({}); }
  AnsweringFor(const AnsweringFor&) = delete;
  AnsweringFor& operator=(const AnsweringFor&) = delete;
};

// Returns a copy of the tests of one query, before the property itself calls a task.
inline Tested tested_by(const Case& c, bool any) {
  forget_tests();
  if (any) {
    pt::occluded_bvh(c.bvh, c.primitives, c.ray);
  } else {
    pt::hit_bvh(c.bvh, c.primitives, c.ray);
  }
  return tested();
}

// Eight triangles in a row, ten apart, and a ray at one of them. Each triangle is in its own leaf,
// three levels below the root.
inline Case plain_case(int aim) {
  constexpr int kLeaves = 8;
  Case c;
  for (int i = 0; i < kLeaves; ++i) {
    const double x = 10 * i - 35;
    c.primitives.triangles.push_back(
        pt::flat_triangle({x - 1, -1, 0}, {x + 1, -1, 0.5}, {x, 1, 0.2}));
    c.bvh.order.push_back(i);
  }
  c.bvh.nodes.resize(2 * kLeaves - 1);
  for (int i = 2 * kLeaves - 2; i >= 0; --i) {
    pt::BvhNode& node = c.bvh.nodes[i];
    if (i >= kLeaves - 1) {
      node = {bounds(c.primitives, i - kLeaves + 1), -1, -1, i - kLeaves + 1, 1};
    } else {
      node = {{}, 2 * i + 1, 2 * i + 2, 0, 0};
      node.box.grow(c.bvh.nodes[node.left].box);
      node.box.grow(c.bvh.nodes[node.right].box);
    }
  }
  c.ray = {{10.0 * aim - 35, 0, -5}, {0.01, 0.02, 1}};
  return c;
}

// Returns whether the query of the plain case called hit_box for the leaf of this primitive or for
// the leaf's parent.
inline bool came_by_its_leaf(const Case& plain, int primitive, const Tested& log) {
  const int leaf = 7 + primitive, parent = (leaf - 1) / 2;
  return std::ranges::any_of(log.boxes, [&](const pt::Box& box) {
    return box.min == plain.bvh.nodes[leaf].box.min || box.min == plain.bvh.nodes[parent].box.min;
  });
}

// Counts the leaves of the plain case whose boxes the query tested.
inline int leaves_tested(const Case& plain, const Tested& log) {
  return static_cast<int>(std::ranges::count_if(plain.bvh.nodes, [&](const pt::BvhNode& node) {
    return node.is_leaf() && std::ranges::any_of(log.boxes, [&](const pt::Box& box) {
             return box.min == node.box.min && box.max == node.box.max;
           });
  }));
}

// True if the judge's own tasks answer the calls of a query. If a submission is judged together
// with its own tasks, those answer, and the submission reports the tests. The plain case sets this.
inline bool judge_answers = false;

// Queries of the plain case. A query that tests no boxes or those of all leaves, or that ignores the
// answers of hit_primitive, does not walk the tree, and then no promise holds.
inline void expect_that_it_walks() {
  const std::string plain =
      "before anything else, in a tree of eight leaves, each with one triangle, and a ray at one: ";
  for (const int aim : {1, 6}) {
    const Case c = plain_case(aim);
    forget_tests();
    const auto hit = ask(c);
    const Tested& log = tested();
    expect(hit && hit->primitive == aim, plain + "a hit of primitive " + std::to_string(aim),
           shown(hit));
    expect(came_by_its_leaf(c, aim, log),
           plain + "a walk from the root to its leaf, in which hit_box is called with their boxes",
           log.boxes.empty() ? "no call of hit_box" : "no call of hit_box for the leaf's box");
    expect(occluded_bvh(c.bvh, c.primitives, c.ray),
           plain + "something in the way for occluded_bvh, as there is a hit for hit_bvh",
           "nothing in the way");
    judge_answers = log.answered_here > 0;
    if (!judge_answers) continue;
    const AnsweringFor another(plain_case(7 - aim).ray);
    const auto other = ask(c);
    expect(other && other->primitive == 7 - aim,
           plain +
               "the answer of hit_box and hit_primitive, which say here that the ray "
               "meets primitive " +
               std::to_string(7 - aim),
           shown(other));
  }
  Case between = plain_case(1);
  between.ray.origin.x += 5;
  const auto hit = ask(between);
  expect(!hit.has_value(), plain + "no hit between two of them", shown(hit));
  for (const bool any : {false, true}) {
    const int leaves = leaves_tested(between, tested_by(between, any));
    expect(leaves < 4, plain + "tests of the boxes of fewer than four leaves, by a ray between two",
           std::to_string(leaves) + (any ? ", by occluded_bvh" : ", by hit_bvh"));
  }
}

// Returns how far an answer may be from the truth. The answer of hit_primitive may not be changed.
// The submission's own tasks are right only to the precision of their contracts.
inline double t_error(const Meeting& meeting) {
  const double rounding = 1e-12 * std::abs(meeting.hit->t);
  return judge_answers ? rounding : rounding + 2 * meeting.t_error;
}

inline double n_error(const Meeting& meeting) {
  return judge_answers ? 0 : 1e-12 + 2 * meeting.n_error;
}

// Returns the allowed error of t of the nearest hit. If another hit is as near, it may be returned.
inline double t_error(const Truth& truth) {
  double error = t_error(truth.meetings[truth.nearest]);
  for (const Meeting& meeting : truth.meetings) {
    if (!meeting.hit) continue;
    const double other = t_error(meeting);
    if (meeting.hit->t <= truth.t() + error + other) error = std::max(error, other);
  }
  return error;
}

}  // namespace grader::check::hit_bvh_inputs
