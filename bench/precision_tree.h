#pragma once

#include "pt/geometry/bvh.h"
#include "pt/geometry/primitives.h"
#include "pt/geometry/ray.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace pt {

// Measures the gain of single precision in a binary tree such as learners write: the tree of the
// task build_bvh, its boxes and triangles in Real, one ray against one box or triangle at a time,
// the nearer child first. It bounds no errors: in float it is neither tight nor exact, and shows
// only the speed. Triangles only.
template <class Real>
class PrecisionTree {
 public:
  struct Vec {
    Real x, y, z;
  };
  struct Line {
    Vec origin, direction;
    Real t_min, t_max;
  };

  PrecisionTree(const Bvh& bvh, const Primitives& primitives) {
    for (const BvhNode& node : bvh.nodes) {
      nodes_.push_back(
          {vec(node.box.min), vec(node.box.max), node.left, node.right, node.first, node.count});
    }
    for (const int i : bvh.order) {
      const Triangle& t = primitives.triangle(i);
      const Vec3 e1 = t.p0 - t.p1, e2 = t.p2 - t.p0;
      triangles_.push_back({vec(t.p0), vec(e1), vec(e2), vec(cross(e1, e2))});
    }
  }

  // The ray begins `margin` later: in float it would hit the surface on which it starts.
  static Line convert(const Ray& ray, double margin) {
    return {vec(ray.origin), vec(ray.direction), static_cast<Real>(ray.t_min + margin),
            static_cast<Real>(ray.t_max)};
  }

  // The t of the nearest triangle; `line.t_max` if there is none.
  Real closest(const Line& line) const {
    const Vec inverse{1 / line.direction.x, 1 / line.direction.y, 1 / line.direction.z};
    Real t_max = line.t_max;
    int stack[128];
    int size = 0;
    stack[size++] = 0;
    while (size > 0) {
      const Node& node = nodes_[static_cast<std::size_t>(stack[--size])];
      if (!(entry(node, line, inverse, t_max) < t_max)) continue;
      if (node.count > 0) {
        for (int i = node.first; i < node.first + node.count; ++i) {
          t_max = meet(triangles_[static_cast<std::size_t>(i)], line, t_max);
        }
        continue;
      }
      const Real left = entry(nodes_[static_cast<std::size_t>(node.left)], line, inverse, t_max);
      const Real right = entry(nodes_[static_cast<std::size_t>(node.right)], line, inverse, t_max);
      stack[size++] = left < right ? node.right : node.left;
      stack[size++] = left < right ? node.left : node.right;
    }
    return t_max;
  }

 private:
  struct Node {
    Vec min, max;
    int left, right, first, count;
  };
  struct Facet {
    Vec p0, e1, e2, n;
  };

  static Vec vec(Vec3 a) {
    return {static_cast<Real>(a.x), static_cast<Real>(a.y), static_cast<Real>(a.z)};
  }
  static Real dot(Vec a, Vec b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

  // The t at which the line enters the node's box; infinite if it does not enter the box up to t_max.
  static Real entry(const Node& node, const Line& line, Vec inverse, Real t_max) {
    Real begin = line.t_min, end = t_max;
    const auto cut = [&](Real low, Real high, Real o, Real d) {
      const Real a = (low - o) * d, b = (high - o) * d;
      begin = std::max(begin, std::min(a, b));
      end = std::min(end, std::max(a, b));
    };
    cut(node.min.x, node.max.x, line.origin.x, inverse.x);
    cut(node.min.y, node.max.y, line.origin.y, inverse.y);
    cut(node.min.z, node.max.z, line.origin.z, inverse.z);
    return begin <= end ? begin : std::numeric_limits<Real>::infinity();
  }

  // Moeller and Trumbore 1997 with the normal stored.
  static Real meet(const Facet& f, const Line& line, Real t_max) {
    const Vec o = line.origin, d = line.direction;
    const Vec c{f.p0.x - o.x, f.p0.y - o.y, f.p0.z - o.z};
    const Vec r{d.y * c.z - d.z * c.y, d.z * c.x - d.x * c.z, d.x * c.y - d.y * c.x};
    const Real inverse = 1 / dot(d, f.n);
    const Real u = dot(r, f.e2) * inverse, v = dot(r, f.e1) * inverse, t = dot(c, f.n) * inverse;
    return u >= 0 && v >= 0 && u + v <= 1 && t >= line.t_min && t < t_max ? t : t_max;
  }

  std::vector<Node> nodes_;
  std::vector<Facet> triangles_;
};

}  // namespace pt
