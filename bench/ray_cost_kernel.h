// The steps of a query, each a contender of its own. Included once for each instruction set, by
// ray_cost_<name>.cpp, like pt/accel/traverse.h: only the object at the end has external linkage.
#include "bench/ray_cost.h"
#include "pt/accel/any_hit.h"
#include "pt/accel/closest_hit.h"
#include "pt/accel/group_hit.h"

namespace pt {
namespace {

// The cost of a query that does nothing: the call, reading the ray, copying the result.
WideHit call(const WideQuery& query, const Ray& ray) {
  return {{false, ray.t_max, ray.t_min, ray.direction.x, 0}, query.view.root};
}

WideHit to_frame(const WideQuery& query, const Ray& ray) {
  const Doubles4 o = (load3(&ray.origin.x) - load3(query.view.center)) * query.view.scale;
  const Doubles4 d = load3(&ray.direction.x) * query.view.scale;
  const Floats4 sum = __builtin_convertvector(o, Floats4) + __builtin_convertvector(d, Floats4);
  return {{false, sum[0], 0, 0, 0}, 0};
}

WideHit prepared(const WideQuery& query, const Ray& ray) {
  FloatRay r;
  const bool any = prepare(query.view, ray, r);
  return {{any, r.enter[0] + r.leave[1] + r.t_max, 0, 0, 0}, 0};
}

// The whole search in single precision, with only the decisions that it needs.
WideHit found(const WideQuery& query, const Ray& ray) {
  Nearest nearest;
  FloatRay r;
  if (prepare(query.view, ray, r)) {
    nearest.t_max = r.t_max;
    search<false>(query, ray, r, nearest);
  }
  return {{nearest.best.hit.hit, nearest.t_max, 0, 0, 0}, nearest.sure};
}

}  // namespace

#define PT_JOIN(a, b) a##b
#define PT_SYMBOL(isa) PT_JOIN(ray_steps_, isa)

extern const RaySteps PT_SYMBOL(PT_KERNEL);
const RaySteps PT_SYMBOL(PT_KERNEL) = {call, to_frame, prepared, found};

}  // namespace pt
