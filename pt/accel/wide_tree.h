#pragma once

#include "pt/geometry/sphere.h"
#include "pt/geometry/triangle.h"

#include <cstdint>
#include <limits>

// The data that the wide engine's queries read. See wide_bvh.h for the idea.

namespace pt {

// A reference from a slot of a node: the index of a node or, with kLeaf, of a block.
using WideRef = std::uint32_t;
inline constexpr WideRef kLeaf = 0x80000000u;
inline constexpr WideRef kNothing = 0xffffffffu;
inline constexpr int kMaxTreeDepth = 80;

inline constexpr float kSphere = -std::numeric_limits<float>::infinity();

// The boxes of up to W children, each bound in a row of its own. Empty slots have min > max.
template <int W>
struct alignas(4 * W) WideNode {
  float bounds[6][W];  // min x y z, max x y z
  WideRef child[W];
};

// Up to W triangles. The third edge, the normal e1 x e2 and everything else follow from e1 = p0 - p1
// and e2 = p2 - p0.
// Empty slots are NaN, which no test accepts. Spheres come first. A sphere has its centre in p0,
// its radius in e1[0], and kSphere as `size`, so that the tests of triangles never accept it.
template <int W>
struct alignas(4 * W) WideBlock {
  float p0[3][W];
  float e1[3][W];
  float e2[3][W];
  float size[W];  // the scale of the errors of edges: E + E^2 / 4, where E is the longer
                  // edge, its components added up
  float area[W];  // the scale of the errors of the plane: N + M / 4, where N is the length of the
                  // normal, and M the sum of |a b| over its six products a b
  std::uint32_t primitive[W];
};

// The tree as a query sees it. Its coordinates are (p - center) * scale, all of them in [-1, 1], so
// that single precision is as good at every scale and anywhere in space.
struct WideView {
  const void* nodes;            // WideNode<width of the kernel>
  const void* blocks;           // WideBlock of the same width
  WideRef root;                 // kNothing where nothing is in the tree
  double center[4];             // x, y, z, and 0
  double scale;                 // a power of two
  const std::uint32_t* beside;  // primitives outside the tree, tested by every query
  std::uint32_t beside_count;
  std::uint32_t triangle_count;
  bool has_spheres;  // in its blocks
};

// A tree and the primitives it was built for.
struct WideQuery {
  const WideView& view;
  const Triangle* triangles;
  const Sphere* spheres;
};

}  // namespace pt
