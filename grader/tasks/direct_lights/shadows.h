#pragma once

#include "grader/check/scenes/closed_forms.h"
#include "grader/tasks/direct_lights/inputs.h"

#include <cmath>

// Surfaces that hide lights from the shaded point, in whole or in part.

namespace grader::check::direct_lights_inputs {

// The same scene with black as the right answer. It is for a surface that hides all light and that
// the maker did not take into account.
inline Situation dark(Situation s) {
  s.expected = {};
  s.facing = {};
  return s;
}

// The place of a surface that hides a light, as a part of the way to it: in the middle, close to the
// point or just in front of the light.
inline double any_way() { return *rc::gen::element(0.5, 0.01, 0.99, 0.999); }

inline void half_hidden_lamp(SceneMaker& maker) {
  maker.rectangle(*rectangle_above(0.8, 0.3, 1.5), any_radiance(), Body::none, *real(0.25, 0.75),
                  any_way());
}

inline void half_hidden_mesh(SceneMaker& maker) {
  any_mesh(maker, *rectangle_above(0.8, 0.3, 1.5), any_radiance(), Body::none, *real(0.25, 0.75),
           any_way());
}

inline void half_hidden_mesh_of_many_faces(SceneMaker& maker) {
  maker.mesh(*rectangle_above(0.8, 0.3, 1.5), any_radiance(), Body::none, *real(0.25, 0.75),
             any_way(), {*whole(129, 700), *real(1.5, 3)});
}

// A level patch in a dark room whose walls end above the floor. The sky is seen only below them.
inline rc::Gen<Situation> sky_below_the_walls() {
  return rc::gen::exec([] {
    SceneMaker maker({pt::frame_from_normal({0, 1, 0}), *point(), *magnitude(1e-2, 1e2)});
    const pt::Rgb radiance = any_radiance();
    const double height = *magnitude(0.1, 0.8);
    double cosine = 0;
    for (const Rectangle& wall : cube()) {
      const auto part = [&](double low, double high) {
        return wall.u.z > 0 ? wall.part(low, high, 0, 1) : wall.part(0, 1, low, high);
      };
      if (wall.center.z == 1) maker.surface(wall, pt::gray(0.5));
      if (wall.center.z != 0.5) continue;
      maker.surface(part(height, 1), pt::gray(0.5));
      cosine += cosine_of_polygon(part(0, height).corners(), {}, {0, 0, 1});
    }
    Situation s = maker.sky(radiance).patch(*color(0.1, 1), *direction_above()).done();
    s.expected = s.point.albedo * radiance * (cosine / pt::kPi);
    return s;
  });
}

// A ball and an upright plane through the point and the ball's centre that hides one half of the
// ball. Both halves give the same light.
inline rc::Gen<Situation> half_hidden_ball() {
  return rc::gen::exec([] {
    SceneMaker maker(*unturned_pose());
    const double tilt = *real(0, 1), azimuth = *real(-pt::kPi, pt::kPi);
    const double x = std::cos(azimuth), y = std::sin(azimuth), distance = *real(0.5, 3);
    const pt::Vec3 towards{std::sin(tilt) * x, std::sin(tilt) * y, std::cos(tilt)};
    maker.ball(distance * towards, distance * *real(0.1, 0.4), any_radiance(), Body::none);
    const pt::Vec3 aside{-y, x, 0};
    const double at = 0.5 * distance, side = distance * *rc::gen::element(-1, 1);
    maker.surface({at * towards + side / 2 * aside, side * aside, at * 2 * cross(towards, aside)},
                  *color());
    Situation s = maker.patch(*color(0.1, 1), *direction_above()).done();
    s.expected *= 0.5;
    return s;
  });
}

// The same scene, in which all surfaces glow. They are not in the list of lights, so that they give
// no light. They hide what is behind them all the same.
inline Situation with_glowing_surfaces(Situation s) {
  for (pt::Material& material : s.scene.materials) material.emission = pt::gray(2);
  s.text += "all surfaces glow\n";
  return s;
}

// Lit by the light; the surfaces of the scene glow or do not.
template <class Light>
rc::Gen<Situation> glowing_or_not(Light light) {
  return rc::gen::exec([=] {
    const Situation s = *lit_by(light);
    return *rc::gen::arbitrary<bool>() ? with_glowing_surfaces(s) : s;
  });
}

inline void hidden_light(SceneMaker& maker) {
  const int kind = *whole(0, 2);
  if (kind == 0) maker.point_light(any_position(), any_radiance(), true, any_way());
  if (kind == 1) maker.directional_light(*direction_above(), any_radiance(), true);
  if (kind == 2) {
    maker.rectangle(*rectangle_above(0.8, 0.3, 1.5), any_radiance(), Body::none, 1, any_way());
  }
}

enum class Dark { hidden, below, no };

// Four lights in four directions, so far apart that nothing hides two of them. The first gives no
// light, because it is hidden or below the horizon, and the last gives light. Lights that give
// light are point and directional lights.
inline void some_hidden_or_below(SceneMaker& maker) {
  constexpr int kLights = 4;
  for (int k = 0; k < kLights; ++k) {
    const double azimuth = 2 * pt::kPi * k / kLights + *real(-0.2, 0.2), tilt = *real(0.6, 1.1);
    const Dark dark = k == 0            ? *rc::gen::element(Dark::hidden, Dark::below)
                      : k < kLights - 1 ? *rc::gen::element(Dark::hidden, Dark::below, Dark::no)
                                        : Dark::no;
    const bool hidden = dark == Dark::hidden;
    const double r = std::sin(tilt), z = dark == Dark::below ? -std::cos(tilt) : std::cos(tilt);
    const pt::Vec3 towards{r * std::cos(azimuth), r * std::sin(azimuth), z};
    const double distance = *real(2, 4);
    const int kind = *whole(0, dark == Dark::no ? 1 : 3);
    if (kind == 0) maker.point_light(distance * towards, any_radiance(), hidden);
    if (kind == 1) maker.directional_light(towards, any_radiance(), hidden);
    if (kind < 2) continue;
    const pt::Frame around = pt::frame_from_normal(-towards);
    const Rectangle shape{distance * towards, 0.3 * around.x, 0.3 * around.y};
    kind == 2 ? void(maker.rectangle(shape, any_radiance(), Body::none, hidden ? 1 : 0))
              : any_mesh(maker, shape, any_radiance(), Body::none, hidden ? 1 : 0);
  }
}

// A light of each kind, hidden by a dark ball around the point. Where the light is infinitely far
// away, the ball is large, with the world's origin in its middle: the way to it is longer than the
// largest coordinate in the scene.
inline rc::Gen<Situation> hidden_by_a_ball(int kind, double size) {
  return rc::gen::exec([=] {
    const bool far = kind == 1 || kind == 5;
    const double radius = far ? 1.5 : 0.25;
    const pt::Vec3 center{0, 0, far ? 0.9 * radius : 0};
    SceneMaker maker({{}, -size * center, size});
    maker.dark_ball(center, radius);
    kind == 1 ? void(maker.directional_light(*direction_above(1.0), any_radiance()))
              : light_of_kind(maker, kind);
    return dark(maker.patch(*color(0.1, 1), *direction_above()).done());
  });
}

// An upright wall on the patch, close behind the point as seen from the light. It touches the
// surface and hides nothing.
inline void beside_a_wall(SceneMaker& maker) {
  const pt::Vec3 at = any_position();
  const pt::Vec3 away = normalize(pt::Vec3{-at.x, -at.y, 0} + pt::Vec3{-1e-9, 0, 0});
  const pt::Vec3 along{-away.y, away.x, 0};
  maker.point_light(at, any_radiance());
  const double beside = *magnitude(1e-3, 0.05), height = *real(0.1, 2);
  maker.surface({beside * away + pt::Vec3{0, 0, height / 2}, along, {0, 0, height}}, *color());
}

// A point light or an area light above a dark lid.
inline void under_a_lid(SceneMaker& maker) {
  const int kind = *whole(0, kAreaKinds);
  kind < kAreaKinds
      ? area_light(maker, kind, any_radiance())
      : void(maker.point_light(*real(0.5, 4) * *direction_above(1.4), any_radiance()));
  // Its diagonal is not above the point: a ray that meets just an edge may miss both triangles.
  maker.surface({{0.02, 0.01, 1e-3}, {0.25, 0, 0}, {0, 0.25, 0}}, pt::gray(0.5));
}

// A lamp with a surface of its own and, if it is hidden, a dark surface that is nearer by this part of
// the way and larger.
inline void lamp_behind_a_gap(SceneMaker& maker, double gap, bool is_hidden) {
  const Rectangle shape = *rectangle_above(0.8, 0.2, 1);
  maker.rectangle(shape, any_radiance(), Body::surface);
  if (is_hidden) maker.surface(shape.scaled(1 - gap).part(-1, 2, -1, 2), pt::gray(0.5));
}

// A point light and, if it is hidden, a dark lid at this height above the point.
inline void point_light_above_a_gap(SceneMaker& maker, double gap, bool is_hidden) {
  maker.point_light(*real(0.5, 4) * *direction_above(1.4), any_radiance());
  // Its diagonal is not above the point: a ray that meets just an edge may miss both triangles.
  if (is_hidden) maker.surface({{0.2, 0.1, gap}, {2.5, 0, 0}, {0, 2.5, 0}}, pt::gray(0.5));
}

}  // namespace grader::check::direct_lights_inputs
