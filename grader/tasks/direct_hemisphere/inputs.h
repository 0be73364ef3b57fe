#pragma once

#include "grader/check/generators/generators.h"
#include "grader/check/scenes/closed_forms.h"
#include "grader/check/scenes/scenes.h"
#include "grader/check/scenes/smooth_shading.h"

#include <cmath>
#include <utility>
#include <vector>

// Scenes around a shaded point for direct_hemisphere. The point is the origin of the maker, and its
// normal is along z.

namespace grader::check::direct_hemisphere_inputs {

inline pt::Rgb any_radiance() { return *color(0.25, 4); }

// A pose in which the patch has this unit normal, exactly.
inline rc::Gen<Pose> pose_on(pt::Vec3 normal) {
  return rc::gen::map(pose(), [normal](Pose pose) {
    pose.turn = pt::frame_from_normal(normal);
    return pose;
  });
}

// Makes a patch, after the lights and surfaces that `add` adds to its scene.
template <class Add>
rc::Gen<Situation> patch_with(Add add, const rc::Gen<Pose>& poses = unturned_pose(),
                              bool from_behind = false) {
  return rc::gen::exec([=] {
    SceneMaker maker(*poses);
    add(maker);
    return maker.patch(*color(0.1, 1), *direction_above(), from_behind).done();
  });
}

// Makes a patch that glows itself, in any pose.
template <class Add>
rc::Gen<Situation> glowing_patch_with(Add add) {
  return rc::gen::exec([=] {
    SceneMaker maker(*pose());
    add(maker);
    return maker.patch(*color(0.1, 1), *direction_above(), false, any_radiance()).done();
  });
}

// Adds a glowing rectangle that fills much of the hemisphere.
inline void lamp(SceneMaker& maker) {
  maker.rectangle(*rectangle_above(0.9, 1.6, 2.5), any_radiance(), Body::surface);
}

// The walls of a room without its floor, cut into pieces. Every direction above the patch meets
// one.
inline std::vector<Rectangle> dome(int pieces) {
  std::vector<Rectangle> cells;
  for (const Rectangle& wall : cube()) {
    if (wall.center.z == 0) continue;
    for (int i = 0; i < pieces * pieces; ++i) {
      const int column = i % pieces, row = i / pieces;
      const double a = column, b = row, width = 1.0 / pieces;
      cells.push_back(wall.part(a * width, (a + 1) * width, b * width, (b + 1) * width));
    }
  }
  return cells;
}

inline void glowing_walls(SceneMaker& maker, pt::Rgb radiance) {
  for (const Rectangle& wall : dome(1)) maker.surface(wall, pt::gray(0.5), radiance);
}

// A patch in a room whose walls all glow. Its right radiance is its albedo times the walls'
// radiance.
inline rc::Gen<Situation> in_a_glowing_room(const rc::Gen<Pose>& poses) {
  return rc::gen::exec([poses] {
    SceneMaker maker(*poses);
    const pt::Rgb radiance = any_radiance(), albedo = *color(0.1, 1);
    glowing_walls(maker, radiance);
    Situation s = maker.patch(albedo, *direction_above(), *rc::gen::arbitrary<bool>()).done();
    s.expected = albedo * radiance;
    return s;
  });
}

// The same room, but no green comes from one half of its azimuths, and no blue from the other half. So
// red tells the height of a direction, and green tells on which side it is.
inline rc::Gen<Situation> in_a_room_of_two_halves(const rc::Gen<Pose>& poses) {
  return rc::gen::exec([poses] {
    SceneMaker maker(*poses);
    const pt::Rgb radiance = any_radiance(), albedo = *color(0.1, 1);
    for (const Rectangle& wall : dome(1)) {
      const auto half = [&](double from) {
        if (wall.center.x != 0) return wall;
        return wall.u.x > 0 ? wall.part(from, from + 0.5, 0, 1) : wall.part(0, 1, from, from + 0.5);
      };
      if (wall.center.x <= 0) maker.surface(half(0), pt::gray(0.5), radiance * pt::Rgb{1, 0, 1});
      if (wall.center.x >= 0) maker.surface(half(0.5), pt::gray(0.5), radiance * pt::Rgb{1, 1, 0});
    }
    Situation s = maker.patch(albedo, *direction_above(), *rc::gen::arbitrary<bool>()).done();
    s.expected = albedo * radiance * pt::Rgb{1, 0.5, 0.5};
    return s;
  });
}

// A patch under a rectangle light that fills much of its hemisphere. A dark surface hides the part
// `hidden` of the light. It is half way to the light, close to the patch or just in front of the
// light.
inline rc::Gen<Situation> under_a_rectangle(const rc::Gen<Pose>& poses,
                                            const rc::Gen<double>& hidden) {
  const auto light = [=](SceneMaker& maker) {
    const double way = *rc::gen::element(0.5, 0.2, 0.999);
    maker.rectangle(*rectangle_above(0.9, 1.6, 2.5), any_radiance(), Body::surface, *hidden, way);
  };
  return patch_with(light, poses);
}

// The same light in a scene of a given size, without a surface at the point. Only the distance of
// the light matters, and no offset.
inline rc::Gen<Situation> far_below_a_rectangle(double size) {
  return rc::gen::exec([=] {
    SceneMaker maker({{}, {}, size});
    lamp(maker);
    return maker.point(*color(0.1, 1), *direction_above()).done();
  });
}

// Returns a rectangle that is wider than the light, at a multiple of the way to it: before or behind it.
inline Rectangle shade_of(const Rectangle& light, double way) {
  return light.part(-0.5, 1.5, -0.5, 1.5).scaled(way);
}

// A light behind a dark surface that turns its back to the patch.
inline rc::Gen<Situation> behind_the_back_of_a_surface() {
  return patch_with([](SceneMaker& maker) {
    const Rectangle shape = *rectangle_above(0.9, 1.6, 2.5);
    maker.rectangle(shape, any_radiance(), Body::surface);
    maker.surface(shade_of(shape, 0.5).flipped(), *color());
  });
}

enum class Side { bright, dark };

// A patch that sees one side of a light.
inline rc::Gen<Situation> under_one_side_of_a_light(Side side) {
  return rc::gen::exec([side] {
    SceneMaker maker({});
    const Rectangle shape = *rectangle_above(0.9, 1.6, 2.5);
    maker.rectangle(side == Side::bright ? shape : shape.flipped(), any_radiance(), Body::surface);
    return maker.patch(pt::gray(0.5), {0, 0, 1}).done();
  });
}

// The same scene with all corner normals reversed. The sides of its surfaces stay the same, because
// the order of the corners decides them.
inline Situation with_corner_normals_turned_round(Situation s) {
  for (pt::Triangle& triangle : s.scene.primitives.triangles) {
    triangle.n0 = -triangle.n0;
    triangle.n1 = -triangle.n1;
    triangle.n2 = -triangle.n2;
  }
  s.scene = ready(std::move(s.scene));
  s.text += "all corner normals are turned round, against the order of the corners\n";
  return s;
}

// A wall just behind the light hides nothing of it.
inline rc::Gen<Situation> before_a_wall() {
  return patch_with([](SceneMaker& maker) {
    const Rectangle shape = *rectangle_above(0.9, 1.6, 2.5);
    maker.rectangle(shape, any_radiance(), Body::surface);
    maker.surface(shade_of(shape, 1.001), *color());
  });
}

// A glowing ball, which is a light of the list too.
inline rc::Gen<Situation> under_a_ball() {
  return patch_with([](SceneMaker& maker) {
    maker.ball(2 * *direction_above(0.8), *real(0.7, 1), any_radiance(), Body::surface);
  });
}

// A lamp that fills less than a hundredth of the hemisphere.
inline rc::Gen<Situation> under_a_small_lamp() {
  return patch_with([](SceneMaker& maker) {
    maker.rectangle(*rectangle_above(0.5, 0.18, 0.2), any_radiance(), Body::surface);
  });
}

// A point that is shaded smoothly, under a lamp above the horizons of its shading normal and of its
// true surface.
inline rc::Gen<Situation> smoothly_shaded_under_a_lamp() {
  return rc::gen::exec([] {
    SceneMaker maker(*pose());
    const pt::Vec3 towards = *direction_above_at(real(0.8, 0.9));
    const pt::Frame facing = pt::frame_from_normal(-towards);
    maker.rectangle({towards, 0.8 * facing.x, 0.8 * facing.y}, any_radiance(), Body::surface);
    return smoothly_shaded(maker.point(*color(0.1, 1), {0, 0, 1}).done());
  });
}

// One or two skies, and often lights that no ray meets before and after them in the list.
inline rc::Gen<Situation> under_the_sky() {
  return rc::gen::exec([] {
    const pt::Vec3 n = pt::frame_from_normal({0, 1, 0}).to_world(*direction_above(1.8));
    const Pose tilted{pt::frame_from_normal(n), *point(), *magnitude(1e-2, 1e2)};
    const bool more_lights = *rc::gen::arbitrary<bool>();
    pt::Rgb sky;
    SceneMaker maker(tilted);
    if (more_lights) maker.point_light(2 * *direction_above(), any_radiance());
    for (int skies = *whole(1, 2); skies > 0; --skies) {
      const pt::Rgb radiance = any_radiance();
      maker.sky(radiance);
      sky += radiance;
    }
    if (more_lights) maker.rectangle(*rectangle_above(0.8, 0.2, 1), any_radiance(), Body::none);
    Situation s = maker.patch(*color(0.1, 1), *direction_above()).done();
    s.expected = s.point.albedo * sky / pt::kPi * cosine_of_half_space({0, 1, 0}, n);
    return s;
  });
}

inline rc::Gen<Situation> beside_lights_without_surfaces() {
  return rc::gen::exec([] {
    SceneMaker maker(*unturned_pose());
    for (int lights = *rc::gen::element(0, 1, 5, 40); lights > 0; --lights) {
      *rc::gen::arbitrary<bool>()
          ? maker.point_light(2 * *direction_above(), any_radiance())
          : maker.ball(2 * *direction_above(1.0), 0.2, any_radiance(), Body::none);
    }
    const Rectangle shape = *rectangle_above(0.5, 1.6, 2.5);
    const pt::Rgb radiance = any_radiance();
    maker.surface(shape, *color(), radiance);
    Situation made = maker.patch(*color(0.1, 1), *direction_above()).done();
    made.expected =
        made.point.albedo * radiance / pt::kPi * cosine_of_polygon(shape.corners(), {}, {0, 0, 1});
    return made;
  });
}

// A point of a mesh that is shaded smoothly, in a closed room whose walls all glow. Its own surface is
// small and dark.
inline rc::Gen<Situation> smooth_point_in_a_glowing_room() {
  return rc::gen::exec([] {
    SceneMaker maker(*pose());
    const pt::Rgb radiance = any_radiance(), albedo = *color(0.1, 1);
    for (const Rectangle& wall : cube_around()) maker.surface(wall, pt::gray(0.5), radiance);
    Situation s = strongly_interpolated(maker, albedo, 0.125);
    s.expected = albedo * radiance;
    return s;
  });
}

// Two surfaces of one material side by side. One turns its glowing side to the patch, the other its
// back.
inline rc::Gen<Situation> under_front_and_back_of_a_material() {
  return rc::gen::exec([] {
    SceneMaker maker(*unturned_pose());
    const pt::Rgb albedo = *color(), radiance = any_radiance();
    const Rectangle front{{-1, 0, 1}, {0, 2, 0}, {2, 0, 0}}, back{{1, 0, 1}, {2, 0, 0}, {0, 2, 0}};
    maker.surface(front, albedo, radiance).surface(back, albedo, radiance);
    Situation s = maker.patch(*color(0.1, 1), *direction_above()).done();
    s.expected =
        s.point.albedo * radiance / pt::kPi * cosine_of_polygon(front.corners(), {}, {0, 0, 1});
    return s;
  });
}

// A dark lid close above the patch. Only directions within 0.01 radians of the surface pass it.
inline rc::Gen<Situation> under_a_lid(const rc::Gen<Pose>& poses) {
  return rc::gen::exec([poses] {
    SceneMaker maker(*poses);
    glowing_walls(maker, pt::gray(1));
    maker.surface({{0, 0, 1e-3}, {0.25, 0, 0}, {0, 0.25, 0}}, pt::gray(0.5));
    return maker.patch(pt::gray(0.5), *direction_above()).done();
  });
}

// Returns a strip that stands upright on the horizon at a distance of 1. Its width is in radians of
// azimuth.
inline Rectangle upright_strip(double azimuth, double width, double height = 1) {
  const double x = std::cos(azimuth), y = std::sin(azimuth);
  return {{x, y, height / 2}, {width * y, -width * x, 0}, {0, 0, height}};
}

// Strips side by side that stand all around, up to 76 degrees above the horizon.
inline std::vector<Rectangle> strips_all_around(int count) {
  std::vector<Rectangle> strips;
  for (int i = 0; i < count; ++i) {
    strips.push_back(upright_strip(2 * pt::kPi * (i + 0.5) / count, 2 * pt::kPi / count, 4));
  }
  return strips;
}

// Upright strips of 0.2 degrees of azimuth, 9 degrees apart on the average, up to 45 degrees above
// the horizon.
inline std::vector<Rectangle> narrow_strips() {
  constexpr int kStrips = 40;
  const double width = 0.2 * pt::kPi / 180, apart = 2 * pt::kPi / kStrips;
  std::vector<Rectangle> strips;
  for (int i = 0; i < kStrips; ++i) {
    strips.push_back(upright_strip((i + *real(0.05, 0.95)) * apart, width));
  }
  return strips;
}

// Piece i of the room glows in the hue (1, i + 1, 0). The point may be shaded smoothly.
inline rc::Gen<Situation> in_a_colored_room(const std::vector<Rectangle>& pieces,
                                            bool smooth = false) {
  return rc::gen::exec([pieces, smooth] {
    SceneMaker maker(*pose());
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      maker.surface(pieces[i], pt::gray(0.5), {1, static_cast<double>(i + 1), 0});
    }
    if (smooth) return smoothly_shaded(maker.point(pt::gray(0.5), {0, 0, 1}).done());
    return maker.patch(pt::gray(0.5), *direction_above()).done();
  });
}

// Returns the strips of four walls, at a distance of 1, from one height to another.
inline std::vector<Rectangle> strips_of_walls(double low, double high) {
  std::vector<Rectangle> strips;
  for (const Rectangle& wall : dome(1)) {
    if (wall.center.z == 1) continue;
    strips.push_back(wall.u.z > 0 ? wall.part(low, high, 0, 1) : wall.part(0, 1, low, high));
  }
  return strips;
}

// Four walls, at a distance of 1, glow up to a height of 0.001. Between 0.0008 and 0.001 of all
// directions meet them.
inline rc::Gen<Situation> in_a_room_lit_at_the_horizon() {
  return rc::gen::exec([] {
    SceneMaker maker(*pose());
    double cosine = 0;
    for (const Rectangle& strip : strips_of_walls(0, 1e-3)) {
      maker.surface(strip, {}, pt::gray(100));
      cosine += cosine_of_polygon(strip.corners(), {}, {0, 0, 1});
    }
    Situation s = maker.patch(pt::gray(0.5), *direction_above()).done();
    s.expected = s.point.albedo * pt::gray(100 * cosine / pt::kPi);
    return s;
  });
}

}  // namespace grader::check::direct_hemisphere_inputs
