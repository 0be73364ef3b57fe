// Tests whether anything is in the way of each of up to kGroup rays. Internal like simd.h.
//
// If a ray goes down the tree alone, its tests wait for each other, and a processor predicts its
// next step badly. Here all rays take their steps together, and no ray's step depends on another's.
// Groups from one point to one light spend most of their tests in leaves right below the root that
// several rays enter: there the pyramid around the rays rules out nearly all triangles at once.
#pragma once

#include "pt/accel/any_hit.h"
#include "pt/accel/huge_pages.h"
#include "pt/accel/pyramid.h"

namespace pt {
namespace {

// Pairs of a ray and a node or block that it still has to visit. They are written in whole vectors.
template <int N>
struct Visits {
  int size = 0;
  WideRef ref[N + kWidth];
  std::int32_t ray[N + kWidth];

  void add(WideRef what, int i) {
    ref[size] = what;
    ray[size++] = i;
  }
  // The children of `mask`, in any order.
  void add(const Node& node, std::uint32_t mask, int i) {
    copy_packed<kWidth>(node.child, mask, ref + size);
    const Ints<kWidth> all = Ints<kWidth>{} + i;
    __builtin_memcpy(ray + size, &all, sizeof all);
    size += __builtin_popcount(mask);
  }
};

// Eight visits at a time are taken off the end and replaced by up to kWidth times as many, one
// level further down.
constexpr int kNodeVisits = kGroup * (kWidth - 1) * kMaxTreeDepth + kGroup;
constexpr int kBlockVisits = kGroup * kWidth;

// The memory that a query of a group writes. If a load and an earlier store have the same place
// within different pages, a processor may take them for one address, and waits (4K aliasing). The
// root, which every ray reads, begins a page (huge_pages.h). So this begins a page too, and does not
// use the root's part of it. Without this, one run in 64 took 1.5 times as long.
struct alignas(kSmallPage) GroupWork {
  char root[sizeof(Node)];
  FloatRay r[kGroup];
  Visits<kBlockVisits> leaves;
  Visits<kNodeVisits> inner;
};

// If at least this many rays are in one leaf, they are tested together.
constexpr int kCrowd = 3;

PT_INLINE std::uint32_t leaf_children(const Node& node) {
  static_assert(kLeaf == 1u << 31);
  return bits<kWidth>(children(node));
}

// The rays `those` enter the block. Either each ray is tested against all triangles, later, or all
// rays against the triangles that they may meet, whichever are fewer tests. Returns the blocked
// rays.
template <bool kSpheres, bool kWalls>
PT_INLINE std::uint32_t meet_block(const WideQuery& query, const Ray* rays, const Pyramid& pyramid,
                                   WideRef ref, std::uint32_t those, GroupWork& work) {
  const Block& block = static_cast<const Block*>(query.view.blocks)[ref & ~kLeaf];
  std::uint32_t slots = test_block<kSpheres, kWalls>(block, pyramid);
  if (__builtin_popcount(slots) > __builtin_popcount(those)) {
    for (; those != 0; those &= those - 1) work.leaves.add(ref, __builtin_ctz(those));
    return 0;
  }
  std::uint32_t blocked = 0;
  for (; slots != 0; slots &= slots - 1) {
    const int slot = __builtin_ctz(slots);
    const Verdict<kGroup> verdict = test_slot<kSpheres>(block, slot, pyramid, work.r[0]);
    std::uint32_t maybe = verdict.maybe & those;
    if (maybe == 0) continue;
    const std::uint32_t surely = maybe & verdict.surely();
    blocked |= surely;
    for (maybe &= ~surely; maybe != 0; maybe &= maybe - 1) {
      const int i = __builtin_ctz(maybe);
      if (decide(query, rays[i], block.primitive[slot]).hit) blocked |= 1u << i;
    }
  }
  return blocked;
}

// The first step of rays from one point, if the root is a block.
PT_INLINE std::uint32_t meet_root(const WideQuery& query, const Ray* rays, int count,
                                  GroupWork& work) {
  if (count < kCrowd) {
    for (int i = 0; i < count; ++i) work.leaves.add(query.view.root, i);
    return 0;
  }
  const Pyramid pyramid = pyramid_of(work.r, count);
  return meet_block<true, true>(query, rays, pyramid, query.view.root, (1u << count) - 1, work);
}

// The first step of rays from one point. Returns the blocked rays.
template <bool kSpheres>
PT_INLINE std::uint32_t enter_root(const WideQuery& query, const Ray* rays, int count,
                                   GroupWork& work) {
  const Node& root = static_cast<const Node*>(query.view.nodes)[query.view.root];
  const std::uint32_t leaf = leaf_children(root);
  std::uint32_t entered[kGroup];
  Ints<kWidth> who{};  // bit i of a child's lane: ray i enters it
  for (int i = 0; i < count; ++i) {
    entered[i] = enter_children(root, work.r[i], work.r[i].t_max).mask;
    who |= lanes<kWidth>(entered[i]) & (1 << i);
  }
  const Ints<kWidth> but_one = who & (who - 1), but_two = but_one & (but_one - 1);
  std::uint32_t crowded = leaf & bits<kWidth>(-but_two);
  const std::uint32_t entered_by_any = bits<kWidth>(-who);
  if ((entered_by_any & ~leaf) != 0) {
    for (int i = 0; i < count; ++i) work.inner.add(root, entered[i] & ~leaf, i);
  }
  if ((entered_by_any & leaf & ~crowded) != 0) {
    for (int i = 0; i < count; ++i) work.leaves.add(root, entered[i] & leaf & ~crowded, i);
  }
  if (crowded == 0) return 0;
  const Pyramid pyramid = pyramid_of(work.r, count);
  std::uint32_t those[kWidth];
  __builtin_memcpy(those, &who, sizeof those);
  std::uint32_t blocked = 0;
  for (; crowded != 0; crowded &= crowded - 1) {
    const int child = __builtin_ctz(crowded);
    blocked |= meet_block<kSpheres, false>(query, rays, pyramid, root.child[child],
                                           those[child] & ~blocked, work);
  }
  return blocked;
}

// Prepares rays that differ only in their direction. Returns false if they differ otherwise, or are
// not usual.
PT_INLINE bool prepare_alike(const WideView& view, const Ray* rays, int count, FloatRay* r) {
  if (!are_alike(rays, count) || !prepare(view, rays[0], r[0]) || !r[0].is_usual) return false;
  bool usual = true;
  for (int i = 1; i < count; ++i) usual &= prepare_like(r[0], view, rays[i], r[i]);
  return usual;
}

// Prepares rays of any kind, and begins with them at the root. Returns the blocked rays.
PT_INLINE std::uint32_t enter_any(const WideQuery& query, const Ray* rays, int count,
                                  GroupWork& work) {
  const WideView& view = query.view;
  std::uint32_t blocked = 0;
  for (int i = 0; i < count; ++i) {
    bool beside = false;
    for (std::uint32_t k = 0; k < view.beside_count; ++k) {
      beside = beside || decide(query, rays[i], view.beside[k]).hit;
    }
    if (beside) {
      blocked |= 1u << i;
    } else if (view.root != kNothing && prepare(view, rays[i], work.r[i])) {
      if (view.root & kLeaf) {
        work.leaves.add(view.root, i);
      } else {
        work.inner.add(view.root, i);
      }
    }
  }
  return blocked;
}

// Makes the remaining visits of the rays that are not `blocked`, and returns the mask of all rays
// that are blocked afterwards.
template <bool kSpheres>
PT_INLINE std::uint32_t finish(const WideQuery& query, const Ray* rays, std::uint32_t blocked,
                               GroupWork& work) {
  const Node* nodes = static_cast<const Node*>(query.view.nodes);
  const Block* blocks = static_cast<const Block*>(query.view.blocks);
  for (;;) {
    for (int k = 0; k < work.leaves.size; ++k) {
      const int i = work.leaves.ray[k];
      const Block& block = blocks[work.leaves.ref[k] & ~kLeaf];
      const bool hit = is_blocked<kSpheres>(query, rays[i], work.r[i], block);
      blocked |= static_cast<std::uint32_t>(hit) << i;
    }
    work.leaves.size = 0;
    if (work.inner.size == 0) return blocked;
    const int count = work.inner.size < kGroup ? work.inner.size : kGroup;
    WideRef ref[kGroup];
    std::int32_t ray[kGroup];
    work.inner.size -= count;
    __builtin_memcpy(ref, work.inner.ref + work.inner.size, sizeof ref);
    __builtin_memcpy(ray, work.inner.ray + work.inner.size, sizeof ray);
    for (int k = 0; k < count; ++k) {
      const int i = ray[k];
      if (blocked >> i & 1) continue;
      const Node& node = nodes[ref[k]];
      const std::uint32_t mask = enter_children(node, work.r[i], work.r[i].t_max).mask;
      const std::uint32_t leaf = leaf_children(node);
      work.inner.add(node, mask & ~leaf, i);
      work.leaves.add(node, mask & leaf, i);
    }
  }
}

// Bit i of the result says whether ray i is blocked.
PT_INLINE std::uint32_t any_hits(const WideQuery& query, const Ray* rays, int count) {
  const WideView& view = query.view;
  GroupWork work;
  const bool alike =
      view.beside_count == 0 && view.root != kNothing && prepare_alike(view, rays, count, work.r);
  std::uint32_t blocked = 0;
  if (!alike) {
    blocked = enter_any(query, rays, count, work);
  } else if (view.root & kLeaf) {
    blocked = meet_root(query, rays, count, work);
  } else {
    blocked = view.has_spheres ? enter_root<true>(query, rays, count, work)
                               : enter_root<false>(query, rays, count, work);
  }
  return view.has_spheres ? finish<true>(query, rays, blocked, work)
                          : finish<false>(query, rays, blocked, work);
}

}  // namespace
}  // namespace pt
