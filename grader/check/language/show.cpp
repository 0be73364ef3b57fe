#include "grader/check/language/show.h"

#include <fmt/format.h>

namespace grader::check {

std::string show(double value) { return fmt::format("{}", value); }

std::string show(pt::Vec2 v) { return fmt::format("({}, {})", v.x, v.y); }

std::string show(pt::Vec3 v) { return fmt::format("({}, {}, {})", v.x, v.y, v.z); }

std::string show(pt::Rgb c) { return fmt::format("(r {}, g {}, b {})", c.r, c.g, c.b); }

std::string show(const pt::Ray& ray) {
  return fmt::format("Ray from {} along {}, t in [{}, {}]", show(ray.origin), show(ray.direction),
                     ray.t_min, ray.t_max);
}

std::string show(const pt::Triangle& t) {
  return fmt::format("Triangle {} {} {}, normals {} {} {}", show(t.p0), show(t.p1), show(t.p2),
                     show(t.n0), show(t.n1), show(t.n2));
}

std::string show(const pt::Sphere& sphere) {
  return fmt::format("Sphere around {}, radius {}", show(sphere.center), sphere.radius);
}

std::string show(const pt::Box& box) {
  return fmt::format("Box from {} to {}", show(box.min), show(box.max));
}

std::string show(const pt::SurfaceHit& hit) {
  return fmt::format("t {}, n {}", hit.t, show(hit.n));
}

std::string show(const pt::SurfacePoint& point) {
  return fmt::format("point {}, n {}, wo {}, albedo {}, emission {}", show(point.p), show(point.n),
                     show(point.wo), show(point.albedo), show(point.emission));
}

std::string show(const pt::Camera& c) {
  return fmt::format(
      "Camera at {}, right {}, up {}, back {}, field of view {} x {} degrees, clip [{}, {}]",
      show(c.position), show(c.camera_to_world.x), show(c.camera_to_world.y),
      show(c.camera_to_world.z), c.hfov_deg, c.vfov_deg, c.near_clip, c.far_clip);
}

// Adding zero turns -0 into 0.
std::string brief(double value) { return fmt::format("{:.5g}", value + 0.0); }

std::string brief(pt::Vec3 v) {
  return fmt::format("({}, {}, {})", brief(v.x), brief(v.y), brief(v.z));
}

std::string brief(pt::Rgb c) {
  return fmt::format("(r {}, g {}, b {})", brief(c.r), brief(c.g), brief(c.b));
}

}  // namespace grader::check
