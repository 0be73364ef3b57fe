#include "grader/check/scenes/rooms.h"

#include "grader/check/generators/generators.h"
#include "grader/check/scenes/channels.h"
#include "grader/check/scenes/closed_forms.h"
#include "grader/check/scenes/smooth_shading.h"

#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>

namespace grader::check {

using pt::Rgb;
using pt::Vec3;
using Direct = pt::PathSettings::Direct;

namespace {

// A place on a sphere, often exactly on an axis: the normal there is an axis.
Vec3 any_place() {
  const auto exact = rc::gen::map(rotation_of_axes(), [](const pt::Frame& f) { return f.z; });
  return *rc::gen::oneOf(direction(), exact);
}

// A point with the normal n on the side of wo. wo is local, with n as z.
pt::SurfacePoint point_on(const pt::Scene& scene, Vec3 p, Vec3 n, Vec3 geometric_normal, Rgb albedo,
                          Vec3 wo) {
  pt::SurfacePoint point;
  point.p = p;
  point.n = n;
  point.geometric_normal = geometric_normal;
  point.frame = pt::frame_from_normal(n);
  point.wo = point.frame.to_world(wo);
  point.albedo = albedo;
  point.scale = std::max(coordinate_size(scene.primitives), max_abs(p));
  return point;
}

// A diffuse ball around the position of the pose. Its radius is the size of the pose.
pt::Scene inside_of_a_ball(const Pose& pose, Rgb albedo) {
  pt::Scene scene;
  scene.primitives.spheres.push_back({pose.shift, pose.size});
  scene.material_of.push_back(0);
  scene.materials.push_back({"", albedo, {}, ""});
  return scene;
}

pt::SurfacePoint point_on_the_inside(const pt::Scene& scene, Vec3 outwards) {
  const pt::Sphere& ball = scene.primitives.spheres[0];
  return point_on(scene, ball.center + ball.radius * outwards, -outwards, outwards,
                  scene.materials[0].albedo, any_view());
}

// The irradiance at the point `at` of a ball of radius 1, from a point light of intensity 1. The
// light is `offset` away from the centre of the ball.
double irradiance(Vec3 at, Vec3 offset) {
  const double distance = length(at - offset);
  return dot(at - offset, at) / (distance * distance * distance);
}

// The variance of this irradiance over the ball, where its mean is 1. It depends only on the cosine
// between the point and the light.
double variance_of_irradiance(double offset) {
  constexpr int kSteps = 400;
  double mean_square = 0;
  for (int i = 0; i < kSteps; ++i) {
    const double cosine = (2 * i + 1.0) / kSteps - 1;
    const Vec3 at{std::sqrt(1 - cosine * cosine), 0, cosine};
    mean_square += std::pow(irradiance(at, {0, 0, offset}), 2) / kSteps;
  }
  return mean_square - 1;
}

}  // namespace

Vec3 any_view() { return *direction_above_at(real(0.07, 0.999)); }

void showValue(const Room& room, std::ostream& out) {
  const pt::SurfacePoint& point = room.point;
  out << room.text
      << fmt::format("point {}, n {}, wo {}, albedo {}", brief(point.p), brief(point.n),
                     brief(point.wo), brief(point.albedo));
  if (!is_black(point.emission)) out << ", emission " << brief(point.emission);
}

Ranges ordinary() { return {1e2, color(0.25, 4)}; }

Ranges extreme() {
  return {
      1e6,
      rc::gen::map(rc::gen::pair(magnitude(1e-4, 1e6), color(0.25, 1)),
                   [](const std::pair<double, Rgb>& light) { return light.first * light.second; }),
      40};
}

rc::Gen<Room> round_room(const rc::Gen<Rgb>& albedo, const Ranges& ranges) {
  return rc::gen::exec([=] {
    Pose around = *pose(ranges.small ? 1 : ranges.size);
    if (ranges.small) around.size = 1 / ranges.size;
    Room room;
    room.direct = Direct::lights;
    room.scene = inside_of_a_ball(around, *albedo);
    const Vec3 at = any_place();
    const int lights = ranges.max_lights > 1 ? *whole(1, ranges.max_lights) : 1;
    const Rgb of_walls = room.scene.materials[0].albedo;
    room.text = fmt::format("in a ball around {}, radius {:.4g}, albedo {}\n", brief(around.shift),
                            around.size, brief(of_walls));
    Rgb here, everywhere, deviation;
    for (int i = 0; i < lights; ++i) {
      const Vec3 offset = *real(0.3, 0.5) * *direction();  // for a ball of radius 1
      const Rgb intensity = *ranges.light;                 // for a ball of radius 1
      const pt::PointLight light{around.shift + around.size * offset,
                                 around.size * around.size * intensity};
      room.scene.lights.emplace_back(light);
      const Rgb reflected = of_walls * intensity / pt::kPi;
      here += reflected * irradiance(at, offset);
      everywhere += reflected;
      deviation += reflected * std::sqrt(variance_of_irradiance(length(offset)));  // an upper limit
      if (i < 3) {
        room.text += fmt::format("point light at {}, intensity {}\n", brief(light.position),
                                 brief(light.intensity));
      }
    }
    if (lights > 3) room.text += fmt::format("and {} more like them\n", lights - 3);
    room.scene = ready(std::move(room.scene));
    room.point = point_on_the_inside(room.scene, at);
    room.places = {{of_walls, here, {}, {}, {0, 1}},
                   {of_walls, everywhere, squared(deviation), {}, {0, 1}}};
    return room;
  });
}

// Weighted by the cosine, the lamp fills the part ratio^2 of the hemisphere of a point of the wall.
// It fills all directions within an angle from the normal that has the cosine c = sqrt(1 -
// ratio^2).
rc::Gen<Room> room_around_a_lamp(const rc::Gen<Rgb>& albedo, const rc::Gen<Direct>& direct,
                                 const Ranges& ranges, const rc::Gen<double>& of_radii) {
  return rc::gen::exec([=] {
    const Pose around = *pose(ranges.size);
    const double ratio = *of_radii;
    const Rgb of_wall = *albedo, of_lamp = *albedo, radiance = *ranges.light;
    Room room;
    room.direct = *direct;
    room.scene = inside_of_a_ball(around, of_wall);
    const pt::Sphere lamp{around.shift, ratio * around.size};
    room.scene.primitives.spheres.push_back(lamp);
    room.scene.material_of.push_back(1);
    room.scene.materials.push_back({"", of_lamp, radiance, ""});
    room.scene.lights.emplace_back(pt::SphereLight{lamp.center, lamp.radius, radiance});
    room.scene = ready(std::move(room.scene));

    const Vec3 at = any_place();
    const bool on_lamp = *rc::gen::arbitrary<bool>();
    room.point =
        on_lamp ? point_on(room.scene, lamp.center + lamp.radius * at, at, at, of_lamp, any_view())
                : point_on_the_inside(room.scene, at);
    if (on_lamp) room.point.emission = radiance;

    const double q = ratio * ratio, c = std::sqrt(1 - q);
    // One direction in the cone gives 2 (1 - c) cos. One in the hemisphere gives 2 cos or nothing.
    const double variance =
        room.direct == Direct::lights ? std::pow(1 - c, 4) / 3 : 4 * (1 - c * c * c) / 3 - q * q;
    const Rgb reflected = of_wall * radiance;
    const Place wall{of_wall, q * reflected, {}, variance * squared(reflected), {}};
    const Place on_the_lamp{of_lamp, {}, {}, {}, {}};
    room.places = on_lamp ? std::vector{on_the_lamp, wall} : std::vector{wall, on_the_lamp};
    room.places[on_lamp ? 0 : 1].leads =
        on_lamp ? std::array{0.0, 1.0, 0.0} : std::array{1.0, 0.0, 0.0};
    room.places[on_lamp ? 1 : 0].leads =
        on_lamp ? std::array{q, 1 - q, 0.0} : std::array{1 - q, q, 0.0};
    room.text = fmt::format(
        "in a ball around {}, radius {:.4g}, albedo {}\nround a sphere light, radius {:.4g}, "
        "albedo {}, radiance {}, a surface of its own\n",
        brief(around.shift), around.size, brief(of_wall), lamp.radius, brief(of_lamp),
        brief(radiance));
    return room;
  });
}

// One direction gives 2 albedo radiance cos, and cos is uniform.
rc::Gen<Room> glowing_room(const rc::Gen<Rgb>& albedo) {
  return rc::gen::exec([=] {
    const Rgb of_walls = *albedo, radiance = *color(0.25, 4);
    SceneMaker maker(*pose());
    for (const Rectangle& wall : cube()) maker.surface(wall, of_walls, radiance);
    const Situation made = maker.patch(of_walls, any_view(), false, radiance).done();
    const Rgb direct = of_walls * radiance;
    return Room{made.scene,
                made.point,
                Direct::hemisphere,
                {{of_walls, direct, {}, squared(direct) / 3, {1}}},
                fmt::format("a closed room of {} surfaces, all of albedo {} and emission {}\n",
                            made.scene.primitives.size(), brief(of_walls), brief(radiance))};
  });
}

// The room is so large beside the point's own surface that this hides nothing of it.
rc::Gen<Room> glowing_room_around_a_smooth_point() {
  return rc::gen::exec([] {
    SceneMaker maker(*pose());
    const Rgb of_walls = *color(0.2, 0.5), radiance = *color(0.25, 4), of_point = *color(0.7, 1);
    for (const Rectangle& wall : cube_around()) maker.surface(wall, of_walls, radiance);
    const Situation s = strongly_interpolated(maker, of_point, 1e-3);
    const Rgb here = of_point * radiance, on_walls = of_walls * radiance;
    return Room{s.scene,
                s.point,
                Direct::hemisphere,
                {{of_point, here, {}, squared(here) / 3, {0, 1}},
                 {of_walls, on_walls, {}, squared(on_walls) / 3, {0, 1}}},
                s.text};
  });
}

namespace {

// A wall above the point. The point itself is on no surface.
struct Wall {
  Pose around;
  Rectangle shape;
  Vec3 shading_normal;
  Rgb albedo;
  SceneMaker maker;

