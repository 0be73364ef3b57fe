#include "grader/check/language/property.h"
#include "grader/tasks/camera_ray/inputs.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

// The picture is judged with a camera at the world's origin that is not turned. Differences between
// rays are judged relative to the task's own rays. The promises starts_at_the_camera and
// turns_with_the_camera judge cameras that are moved and turned.

namespace grader::check {
namespace {

using namespace camera_ray_inputs;

// The ray of a call that follows another one. A first call has nothing in common with either, so each
// pair is a case of its own.
pt::Ray second_ray(const InTurn<Aimed>& calls) {
  call({{{7, 8, 9}, {{0, 1, 0}, {0, 0, 1}, {1, 0, 0}}, 33, 44, 5, 6}, {0.125, 0.375}});
  call(calls.before);
  return call(calls.now);
}

// Checks the ray of a call, and then the ray of a call that follows another one.
template <class Check>
void for_all_calls(const rc::Gen<Aimed>& calls, const Check& check, int cases = 100) {
  for_all(
      [&] {
        const Aimed aimed = *calls;
        check(aimed, call(aimed));
      },
      cases);
  for (const auto& other : {&changed, &exchanged}) {
    if (testing::Test::HasFailure()) return;
    for_all(
        [&] {
          const auto both = *in_turn(calls, other);
          check(both.now, second_ray(both));
        },
        cases);
  }
}

PROMISE(camera_ray, starts_at_the_camera) {
  for_all_calls(aimed(moved()), [](const Aimed& aimed, const pt::Ray& ray) {
    const pt::Vec3 position = aimed.camera.position;
    expect_near("the origin", ray.origin, position, kSingle * length(position));
  });
}

// One direction for the whole picture would keep all promises about single rays.
void expect_a_picture() {
  const pt::Camera camera{{}, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, 60, 45, 0, pt::kInfinity};
  const pt::Vec3 left = pt::camera_ray(camera, 0.25, 0.5).direction;
  const pt::Vec3 right = pt::camera_ray(camera, 0.75, 0.5).direction;
  expect(length(right - left) > 0.1,
         "different directions through x = 0.25 and x = 0.75 of a picture 60 degrees wide; the "
         "promise is judged only for rays that differ",
         show(left) + " and " + show(right));
}

PROMISE(camera_ray, has_a_unit_direction) {
  once(expect_a_picture);
  if (testing::Test::HasFailure()) return;
  for_all([] {
    expect_near("the length of the direction", length(call(*aimed(moved())).direction), 1,
                kPrecision);
  });
}

PROMISE(camera_ray, looks_along_minus_z) {
  once(expect_a_picture);
  if (testing::Test::HasFailure()) return;
  for_all([] {
    const pt::Camera c = *unmoved();
    const Window window = window_of(c);
    expect_near("the direction through the centre, of a camera that is not turned",
                normalize(pt::camera_ray(c, 0.5, 0.5).direction), {0, 0, -1},
                kSingle + kPrecision * std::max(window.width, window.height));
  });
}

// Judges the angle from the centre to an edge, on one axis of the window. It allows the error of
// the edge and the actual error of the centre ray, each up to the contract's precision.
void expect_half_angle(const std::string& edge, double fov_deg, double edge_at, double centre_at,
                       double size) {
  const double right = size / 2, precise = tolerance(size, {right, 0});
  const double slack = (precise + std::min(std::abs(centre_at), precise)) / (1 + right * right);
  const double tangent = std::abs(edge_at - centre_at), angle = std::atan(tangent) / radians(1);
  try {
    expect_near("degrees from the centre of the picture to its " + edge + " edge", angle,
                fov_deg / 2, slack / radians(1));
  } catch (CaseFailed& failed) {
    failed.failure.off_by +=
        fmt::format(" (the angle is {:.4g} times the expected one, its tangent {:.4g} times)",
                    angle / (fov_deg / 2), tangent / right);
    throw;
  }
}

PROMISE(camera_ray, fills_the_field_of_view) {
  for_all([] {
    const pt::Camera c = *unmoved();
    const Window window = window_of(c);
    const auto at = [&](double x, double y) { return on_plane(pt::camera_ray(c, x, y).direction); };
    const pt::Vec2 centre = at(0.5, 0.5);
    expect_half_angle("left", c.hfov_deg, at(0, 0.5).x, centre.x, window.width);
    expect_half_angle("right", c.hfov_deg, at(1, 0.5).x, centre.x, window.width);
    expect_half_angle("bottom", c.vfov_deg, at(0.5, 0).y, centre.y, window.height);
    expect_half_angle("top", c.vfov_deg, at(0.5, 1).y, centre.y, window.height);
  });
  // The window of another camera, or another point of it, is forgotten.
  for (const auto& other : {&changed, &exchanged}) {
    for_all([=] {
      const auto calls = *in_turn(aimed(unmoved()), other);
      const auto& [c, at] = calls.now;
      const Window window = window_of(c);
      const pt::Vec2 right{(at.x - 0.5) * window.width, (at.y - 0.5) * window.height};
      const pt::Vec2 got = on_plane(second_ray(calls).direction);
      expect_near("x on the window, from its centre", got.x, right.x,
                  4 * tolerance(window.width, right));
      expect_near("y on the window, from its centre", got.y, right.y,
                  4 * tolerance(window.height, right));
    });
  }
}

PROMISE(camera_ray, puts_x_to_the_right_and_y_up) {
  for_all([] {
    const pt::Camera c = *unmoved();
    const auto at = [&](double x, double y) { return on_plane(pt::camera_ray(c, x, y).direction); };
    const double low = draw("the smaller of two x, and of two y", real(0, 0.4));
    const double high = low + draw("their difference", real(0.2, 0.6));
    const pt::Vec2 first = at(low, low), second = at(high, high);
    expect(
        second.x > first.x, "the larger x to be farther to the right",
        show(first.x) + " on the window for the smaller x, " + show(second.x) + " for the larger");
    expect(
        second.y > first.y, "the larger y to be farther up",
        show(first.y) + " on the window for the smaller y, " + show(second.y) + " for the larger");
  });
}

void expect_flat(const pt::Camera& c, double x, double y) {
  const Window window = window_of(c);
  const auto at = [&](double u, double v) { return on_plane(pt::camera_ray(c, u, v).direction); };
  const pt::Vec2 corner = at(0, 0), right = at(1, 0), up = at(0, 1), got = at(x, y);
  expect(right.x != corner.x && up.y != corner.y, "different rays through different corners",
         "the same ray");
  const pt::Vec2 farthest{window.width / 2, window.height / 2};
  expect_near("x on the window, compared with its corners", got.x,
              corner.x + x * (right.x - corner.x) + y * (up.x - corner.x),
              4 * tolerance(window.width, farthest));
  expect_near("y on the window, compared with its corners", got.y,
              corner.y + x * (right.y - corner.y) + y * (up.y - corner.y),
              4 * tolerance(window.height, farthest));
}

PROMISE(camera_ray, keeps_the_picture_flat) {
  for_all(
      [] {
        const Aimed c = *aimed(unmoved());
        expect_flat(c.camera, c.at.x, c.at.y);
      },
      300);
}

void expect_turned(const Aimed& aimed, const pt::Ray& ray) {
  const pt::Camera& c = aimed.camera;
  Aimed moved_back = aimed;
  moved_back.camera.position = {};
  moved_back.camera.camera_to_world = {};
  const pt::Camera& at_origin = moved_back.camera;
  const pt::Vec3 direction = normalize(ray.direction);
  const pt::Vec3 unturned = normalize(call(moved_back).direction);
  const Window window = window_of(c);
  expect_near("the direction in the camera's frame, compared with a camera that is not turned",
              c.camera_to_world.to_local(direction), unturned,
              2 * (kSingle + kPrecision * std::max(window.width, window.height)));
  // A direction that ignores both the frame and (x, y) would also pass the check above.
  expect(pt::camera_ray(at_origin, 0, 0).direction != pt::camera_ray(at_origin, 1, 1).direction,
         "different rays through opposite corners of the picture", "the same ray");
}

PROMISE(camera_ray, turns_with_the_camera) {
  for_all_calls(aimed(moved()), expect_turned);
  // Among these are cameras that look straight up and straight down.
  for (int number = 0; number < kAxisFrames; ++number) {
    if (testing::Test::HasFailure()) return;
    for_all_calls(aimed(along_the_axes(number)), expect_turned, 2);
  }
}

PROMISE(camera_ray, keeps_the_clip_range) {
  for_all_calls(aimed(moved()), [](const Aimed& aimed, const pt::Ray& ray) {
    const pt::Camera& c = aimed.camera;
    expect_near("t_min", ray.t_min, c.near_clip, kSingle * c.near_clip);
    expect(ends_at(ray.t_max, c.far_clip), "t_max " + show(c.far_clip), "t_max " + show(ray.t_max));
  });
}

}  // namespace
}  // namespace grader::check
