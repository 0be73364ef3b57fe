#pragma once

#include "grader/property/generators.h"
#include "grader/property/many.h"
#include "grader/property/show.h"
#include "pt/geometry/bvh.h"
#include "pt/geometry/primitives.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

// Primitives, trees of all shapes over them, which the test builds itself, and rays.

namespace grader::hit_bvh_cases {

// How a range of primitives is divided.
enum class Shape { balanced, random, chain, leaf };

struct Case {
  pt::Primitives primitives;
  pt::Bvh bvh;
  pt::Ray ray;
};

// What is in which: of a tree small enough to be drawn on paper.
inline void show_nodes(const pt::Bvh& bvh, std::ostream& out) {
  for (std::size_t i = 0; i < bvh.nodes.size(); ++i) {
    const pt::BvhNode& node = bvh.nodes[i];
    out << "\nnode " << i << ": ";
    if (!node.is_leaf()) out << "left " << node.left << ", right " << node.right;
    for (int k = 0; k < node.count; ++k) {
      out << (k == 0 ? "leaf of primitive " : ", ") << bvh.order[node.first + k];
    }
  }
}

inline void showValue(const Case& c, std::ostream& out) {
  constexpr int kShown = 4;
  const auto leaves = std::ranges::count_if(c.bvh.nodes, &pt::BvhNode::is_leaf);
  out << "nodes of the tree: " << c.bvh.nodes.size() << ", leaves among them: " << leaves
      << ", triangles: " << c.primitives.triangles.size()
      << ", spheres: " << c.primitives.spheres.size();
  for (int i = 0; i < std::min(kShown, c.primitives.size()); ++i) {
    const bool triangle = c.primitives.is_triangle(i);
    out << "\nprimitive " << i << ": "
        << (triangle ? show(c.primitives.triangle(i)) : show(c.primitives.sphere(i)));
  }
  if (c.primitives.size() > kShown) out << "\nand so on";
  if (c.bvh.nodes.size() <= 7) show_nodes(c.bvh, out);
  out << "\n" << show(c.ray);
}

inline pt::Triangle some_triangle(Many& make) {
  const pt::Vec3 p = make.vector(-5, 5);
  const pt::Vec3 q = p + make.vector(-2, 2), r = p + make.vector(-2, 2);
  pt::Triangle made = flat_triangle(p, q, r);
  made.n0 = normalize(made.n0 + make.vector(-0.3, 0.3));
  made.n1 = normalize(made.n1 + make.vector(-0.3, 0.3));
  return made;
}

struct TreeMaker {
  const pt::Primitives& primitives;
  Shape shape;
  int max_leaf;
  double padding;  // boxes may be larger than they need to be
  Many& make;
  pt::Bvh bvh{};

  int divide(int first, int last) {
    const int n = last - first;
    if (shape == Shape::chain) return make.whole(0, 1) == 0 ? first + 1 : last - 1;
    if (shape == Shape::random) return first + make.whole(1, n - 1);
    const int axis = make.whole(0, 2);
    std::sort(bvh.order.begin() + first, bvh.order.begin() + last, [&](int a, int b) {
      return bounds(primitives, a).center()[axis] < bounds(primitives, b).center()[axis];
    });
    return first + n / 2;
  }

  int build(int first, int last) {
    const int me = static_cast<int>(bvh.nodes.size());
    pt::BvhNode node;
    for (int i = first; i < last; ++i) node.box.grow(bounds(primitives, bvh.order[i]));
    const double more = make.between(0, padding);
    node.box.min -= {more, more, more};
    node.box.max += {more, more, more};
    bvh.nodes.push_back(node);
    if (last - first <= max_leaf || shape == Shape::leaf) {
      bvh.nodes[me].first = first;
      bvh.nodes[me].count = last - first;
      return me;
    }
    const int middle = divide(first, last);
    const bool exchanged = make.whole(0, 1) == 0;
    const int a = exchanged ? build(middle, last) : build(first, middle);
    const int b = exchanged ? build(first, middle) : build(middle, last);
    bvh.nodes[me].left = a;
    bvh.nodes[me].right = b;
    return me;
  }
};

inline pt::Bvh tree_of(const pt::Primitives& primitives, Shape shape, int max_leaf, double padding,
                       Many& make) {
  TreeMaker maker{primitives, shape, max_leaf, padding, make};
  maker.bvh.order.resize(primitives.size());
  std::iota(maker.bvh.order.begin(), maker.bvh.order.end(), 0);
  make.shuffle(maker.bvh.order);
  maker.build(0, primitives.size());
  return maker.bvh;
}

// A ray past the middle of one of the primitives, or anywhere, with and without an end.
inline pt::Ray some_ray(const pt::Primitives& primitives, Many& make) {
  const pt::Vec3 origin = make.vector(-12, 12);
  const pt::Box aim = bounds(primitives, make.whole(0, primitives.size() - 1));
  const bool at_one = make.whole(0, 3) > 0;
  const pt::Vec3 target = at_one ? aim.center() + 0.3 * make.vector(-1, 1) : make.vector(-8, 8);
  pt::Ray ray{origin, std::pow(10, make.between(-2.0, 2.0)) * (target - origin)};
  const double way = length(target - origin) / length(ray.direction);
  if (make.whole(0, 2) == 0) ray.t_min = way * make.between(0.0, 1.2);
  if (make.whole(0, 2) == 0) ray.t_max = ray.t_min + way * make.between(0.0, 1.2);
  return ray;
}

struct Wanted {
  int least = 1, most = 40;
  bool spheres = true;
  double padding = 0.5;
  int max_leaf = 6;
};

// How many primitives, and the seed of all about them.
struct Lot {
  int n;
  std::uint64_t seed;
};

// Fewer primitives are another scene, in which most mistakes are rarer than in a large one. So
// shrinking tries several for each number, the smallest first.
inline rc::Gen<Lot> some_lot(int least, int most) {
  constexpr int kNumbers = 8, kSeeds = 40;
  return rc::Gen<Lot>([=](const rc::Random& random, int size) {
    const auto first = rc::gen::pair(whole(least, most), sampler_seed())(random, size).value();
    return rc::shrinkable::shrinkRecur(Lot{first.first, first.second}, [=](const Lot& lot) {
      std::vector<Lot> smaller;
      for (int n = least; n < std::min(lot.n, least + kNumbers); ++n) {
        for (int k = 0; k < kSeeds; ++k) smaller.push_back({n, lot.seed + k});
      }
      return rc::seq::fromContainer(smaller);
    });
  });
}

inline rc::Gen<Case> with_tree(const std::vector<Shape>& shapes, Wanted wanted = {}) {
  return rc::gen::exec([=] {
    const auto [n, seed] = *some_lot(wanted.least, wanted.most);
    const Shape shape = *rc::gen::elementOf(shapes);
    Many make(seed);
    const int max_leaf = make.whole(1, wanted.max_leaf);
    Case c;
    for (int i = 0; i < n; ++i) {
      const bool sphere = wanted.spheres && make.whole(0, 2) == 0;
      if (sphere) {
        c.primitives.spheres.push_back({make.vector(-5, 5), make.between(0.1, 1.5)});
      } else {
        c.primitives.triangles.push_back(some_triangle(make));
      }
    }
    c.bvh = tree_of(c.primitives, shape, max_leaf, wanted.padding, make);
    c.ray = some_ray(c.primitives, make);
    return c;
  });
}

inline rc::Gen<Case> some_tree(Wanted wanted = {}) {
  return with_tree({Shape::balanced, Shape::random}, wanted);
}

}  // namespace grader::hit_bvh_cases