  Room seen_from(Rgb of_point, Direct direct, Rgb here, Rgb from_wall, Rgb variance) const {
    const Situation made = maker.done();
    const Vec3 n = around.direction({0, 0, 1});
    const double seen = cosine_of_polygon(shape.corners(), {}, {0, 0, 1}) / pt::kPi;
    return {made.scene,
            point_on(made.scene, around.shift, n, n, of_point, any_view()),
            direct,
            {{of_point, here, {}, {}, {0, seen}}, {albedo, from_wall, {}, variance, {}}},
            made.text};
  }
};

Wall wall_above(const rc::Gen<Rgb>& albedo, double tilt, bool smooth = false) {
  const Pose around = *pose();
  const Rectangle shape = *rectangle_above(tilt, 0.8, 2);
  const Rgb of_wall = *albedo;
  SceneMaker maker(around);
  const Vec3 n = smooth ? smooth_normal(shape) : shape.n();
  maker.surface(shape, of_wall, {}, smooth ? std::optional(n) : std::nullopt);
  return {around, shape, n, of_wall, maker};
}

}  // namespace

namespace {

// Returns whether a ray from the origin along d meets the rectangle or passes close to it, by up to
// 2 % of half a side.
bool meets(const Rectangle& shape, Vec3 d) {
  const double t = dot(shape.center, shape.n()) / dot(d, shape.n());
  if (!(t > 0)) return false;
  const Vec3 q = t * d - shape.center;
  return std::abs(dot(q, shape.u)) < 0.51 * length_squared(shape.u) &&
         std::abs(dot(q, shape.v)) < 0.51 * length_squared(shape.v);
}

}  // namespace

// The first sun lights the side of the wall that faces the point, mostly from below the point's
// horizon. The second sun is above the point; it exists if the wall does not hide it. Nothing hides
// either sun from the wall.
rc::Gen<Room> sunny_wall(const rc::Gen<Rgb>& albedo, double tilt) {
  return rc::gen::exec([=] {
    Wall wall = wall_above(albedo, tilt);
    const Rgb of_point = *albedo;
    const Vec3 n = wall.shape.n();
    Rgb here, on_wall;
    const auto add_sun = [&](Vec3 towards) {
      const Rgb irradiance = *color(0.25, 4);
      wall.maker.directional_light(towards, irradiance);
      here += irradiance * std::max(0.0, towards.z);
      on_wall += irradiance * std::max(0.0, dot(towards, n));
    };
    add_sun(pt::frame_from_normal(n).to_world(*direction_above(1.2)));
    const Vec3 second = *direction_above(1.3);
    if (!meets(wall.shape, second)) add_sun(second);
    return wall.seen_from(of_point, Direct::lights, of_point * here / pt::kPi,
                          wall.albedo * on_wall / pt::kPi, {});
  });
}

// With light sampling and with hemisphere sampling, one direction gives at most 2 albedo radiance
// cos. At least a tenth of all directions from the wall, weighted by the cosine, are in the sky: a few of
// thousands would be too few to judge their mean.
rc::Gen<Room> wall_under_the_sky(const rc::Gen<Rgb>& albedo, const rc::Gen<Direct>& direct,
                                 bool smooth) {
  const auto sees_the_sky = [](const Wall& wall) {
    return wall.around.direction(wall.shading_normal).y > -0.8;
  };
  const auto any_wall = rc::gen::exec([=] { return wall_above(albedo, 0.9, smooth); });
  return rc::gen::exec([=] {
    Wall wall = *rc::gen::suchThat(any_wall, sees_the_sky);
    const Rgb of_point = *albedo, radiance = *color(0.25, 4);
    wall.maker.sky(radiance);
    const Vec3 n = wall.around.direction(wall.shading_normal);
    const Rgb most = 2 * wall.albedo * radiance;
    const Rgb mean = most * (cosine_of_half_space({0, 1, 0}, n) / (2 * pt::kPi));
    return wall.seen_from(of_point, *direct, {}, mean, mean * (most - mean));
  });
}

}  // namespace grader::check
