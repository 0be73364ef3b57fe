#include "grader/check/generators/cameras.h"

#include <cmath>
#include <limits>

namespace grader::check {

rc::Gen<pt::Camera> camera() {
  return rc::gen::exec([] {
    pt::Camera made;
    made.position = *point();
    made.camera_to_world = *rotation();
    made.hfov_deg = *real(10, 130);
    made.vfov_deg = *real(10, 130);
    made.near_clip = *real(0, 2);
    made.far_clip = *rc::gen::element(10.0, 1000.0, pt::kInfinity);
    return made;
  });
}

rc::Gen<std::pair<int, int>> many_pixels() {
  return rc::gen::oneOf(rc::gen::pair(whole(66000, 200000), whole(1, 9)),
                        rc::gen::pair(whole(1, 9), whole(66000, 200000)),
                        rc::gen::pair(whole(8000, 30000), whole(8000, 30000)));
}

namespace {

// Half the width and height of the window at distance 1.
pt::Vec2 half_window(const pt::Camera& camera) {
  return {std::tan(camera.hfov_deg * pt::kPi / 360), std::tan(camera.vfov_deg * pt::kPi / 360)};
}

}  // namespace

pt::Vec2 on_window(const pt::Camera& camera, pt::Vec3 direction) {
  const pt::Vec3 local = camera.camera_to_world.to_local(direction);
  const double ahead = local.z < 0 ? -local.z : std::numeric_limits<double>::quiet_NaN();
  const pt::Vec2 half = half_window(camera);
  return {local.x / ahead / half.x, local.y / ahead / half.y};
}

pt::Vec2 on_picture(const pt::Camera& camera, pt::Vec3 direction) {
  const pt::Vec2 at = on_window(camera, direction);
  return {0.5 + 0.5 * at.x, 0.5 + 0.5 * at.y};
}

pt::Vec2 ray_slack(const pt::Camera& camera, int width, int height) {
  const pt::Vec2 half = half_window(camera);
  const double turned = 1e-6 * (1 + half.x * half.x + half.y * half.y);
  return {width * (2e-5 + turned / (2 * half.x)), height * (2e-5 + turned / (2 * half.y))};
}

}  // namespace grader::check
