#include "grader/property/generators.h"
#include "grader/property/property.h"
#include "pt/tasks/hit_sphere.h"

namespace grader {
namespace {

// A sphere, and a ray from outside at a point of its visible half.
struct Aimed {
  pt::Sphere sphere;
  pt::Ray ray;
  double t;
};

void showValue(const Aimed& aimed, std::ostream& out) { show_lines(out, aimed.sphere, aimed.ray); }

rc::Gen<Aimed> aimed_from_outside() {
  return rc::gen::exec([] {
    const pt::Sphere sphere{*point(), *magnitude(1e-3, 1e3)};
    const pt::Vec3 n = *direction();
    const pt::Frame around = pt::frame_from_normal(n);
    const double distance = sphere.radius * *magnitude(1e-2, 1e2);
    const double tilt = *real(-1.4, 1.4);
    const pt::Vec3 towards = -std::cos(tilt) * n + std::sin(tilt) * around.x;
    const pt::Vec3 target = sphere.center + sphere.radius * n;
    const double speed = *magnitude(1e-3, 1e3);
    return Aimed{sphere, {target - distance * towards, speed * towards}, distance / speed};
  });
}

PROMISE(hit_sphere, hits_where_it_is_aimed) {
  for_all([] {
    const Aimed aimed = *aimed_from_outside();
    const auto hit = pt::hit_sphere(aimed.sphere, aimed.ray);
    expect(hit.has_value(), "a hit", "none");
    expect_near("t at the point aimed at", hit->t, aimed.t, 1e-9 * aimed.t);
  });
}

}  // namespace
}  // namespace grader
