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
// tested against all their boxes at once, and a leaf is a block of as many triangles that are
// tested at once too:
//
//          binary                        wide                    a node in memory
//            o                             o                 min x | a b c d e f g h |
//        o       o                  / / | | | | \ \          min y | a b c d e f g h |
//      o   o   o   o       ->      a b c d e f g h           ...
//     a b c d e f g h                                        max z | a b c d e f g h |
//
// All this happens in single precision, with bounds that err on the safe side only: it finds
// candidates, and tells those that are hit for certain. The t of the nearest hit, and each hit that
// is not certain, is decided in double precision by exact_hit.h from the primitive itself. The
// source triangle of a ray is not tested. So the answers are those of testing every primitive in
// turn with exact_hit: the smallest t in the ray's range, of several at the same t the primitive
// with the smallest index, and the same bits on every machine and for every kernel.
//
// Any ray will do: of any range and origin, with a direction of any length but zero. Surfaces that
// are not finite are never hit. Queries are const and safe from any thread; each is handed the same
// primitives that the tree was built for.
class WideBvh {
 public:
  WideBvh() = default;  // of no primitives
  static WideBvh build(const Primitives& primitives) { return build(primitives, best_kernel()); }
  static WideBvh build(const Primitives& primitives, const Kernel& kernel);

  std::optional<Hit> closest(const Primitives& primitives, const Ray& ray) const;
  bool occluded(const Primitives& primitives, const Ray& ray) const;

  // For up to 32 rays, best from one point: bit i says whether ray i is blocked.
  std::uint32_t occluded(const Primitives& primitives, std::span<const Ray> rays) const;

  // The memory that it takes, beside the primitives.
  std::size_t bytes() const;

  // The data that the kernel's queries read. Needs a tree that was built, and is valid as long as
  // that tree lives.
  WideQuery query(const Primitives& primitives) const;

 private:
  struct Tree;
  std::shared_ptr<const Tree> tree_;  // shared by copies, since it never changes
};

}  // namespace pt
