#pragma once

#include "grader/check/generators/random_numbers.h"
#include "grader/check/language/show.h"
#include "pt/geometry/bvh.h"
#include "pt/geometry/primitives.h"

#include <algorithm>
#include <numeric>
#include <string>

// Trees of all shapes over any primitives. The tests build these trees themselves.

namespace grader::check::hit_bvh_inputs {

// The way in which a tree divides its primitives.
enum class Shape { balanced, random, chain, left_chain, right_chain, leaf };

inline const char* words(Shape shape) {
  switch (shape) {
    case Shape::balanced:
      return "a tree that halves its primitives at each level";
    case Shape::random:
      return "a tree that divides its primitives anywhere";
    case Shape::chain:
      return "a tree that splits off one primitive at each level";
    case Shape::left_chain:
      return "a tree that goes on to the left, with one leaf to the right at each level";
    case Shape::right_chain:
      return "a tree that goes on to the right, with one leaf to the left at each level";
    case Shape::leaf:
      return "a single leaf";
  }
  return "";
}

struct Case {
  pt::Primitives primitives;
  pt::Bvh bvh;
  pt::Ray ray;
  std::string how;  // how the tree was made
};

// "leaf of primitives 7, 0 to 4", with the first numbers only if these are many.
inline void show_leaf(const pt::Bvh& bvh, const pt::BvhNode& leaf, std::ostream& out) {
  constexpr int kShown = 12;
  const auto order = [&](int k) { return bvh.order[leaf.first + k]; };
  out << (leaf.count == 1 ? "leaf of primitive" : "leaf of primitives");
  for (int k = 0, shown = 0; k < leaf.count; ++k, ++shown) {
    if (shown == kShown) {
      out << " and " << leaf.count - k << " more";
      return;
    }
    int last = k;
    while (last + 1 < leaf.count && order(last + 1) == order(last) + 1) ++last;
    out << (k == 0 ? " " : ", ") << order(k);
    if (last < k + 2) continue;
    out << " to " << order(last);
    k = last;
  }
}

// Shows all nodes of a tree that is small enough to be drawn on paper.
inline void show_nodes(const pt::Bvh& bvh, std::ostream& out) {
  for (std::size_t i = 0; i < bvh.nodes.size(); ++i) {
    const pt::BvhNode& node = bvh.nodes[i];
    out << "\nnode " << i << ": ";
    if (!node.is_leaf()) out << "left " << node.left << ", right " << node.right;
    if (node.is_leaf()) show_leaf(bvh, node, out);
  }
}

inline void showValue(const Case& c, std::ostream& out) {
  constexpr int kShown = 4;
  out << c.how << ", over " << c.primitives.triangles.size() << " triangles and "
      << c.primitives.spheres.size() << " spheres, in " << c.bvh.nodes.size() << " nodes\n"
      << show(c.ray);
  for (int i = 0; i < std::min(kShown, c.primitives.size()); ++i) {
    const bool triangle = c.primitives.is_triangle(i);
    out << "\nprimitive " << i << ": "
        << (triangle ? show(c.primitives.triangle(i)) : show(c.primitives.sphere(i)));
  }
  if (c.primitives.size() > kShown) out << "\nand " << c.primitives.size() - kShown << " more";
  if (c.bvh.nodes.size() <= 7) show_nodes(c.bvh, out);
}

struct TreeMaker {
  const pt::Primitives& primitives;
  Shape shape;
  int max_leaf;
  double padding;  // how much larger than necessary boxes may be
  RandomNumbers& make;
  int min_leaf = 1;  // where a tree divides anywhere, primitives stay together in such numbers
  pt::Bvh bvh{};

  int divide(int first, int last) {
    const int n = last - first;
    if (shape == Shape::chain) return make.whole(0, 1) == 0 ? first + 1 : last - 1;
    if (shape == Shape::right_chain) return first + 1;
    if (shape == Shape::left_chain) return last - 1;
    if (shape == Shape::random) return first + min_leaf * make.whole(1, n / min_leaf - 1);
    const int axis = make.whole(0, 2), middle = first + n / 2;
    const auto begin = bvh.order.begin();
    std::nth_element(begin + first, begin + middle, begin + last, [&](int a, int b) {
      return bounds(primitives, a).center()[axis] < bounds(primitives, b).center()[axis];
    });
    return middle;
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
    const bool one_sided = shape == Shape::left_chain || shape == Shape::right_chain;
    const bool exchanged = !one_sided && make.whole(0, 1) == 0;
    const int a = exchanged ? build(middle, last) : build(first, middle);
    const int b = exchanged ? build(first, middle) : build(middle, last);
    bvh.nodes[me].left = a;
    bvh.nodes[me].right = b;
    return me;
  }
};

inline pt::Bvh tree_of(const pt::Primitives& primitives, Shape shape, int max_leaf, double padding,
                       RandomNumbers& make) {
  TreeMaker maker{primitives, shape, max_leaf, padding, make};
  maker.bvh.order.resize(primitives.size());
  std::iota(maker.bvh.order.begin(), maker.bvh.order.end(), 0);
  make.shuffle(maker.bvh.order);
  maker.build(0, primitives.size());
  return maker.bvh;
}

// A tree that keeps the order of the primitives.
inline pt::Bvh tree_in_order(const pt::Primitives& primitives, Shape shape, RandomNumbers& make,
                             int max_leaf = 1, int min_leaf = 1) {
  TreeMaker maker{primitives, shape, max_leaf, 0, make, min_leaf};
  maker.bvh.order.resize(primitives.size());
  std::iota(maker.bvh.order.begin(), maker.bvh.order.end(), 0);
  maker.build(0, primitives.size());
  return maker.bvh;
}

}  // namespace grader::check::hit_bvh_inputs
