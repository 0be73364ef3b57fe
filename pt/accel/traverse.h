// The queries of the wide engine. Included once for each instruction set, by kernel_<name>.cpp:
// only the object at the end may have external linkage.
#include "pt/accel/any_hit.h"
#include "pt/accel/closest_hit.h"
#include "pt/accel/group_hit.h"
#include "pt/accel/kernel.h"

namespace pt {
namespace {

WideHit closest(const WideQuery& query, const Ray& ray) {
  const WideView& view = query.view;
  Nearest nearest;
  for (std::uint32_t i = 0; i < view.beside_count; ++i) {
    offer(decide(query, ray, view.beside[i]), view.beside[i], nearest.best);
  }
  FloatRay r;
  if (view.root != kNothing && prepare(view, ray, r)) {
    nearest.t_max = nearest.best.hit.hit ? r.upper(nearest.best.hit.t) : r.t_max;
    search<true>(query, ray, r, nearest);
  }
  return nearest.best;
}

bool occluded(const WideQuery& query, const Ray& ray) { return any_hit(query, ray); }

std::uint32_t occluded_batch(const WideQuery& query, const Ray* rays, int count) {
  std::uint32_t blocked = 0;
  for (int i = 0; i < count; i += kGroup) {
    const int group = count - i < kGroup ? count - i : kGroup;
    blocked |= any_hits(query, rays + i, group) << i;
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
