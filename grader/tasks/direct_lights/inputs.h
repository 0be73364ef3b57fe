#pragma once

#include "grader/check/generators/generators.h"
#include "grader/check/scenes/scenes.h"
#include "grader/check/scenes/smooth_shading.h"

// Lights for direct_lights. Each function adds one light of random size and position to a scene. The
// shaded point is the origin, and its normal is along z.

namespace grader::check::direct_lights_inputs {

inline pt::Rgb any_radiance() { return *color(0.25, 4); }

inline pt::Vec3 any_position() { return *real(0.5, 4) * *direction_above(); }

// A direction between a ten-thousandth of a degree and six degrees above the surface.
inline pt::Vec3 grazing_direction() { return *direction_above_at(magnitude(2e-6, 0.1)); }

// A patch and the lights that `light` adds.
template <class Light>
rc::Gen<Situation> lit_by(Light light, const rc::Gen<Pose>& poses = unturned_pose(),
                          const rc::Gen<bool>& from_behind = rc::gen::just(false)) {
  return rc::gen::exec([=] {
    SceneMaker maker(*poses);
    light(maker);
    return maker.patch(*color(0.1, 1), *direction_above(), *from_behind).done();
  });
}

// The same in a scene of a given size, without any surface. Only the light's distance and brightness
// matter, and no offset.
template <class Light>
rc::Gen<Situation> lit_without_surfaces(Light light, double size) {
  return rc::gen::exec([=] {
    SceneMaker maker({{}, {}, size});
    light(maker);
    return maker.point(*color(0.1, 1), *direction_above()).done();
  });
}

inline void rectangle(SceneMaker& maker) {
  maker.rectangle(*rectangle_above(1.2, 0.1, 1.5), any_radiance(), Body::none);
}

// A light whose sides are far from right angles. All of it is above the horizon.
inline void parallelogram(SceneMaker& maker) {
  Rectangle shape = *rectangle_above(0.5, 0.5, 0.6);
  shape.v += *rc::gen::element(-1.0, 1.0) * *real(0.9, 1.2) * shape.u;
  maker.rectangle(shape, any_radiance(), Body::none);
}

// A rectangle with sides down to a ten-thousandth of its distance, up to a thousand units away.
inline void small_rectangle(SceneMaker& maker) {
  const Rectangle shape = (*rectangle_above(1.2, 0.5, 1.5)).scaled(*magnitude(1e-1, 1e3));
  const double half = *magnitude(1e-4, 0.5);
  maker.rectangle(shape.part(0.5 - half, 0.5 + half, 0.5 - half, 0.5 + half), any_radiance(),
                  Body::none);
}

inline void ball(SceneMaker& maker) {
  const pt::Vec3 towards = *direction_above(1.0);
  const double distance = *real(0.5, 3);
  maker.ball(distance * towards, distance * *real(0.05, 0.5), any_radiance(), Body::none);
}

// A ball close above the horizon. Its lowest point is one radius above the horizon.
inline void grazing_ball(SceneMaker& maker) {
  const pt::Vec3 towards = grazing_direction();
  const double distance = *magnitude(0.1, 1e3);
  maker.ball(distance * towards, distance * towards.z / 2, any_radiance(), Body::none);
}

// A mesh of two to a thousand triangles, nearly always of different areas.
inline void any_mesh(SceneMaker& maker, const Rectangle& shape, pt::Rgb radiance, Body body,
                     double hidden = 0, double way = 0.5) {
  const Strips strips{static_cast<int>(*magnitude(1, 500)), *real(1.5, 3)};
  maker.mesh(shape, radiance, body, hidden, way, strips);
}

inline constexpr int kAreaKinds = 3;

// A rectangle, a mesh or a ball. All of it is at most 0.4 radians from a direction.
inline void area_light(SceneMaker& maker, int kind, const pt::Rgb& radiance, double tilt = 0.7) {
  const pt::Vec3 towards = *direction_above(tilt);
  const pt::Frame around = pt::frame_from_normal(-towards);
  const double side = *real(0.2, 0.6);
  const Rectangle shape{towards, side * around.x, side * around.y};
  if (kind == 0) maker.rectangle(shape, radiance, Body::none);
  if (kind == 1) any_mesh(maker, shape, radiance, Body::none);
  if (kind == 2) maker.ball(towards, side / 2, radiance, Body::none);
}

inline void point_light(SceneMaker& maker) { maker.point_light(any_position(), any_radiance()); }

inline void grazing_point_light(SceneMaker& maker) {
  const double distance = *magnitude(0.1, 1e3);
  maker.point_light(distance * grazing_direction(), distance * distance * any_radiance());
}

// The light is so close that little intensity gives much light.
inline void close_point_light(SceneMaker& maker, pt::Rgb intensity) {
  maker.point_light(*magnitude(0.01, 0.1) * *direction_above(), intensity);
}

inline void directional_light(SceneMaker& maker) {
  maker.directional_light(*direction_above(), any_radiance());
}

inline void grazing_directional_light(SceneMaker& maker) {
  maker.directional_light(grazing_direction(), any_radiance());
}

inline void any_delta_light(SceneMaker& maker) {
  *rc::gen::arbitrary<bool>() ? point_light(maker) : directional_light(maker);
}

// A point of a mesh that is shaded smoothly, under a light that is above its shading normal's horizon, and
// often below its true surface. Its own surface is small and dark.
template <class Light>
rc::Gen<Situation> lit_and_strongly_interpolated(Light light, double size) {
  return rc::gen::exec([=] {
    SceneMaker maker(*pose(size));
    light(maker);
    return strongly_interpolated(maker, *color(0.1, 1), 0.125);
  });
}

// A point that is shaded a little smoothly, under a point or directional light above the horizons of
// its shading normal and of its true surface.
inline rc::Gen<Situation> lit_and_smoothly_shaded() {
  return rc::gen::exec([] {
    SceneMaker maker(*pose());
    const pt::Vec3 towards = *direction_above(1.0);
    *rc::gen::arbitrary<bool>() ? maker.point_light(*real(0.5, 4) * towards, any_radiance())
                                : maker.directional_light(towards, any_radiance());
    return smoothly_shaded(maker.point(*color(0.1, 1), {0, 0, 1}).done());
  });
}

// The same under an area light.
inline rc::Gen<Situation> smoothly_shaded_under(int kind) {
  return rc::gen::exec([kind] {
    SceneMaker maker(*pose());
    area_light(maker, kind, any_radiance());
    return smoothly_shaded(maker.point(*color(0.1, 1), {0, 0, 1}).done());
  });
}

// Makes a white patch under a point or directional light of any hue. The patch may glow itself.
inline rc::Gen<Situation> white_patch(bool glows) {
  return rc::gen::exec([glows] {
    SceneMaker maker(*unturned_pose());
    const pt::Rgb light = *hue() * any_radiance();
    *rc::gen::arbitrary<bool>() ? maker.point_light(any_position(), light)
                                : maker.directional_light(*direction_above(), light);
    const pt::Rgb own = glows ? any_radiance() : pt::Rgb{};
    return maker.patch(pt::gray(1), *direction_above(), false, own).done();
  });
}

// A patch under the sky, tilted so that much of it is below the patch's horizon: away from straight
// up, or straight down.
inline rc::Gen<Situation> under_the_sky(double tilt, double up = 1) {
  return rc::gen::exec([=] {
    pt::Vec3 tilted = *direction_above(tilt);
    // Hardly any draw of the sky is above the horizon of a ceiling that is almost level: too few to
    // tell how noisy draws are.
    if (up < 0 && tilted.z > 0.98) tilted = {0, 0, 1};
    const pt::Vec3 n = pt::frame_from_normal({0, up, 0}).to_world(tilted);
    SceneMaker maker({pt::frame_from_normal(n), *point(), *magnitude(1e-2, 1e2)});
    return maker.sky(any_radiance()).patch(*color(0.1, 1), *direction_above()).done();
  });
}

inline constexpr int kKinds = 6;

inline void light_of_kind(SceneMaker& maker, int kind) {
  const Rectangle shape = *rectangle_above(0.8, 0.2, 1);
  if (kind == 0) point_light(maker);
  if (kind == 1) directional_light(maker);
  if (kind == 2) maker.rectangle(shape, any_radiance(), Body::none);
  if (kind == 3) any_mesh(maker, shape, any_radiance(), Body::none);
  if (kind == 4) maker.ball(2 * *direction_above(1.0), 0.5, any_radiance(), Body::none);
  if (kind == 5) maker.sky(0.2 * any_radiance());
}

// Adds a light of the given radiance; any kind but the sky.
inline void light_of_radiance(SceneMaker& maker, int kind, pt::Rgb radiance) {
  if (kind == 0) maker.point_light(any_position(), radiance);
  if (kind == 1) maker.directional_light(*direction_above(), radiance);
  if (kind == 2) maker.ball(2 * *direction_above(1.0), 0.5, radiance, Body::none);
  if (kind == 3) any_mesh(maker, *rectangle_above(0.8, 0.2, 1), radiance, Body::none);
  if (kind == 4) maker.rectangle(*rectangle_above(0.8, 0.2, 1), radiance, Body::none);
}

inline void any_light(SceneMaker& maker) { light_of_kind(maker, *whole(0, kKinds - 1)); }

inline void lamp(SceneMaker& maker) {
  maker.rectangle(*rectangle_above(0.8, 0.2, 1), any_radiance(), Body::none);
}

// Lights of one kind in the same place: red, green and blue ones. Flat ones are half hidden.
inline void lights_of_three_colors(SceneMaker& maker, int kind, int lights) {
  const Rectangle shape = *rectangle_above(0.8, 0.3, 1.5);
  const pt::Vec3 towards = *direction_above(1.0);
  for (int k = 0; k < lights; ++k) {
    pt::Rgb radiance;
    radiance[k < 3 ? k : *whole(0, 2)] = 1;
    const double hidden = k == 0 ? 0.5 : 0;  // one surface hides a half of all of them
    if (kind == 0) maker.rectangle(shape, radiance, Body::none, hidden);
    if (kind == 1) any_mesh(maker, shape, radiance, Body::none, hidden);
    if (kind == 2) maker.ball(2 * towards, 1, radiance, Body::none);
    if (kind == 3) maker.sky(radiance);
  }
}

// A red mesh and a green rectangle side by side, each of which is half hidden. Each number that chooses a
// point of the mesh has to do with what is hidden.
inline void red_mesh_and_green_lamp(SceneMaker& maker) {
  const Rectangle left{{-0.6, 0, 1}, {0, 0.5, 0}, {0.5, 0, 0}};
  const Rectangle right{{0.6, 0, 1}, left.u, left.v};
  maker.mesh(left, {1, 0, 0}, Body::none, 0.5).rectangle(right, {0, 1, 0}, Body::none, 0.5);
}

// A rectangle or mesh light with its own surface, and often a wall behind it: in the plane of the
// light, just behind it or far away.
inline void lamp_with_a_body(SceneMaker& maker) {
  const Rectangle shape = *rectangle_above(0.8, 0.2, 1);
  const bool is_mesh = *rc::gen::arbitrary<bool>();
  is_mesh ? any_mesh(maker, shape, any_radiance(), Body::surface)
          : void(maker.rectangle(shape, any_radiance(), Body::surface));
  if (*rc::gen::arbitrary<bool>()) {
    const double way = *rc::gen::element(1.0, 1.001, 1.01, 1.5);
    maker.surface(shape.part(-1, 2, -1, 2).scaled(way), *color());
  }
}

// Returns a square across the way from the point to a place, at a multiple of that way.
inline Rectangle across(pt::Vec3 place, double way, double side) {
  const pt::Frame around = pt::frame_from_normal(normalize(place));
  return {way * place, side * around.x, side * around.y};
}

inline void point_light_before_a_wall(SceneMaker& maker) {
  const pt::Vec3 at = any_position();
  maker.point_light(at, any_radiance());
  const double way = *rc::gen::element(1.001, 1.01, 1.5);
  maker.surface(across(at, way, 9), *color());
}

inline void ball_with_a_body(SceneMaker& maker) {
  const double distance = *real(0.5, 3);
  maker.ball(distance * *direction_above(1.0), distance * *real(0.01, 0.4), any_radiance(),
             Body::surface);
}

inline void light_below(SceneMaker& maker) {
  const pt::Vec3 above = *real(0.5, 4) * *direction_above(1.0);
  const pt::Vec3 at{above.x, above.y, -above.z};
  const int kind = *whole(0, 2);
  if (kind == 0) maker.point_light(at, any_radiance());
  if (kind == 1) maker.directional_light(normalize(at), any_radiance());
  if (kind == 2) maker.ball(at, 0.2, any_radiance(), Body::none);
}

// A light above the patch that emits away from it.
inline void light_turned_away(SceneMaker& maker) {
  maker.rectangle((*rectangle_above(0.8, 0.2, 1)).flipped(), any_radiance(), Body::none);
}

// A rectangle whose plane the point lies in, exactly: its corners are on two axes.
inline void light_edge_on(SceneMaker& maker) {
  const double wide = *real(0.5, 2), tall = *real(0.5, 2);
  const Rectangle upright{{wide, 0, tall}, {wide, 0, 0}, {0, 0, tall}};
  maker.rectangle(*rc::gen::arbitrary<bool>() ? upright : upright.flipped(), any_radiance(),
                  Body::none);
}

// The same light twice, in the same place.
inline void twins(SceneMaker& maker) {
  const int kind = *whole(0, 4);
  const pt::Vec3 towards = *direction_above(1.0);
  const Rectangle shape = *rectangle_above(0.8, 0.2, 1);
  const pt::Rgb radiance = any_radiance();
  for (int i = 0; i < 2; ++i) {
    if (kind == 0) maker.point_light(2 * towards, radiance);
    if (kind == 1) maker.directional_light(towards, radiance);
    if (kind == 2) maker.ball(2 * towards, 0.5, radiance, Body::none);
    if (kind == 3) any_mesh(maker, shape, radiance, Body::none);
    if (kind == 4) maker.rectangle(shape, radiance, Body::none);
  }
}

// An upright rectangle that continues below the horizon.
inline void light_across_the_horizon(SceneMaker& maker) {
  const double tall = *real(1, 2);
  maker.rectangle({{-1, 0, tall * *real(-0.2, 0.2)}, {0, 1, 0}, {0, 0, tall}}, any_radiance(),
                  Body::none);
}

inline void point_lights_of_six_colors(SceneMaker& maker, int lights) {
  constexpr pt::Rgb kColors[] = {{3, 0, 0}, {0, 3, 0}, {0, 0, 3}, {1, 2, 0}, {0, 1, 2}, {2, 0, 1}};
  for (int i = 0; i < lights; ++i) {
    maker.point_light({0.3 * i - 0.5, 0.2, 1.0 + 0.1 * i}, kColors[i % 6]);
  }
}

// Adds a row of equal lights above the point.
inline void row_of_point_lights(SceneMaker& maker, int lights, pt::Rgb intensity) {
  for (int i = 0; i < lights; ++i) {
    const double part = static_cast<double>(i) / lights;
    maker.point_light({4 * part - 2, 0.3, 1 + part}, intensity);
  }
}

}  // namespace grader::check::direct_lights_inputs
