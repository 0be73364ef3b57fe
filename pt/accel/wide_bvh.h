#pragma once

#include "pt/accel/kernel.h"
#include "pt/geometry/hit.h"
#include "pt/geometry/primitives.h"
#include "pt/geometry/ray.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>

namespace pt {

// The fast engine. A binary tree is collapsed until a node has 8 or 16 children, so that one ray is
// tested against all their boxes at once. A leaf is a block of 8 or 16 triangles, which are tested
// at once too:
//
//          binary                        wide                    a node in memory
//            o                             o                 min x | a b c d e f g h |
//        o       o                  / / | | | | \ \          min y | a b c d e f g h |
//      o   o   o   o       ->      a b c d e f g h           ...
//     a b c d e f g h                                        max z | a b c d e f g h |
//
// All this happens in single precision, with bounds that are too wide rather than too narrow. It
// finds candidates, and marks those that are hit for certain. exact_hit.h then computes the t of
// the nearest hit, and decides uncertain hits, in double precision from the primitive itself. The
// source triangle of a ray is not tested. So the answers are the same as from testing every
// primitive in turn with exact_hit: the smallest t in the ray's range, the smallest index if
// several primitives have the same t, and the same bits on every machine and for every kernel.
//
// A ray may have any range, any origin, and a direction of any length except zero. Surfaces that
// are not finite are never hit. Queries are const and safe from any thread; each needs the same
// primitives that the tree was built for.
class WideBvh {
 public:
  WideBvh() = default;  // of no primitives
  static WideBvh build(const Primitives& primitives) { return build(primitives, best_kernel()); }
  static WideBvh build(const Primitives& primitives, const Kernel& kernel);

  std::optional<Hit> closest(const Primitives& primitives, const Ray& ray) const;
  bool occluded(const Primitives& primitives, const Ray& ray) const;

  // Takes up to 32 rays, best from one point. Bit i says whether ray i is blocked.
  std::uint32_t occluded(const Primitives& primitives, std::span<const Ray> rays) const;

  // The memory that the tree takes, without the primitives.
  std::size_t bytes() const;

  // The data that the kernel's queries read. The tree must have been built. The data is valid as
  // long as the tree lives.
  WideQuery query(const Primitives& primitives) const;

 private:
  struct Tree;
  std::shared_ptr<const Tree> tree_;  // shared by copies, since it never changes
};

}  // namespace pt
