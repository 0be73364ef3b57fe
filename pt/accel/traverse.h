// The queries of the wide engine. Included once for each instruction set, by kernel_<name>.cpp:
// nothing here may have external linkage but the one object at the end.
#include "pt/accel/block_test.h"
#include "pt/accel/exact_hit.h"
#include "pt/accel/float_ray.h"
#include "pt/accel/kernel.h"
#include "pt/accel/simd.h"

namespace pt {
namespace {

#if defined(__AVX512F__)
constexpr int kWidth = 16;
#else
constexpr int kWidth = 8;
#endif

using Node = WideNode<kWidth>;
using NodeFloats = Floats<kWidth>;

// A child to be visited: the bits of the distance at which the ray enters it, which order like the
// distance itself because it is not negative, and then the child.
using Entry = std::uint64_t;
constexpr int kStack = kMaxTreeDepth * (kWidth - 1) + 1;

PT_INLINE Entry entry(float t, WideRef ref) {
  return static_cast<Entry>(__builtin_bit_cast(std::uint32_t, t)) << 32 | ref;
}
PT_INLINE WideRef ref_of(Entry e) { return static_cast<WideRef>(e); }
PT_INLINE float distance_of(Entry e) {
  return __builtin_bit_cast(float, static_cast<std::uint32_t>(e >> 32));
}

// Which row of the bounds the ray meets first on each axis, and last.
struct Rows {
  int near[3];
  int far[3];
};
PT_INLINE Rows rows(const FloatRay& r) {
  Rows rows;
  const Ints4 down = (Ints4)r.inverse < 0;  // the sign, as all bits
  for (int a = 0; a < 3; ++a) {
    rows.near[a] = a + (down[a] & 3);
    rows.far[a] = a + (~down[a] & 3);
  }
  return rows;
}

// The children whose boxes the ray enters, as bits, and where.
PT_INLINE std::uint32_t enter_children(const Node& node, const FloatRay& r, const Rows& rows,
                                       float t_max, float* t_enter) {
  NodeFloats enter = splat<kWidth>(r.t_min), leave = splat<kWidth>(t_max);
  for (int a = 0; a < 3; ++a) {
    const NodeFloats inverse = splat<kWidth>(r.inverse[a]);
    const NodeFloats near = load<kWidth>(node.bounds[rows.near[a]]);
    const NodeFloats far = load<kWidth>(node.bounds[rows.far[a]]);
    enter = max<kWidth>(multiply_add<kWidth>(near, inverse, splat<kWidth>(r.enter[a])), enter);
    leave = min<kWidth>(multiply_add<kWidth>(far, inverse, splat<kWidth>(r.leave[a])), leave);
  }
  store<kWidth>(t_enter, enter);
  return less_equal<kWidth>(enter, leave);
}

PT_INLINE ExactHit decide(const WideQuery& query, const Ray& ray, std::uint32_t primitive) {
  if (primitive < query.view.triangle_count) return exact_hit(query.triangles[primitive], ray);
  return exact_hit(query.spheres[primitive - query.view.triangle_count], ray);
}

// Of several hits at the same t, the primitive with the smallest index counts.
PT_INLINE bool offer(const WideQuery& query, const Ray& ray, std::uint32_t primitive,
                     WideHit& best) {
  const ExactHit hit = decide(query, ray, primitive);
  if (!hit.hit || hit.t > best.hit.t || (hit.t == best.hit.t && primitive > best.primitive)) {
    return false;
  }
  best = {hit, primitive};
  return true;
}

// Asks the cache for a child that is visited later.
PT_INLINE void prefetch(const WideQuery& query, WideRef ref) {
  const auto* node = static_cast<const char*>(query.view.nodes) + sizeof(Node) * ref;
  const auto* block = reinterpret_cast<const char*>(query.view.blocks + (ref & ~kLeaf));
  const char* start = ref & kLeaf ? block : node;
  for (int line = 0; line < 7; ++line) __builtin_prefetch(start + 64 * line);
}

// Pushes all children but the nearest, the farther the deeper, and returns the nearest.
PT_INLINE WideRef sort_children(const WideQuery& query, const Node& node, const float* t_enter,
                                std::uint32_t mask, Entry* stack, int& size) {
  int i = __builtin_ctz(mask);
  mask &= mask - 1;
  if (mask == 0) return node.child[i];
  Entry nearest = entry(t_enter[i], node.child[i]);
  const int base = size;
  for (; mask != 0; mask &= mask - 1) {
    i = __builtin_ctz(mask);
    Entry other = entry(t_enter[i], node.child[i]);
    if (other < nearest) {
      const Entry swapped = nearest;
      nearest = other;
      other = swapped;
    }
    prefetch(query, ref_of(other));
    int at = size++;
    for (; at > base && stack[at - 1] < other; --at) stack[at] = stack[at - 1];
    stack[at] = other;
  }
  return ref_of(nearest);
}

PT_INLINE void trace_closest(const WideQuery& query, const Ray& ray, const FloatRay& r,
                             WideHit& best) {
  const Rows order = rows(r);
  const Node* nodes = static_cast<const Node*>(query.view.nodes);
  float t_max = best.hit.hit ? r.upper(best.hit.t) : r.t_max;
  Entry stack[kStack];
  int size = 0;
  WideRef ref = query.view.root;
  for (;;) {
    if (!(ref & kLeaf)) {
      alignas(64) float t_enter[kWidth];
      const std::uint32_t mask = enter_children(nodes[ref], r, order, t_max, t_enter);
      if (mask != 0) {
        ref = sort_children(query, nodes[ref], t_enter, mask, stack, size);
        continue;
      }
    } else {
      const WideBlock& block = query.view.blocks[ref & ~kLeaf];
      std::uint32_t mask = test_block(block, r, t_max, false).maybe;
      for (; mask != 0; mask &= mask - 1) {
        if (offer(query, ray, block.primitive[__builtin_ctz(mask)], best)) {
          t_max = r.upper(best.hit.t);
        }
      }
    }
    do {
      if (size == 0) return;
      --size;
    } while (distance_of(stack[size]) > t_max);
    ref = ref_of(stack[size]);
  }
}

PT_INLINE bool blocked_by(const WideQuery& query, const Ray& ray, const FloatRay& r,
                          const WideBlock& block) {
  const Verdict verdict = test_block(block, r, r.t_max, true);
  if (verdict.surely != 0) return true;
  for (std::uint32_t mask = verdict.maybe; mask != 0; mask &= mask - 1) {
    if (decide(query, ray, block.primitive[__builtin_ctz(mask)]).hit) return true;
  }
  return false;
}

// The block that blocks the ray, or kNothing.
PT_INLINE WideRef trace_any(const WideQuery& query, const Ray& ray, const FloatRay& r) {
  const Rows order = rows(r);
  const Node* nodes = static_cast<const Node*>(query.view.nodes);
  WideRef stack[kStack];
  int size = 0;
  WideRef ref = query.view.root;
  for (;;) {
    if (!(ref & kLeaf)) {
      alignas(64) float t_enter[kWidth];
      std::uint32_t mask = enter_children(nodes[ref], r, order, r.t_max, t_enter);
      if (mask != 0) {
        const Node& node = nodes[ref];
        ref = node.child[__builtin_ctz(mask)];
        for (mask &= mask - 1; mask != 0; mask &= mask - 1) {
          stack[size++] = node.child[__builtin_ctz(mask)];
          prefetch(query, stack[size - 1]);
        }
        continue;
      }
    } else if (blocked_by(query, ray, r, query.view.blocks[ref & ~kLeaf])) {
      return ref;
    }
    if (size == 0) return kNothing;
    ref = stack[--size];
  }
}

WideHit closest(const WideQuery& query, const Ray& ray) {
  WideHit best{{false, kInfinity, 0, 0, 0}, kNothing};
  const WideView& view = query.view;
  for (std::uint32_t i = 0; i < view.beside_count; ++i) offer(query, ray, view.beside[i], best);
  FloatRay r;
  if (view.root != kNothing && prepare(view, ray, r)) trace_closest(query, ray, r, best);
  return best;
}

// `hint` is a block that blocked a ray like this one, or kNothing; it becomes the one found.
PT_INLINE bool occluded_after(const WideQuery& query, const Ray& ray, WideRef& hint) {
  for (std::uint32_t i = 0; i < query.view.beside_count; ++i) {
    if (decide(query, ray, query.view.beside[i]).hit) return true;
  }
  FloatRay r;
  if (query.view.root == kNothing || !prepare(query.view, ray, r)) return false;
  if (hint != kNothing && blocked_by(query, ray, r, query.view.blocks[hint & ~kLeaf])) return true;
  const WideRef found = trace_any(query, ray, r);
  if (found != kNothing) hint = found;
  return found != kNothing;
}

bool occluded(const WideQuery& query, const Ray& ray) {
  WideRef hint = kNothing;
  return occluded_after(query, ray, hint);
}

// Rays from one point towards one light are often blocked by the same few triangles: the block that
// stopped the last one is asked first.
std::uint32_t occluded_batch(const WideQuery& query, const Ray* rays, int count) {
  WideRef hint = kNothing;
  std::uint32_t blocked = 0;
  for (int i = 0; i < count; ++i) {
    blocked |= static_cast<std::uint32_t>(occluded_after(query, rays[i], hint)) << i;
  }
  return blocked;
}

}  // namespace

// Names the instruction set in the symbol too: kernel_plain, kernel_v2, ...
#define PT_JOIN(a, b) a##b
#define PT_SYMBOL(isa) PT_JOIN(kernel_, isa)
#define PT_TEXT(isa) #isa
#define PT_NAME(isa) PT_TEXT(isa)

extern const Kernel PT_SYMBOL(PT_KERNEL);
const Kernel PT_SYMBOL(PT_KERNEL) = {PT_NAME(PT_KERNEL), kWidth, closest, occluded, occluded_batch};

}  // namespace pt
