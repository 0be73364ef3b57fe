#include "grader/check/language/property.h"
#include "grader/tasks/build_bvh/inputs.h"
#include "grader/tasks/build_bvh/invariants.h"
#include "grader/tasks/build_bvh/walk.h"
#include "pt/tasks/build_bvh.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace grader::check {
namespace {

using namespace build_bvh_inputs;

pt::Bvh build(const Input& input) { return built(input.boxes, input.max_leaf); }

using Check = void (*)(const Input&, const pt::Bvh&);

// Checks the tree of a call that follows another one. The boxes of both are in the same memory.
void check_second_of_two(Check check) {
  if (testing::Test::HasFailure()) return;
  for_all([=] {
    const auto [before, now] = *in_turn(some_boxes(), changed);
    Input input = before;
    input.boxes.reserve(now.boxes.size());
    build(input);
    input.boxes = now.boxes;
    input.max_leaf = now.max_leaf;
    const pt::Bvh bvh = build(input);
    expect_nodes(bvh);
    check(now, bvh);
  });
}

// Checks one invariant on every kind of boxes that a plane divides, up to the first kind that
// fails. Other promises judge the other kinds.
void check_usual_boxes(Check check) {
  once(expect_a_tree_at_all);
  for (const auto& [boxes, cases] : {std::pair{some_boxes(), 150}, std::pair{deep_boxes(), 20},
                                     std::pair{thousands_of_boxes(), 4}}) {
    if (testing::Test::HasFailure()) return;
    for_all(
        [check, boxes = boxes] {
          const Input input = *boxes;
          const pt::Bvh bvh = build(input);
          expect_nodes(bvh);
          check(input, bvh);
        },
        cases);
  }
  check_second_of_two(check);
}

void check_divided(const rc::Gen<Input>& boxes, int cases) {
  once(expect_a_tree_at_all);
  if (testing::Test::HasFailure()) return;
  for_all(
      [&] {
        const Input input = *boxes;
        const pt::Bvh bvh = build(input);
        expect_nodes(bvh);
        expect_divided(input, bvh);
      },
      cases);
}

// More boxes, nodes and primitives in a leaf than 8 bits or 16 bits can count, and `most` boxes. The boxes
// are in a line, so that every method has little to do.
void check_large_numbers(Check check, int most) {
  struct Numbers {
    int boxes, max_leaf;
  };
  constexpr int kNoLimit = std::numeric_limits<int>::max();
  for (const auto& [boxes, max_leaf] :
       {Numbers{300, 255}, Numbers{300, 256}, Numbers{600, 257}, Numbers{300, kNoLimit},
        Numbers{66000, 1}, Numbers{most, 65536}, Numbers{66000, 70000}}) {
    if (testing::Test::HasFailure()) return;
    for_all(
        [&, boxes = boxes, max_leaf = max_leaf] {
          const Input input = *rc::gen::exec([=] { return in_a_line(boxes, max_leaf); });
          const pt::Bvh bvh = build(input);
          expect_nodes(bvh);
          check(input, bvh);
        },
        1);
  }
}

PROMISE(build_bvh, keeps_every_primitive_once) {
  check_usual_boxes(expect_every_primitive_once);
  check_large_numbers(expect_every_primitive_once, 200'000);
}
PROMISE(build_bvh, covers_its_primitives) { check_usual_boxes(expect_covered); }
PROMISE(build_bvh, is_one_tree) {
  check_usual_boxes([](const Input&, const pt::Bvh& bvh) { expect_one_tree(bvh); });
}
PROMISE(build_bvh, keeps_leaves_small) {
  check_usual_boxes(expect_small_leaves);
  check_large_numbers(expect_small_leaves, 66'000);
  if (testing::Test::HasFailure()) return;
  // A tree by planes is a thousand levels deep; one that goes over to medians has more than 32 levels.
  for_all(
      [] {
        const Input input = *halvings(2048);
        const pt::Bvh bvh = build(input);
        expect_nodes(bvh);
        expect_small_leaves(input, bvh);
      },
      1);
}
PROMISE(build_bvh, splits_until_it_must) { check_usual_boxes(expect_split); }
PROMISE(build_bvh, ends_on_identical_centroids) {
  check_divided(boxes_of(kCoinciding, 2, 300), 150);
  check_divided(a_large_pile(Kind::identical), 1);
  check_divided(a_large_pile(Kind::same_center), 1);
}
PROMISE(build_bvh, ends_where_axes_are_equally_long) {
  check_divided(boxes_of(kTied, 2, 300), 150);
}

PROMISE(build_bvh, takes_no_boxes_and_one) {
  once(expect_a_tree_at_all);
  once([] {
    const pt::Bvh none = built({}, 4);
    expect_equal("nodes without boxes", static_cast<long long>(none.nodes.size()), 0);
    expect_equal("entries in order without boxes", static_cast<long long>(none.order.size()), 0);
  });
  for_all([] {
    const Input one = *boxes_of({Kind::scattered, Kind::points, Kind::flat}, 1, 1);
    const pt::Bvh bvh = build(one);
    expect_equal("nodes for one box", static_cast<long long>(bvh.nodes.size()), 1);
    expect_every_primitive_once(one, bvh);
  });
}

// Returns how many boxes of the tree a ray enters if it crosses the plane of the rows. It is the
// mean over rays through the centres of so many boxes, the same rays for every tree.
double boxes_entered(const InRows& made, const pt::Bvh& bvh, int points) {
  const auto& [rows, input] = made;
  RandomNumbers make(1);
  long long entered = 0;
  for (int i = 0; i < points; ++i) {
    const pt::Box& box = input.boxes[make.whole(0, static_cast<int>(input.boxes.size()) - 1)];
    for (const pt::BvhNode& node : bvh.nodes) {
      bool inside = true;
      for (const int axis : {rows.along, rows.across}) {
        const double at = box.center()[axis];
        inside = inside && at >= node.box.min[axis] && at <= node.box.max[axis];
      }
      entered += inside;
    }
  }
  return static_cast<double>(entered) / points;
}

PROMISE(build_bvh, separates_along_the_longest_axis) {
  once(expect_a_tree_at_all);
  // If every split halves a row, a ray enters one box per level. If the splits ignore where the
  // boxes are, it enters about half of all boxes; if only the first splits of many boxes do, it
  // enters some times as many. The trees of textbooks enter 10 to 60.
  constexpr double kMost = 64;
  struct Sizes {
    int count, each;
    int points, cases;
  };
  for (const Sizes& sizes :
       {Sizes{1, 1024, 200, 28}, Sizes{8, 128, 200, 28}, Sizes{64, 256, 40, 1}}) {
    if (testing::Test::HasFailure()) return;
    for_all(
        [&] {
          const auto& [count, each, points, cases] = sizes;
          const InRows made = *in_rows(*whole(0, 2), count, each);
          const double entered = boxes_entered(made, build(made.input), points);
          expect(entered >= 1, "a root whose box holds the middles of all boxes",
                 "a ray across the row enters " + show(entered) +
                     " boxes of the tree on average: most rays miss even the root");
          expect(entered <= kMost, "at most " + show(kMost),
                 "a ray across the row enters " + show(entered) + " of " +
                     std::to_string(2 * count * each) + " boxes of the tree on average");
        },
        sizes.cases);
  }
}

PROMISE(build_bvh, stays_shallow_on_clustered_centroids_bonus) {
  once(expect_a_tree_at_all);
  for_all([] {
    const int axis = draw("axis", whole(0, 2)), n = draw("boxes", whole(100, 300));
    const double first = draw("the first centroid, twice the second", rc::gen::element(1.0, -1.0));
    const int max_leaf = draw("max_leaf", rc::gen::element(1, 50));
    const pt::Bvh bvh = build(halving_points(axis, n, first, max_leaf));
    expect_nodes(bvh);
    const int most = static_cast<int>(4 * std::log2(n));
    expect(depth(bvh) <= most, "a depth of at most " + std::to_string(most),
           std::to_string(depth(bvh)));
  });
}

}  // namespace
}  // namespace grader::check
