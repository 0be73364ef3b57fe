#include "grader/check/generators/generators.h"
#include "grader/check/scenes/closed_forms.h"
#include "grader/check/scenes/rooms.h"
#include "grader/check/scenes/smooth_shading.h"

#include <cmath>
#include <utility>

#include <fmt/format.h>

// Rooms between two balls, of which one is black. Weighted by the cosine, all parts of a ball of the
// same area get the same share of the light that a point of it reflects.

namespace grader::check {

using pt::Rgb;
using pt::Vec3;
using Direct = pt::PathSettings::Direct;

namespace {

// Adds the space that is inside of both balls. The light is in the centre of the bright one.
void inside_of_both(pt::Scene& scene, const pt::Sphere& bright, Rgb albedo, Rgb light,
                    const pt::Sphere& black) {
  for (const auto& [ball, of_ball] : {std::pair{bright, albedo}, std::pair{black, Rgb{}}}) {
    scene.primitives.spheres.push_back(ball);
    scene.material_of.push_back(static_cast<int>(scene.materials.size()));
    scene.materials.push_back({"", of_ball, {}, ""});
  }
  scene.lights = {pt::PointLight{bright.center, bright.radius * bright.radius * light}};
  scene = ready(std::move(scene));
}

std::string text_of(const pt::Sphere& bright, Rgb albedo, Rgb light, const pt::Sphere& black) {
  return fmt::format(
      "in a ball around {}, radius {:.4g}, albedo {}, and also in a black ball around {}, radius "
      "{:.4g}\na point light in the centre of the first ball, irradiance {}\n",
      brief(bright.center), bright.radius, brief(albedo), brief(black.center), black.radius,
      brief(light));
}

}  // namespace

// A ball of radius r whose centre is on a sphere of radius R contains the part (r / 2R)^2 of it.
rc::Gen<Room> dented_room(const rc::Gen<Rgb>& albedo) {
  return rc::gen::exec([=] {
    const Pose around = *pose();
    const Vec3 towards = *direction();
    const double bright = *real(0.5, 0.7);
    const Rgb of_wall = *albedo, light = *color(0.25, 4), direct = of_wall * light / pt::kPi;
    const pt::Sphere ball{around.shift, around.size};
    const pt::Sphere black{around.shift + around.size * towards,
                           2 * around.size * std::sqrt(bright)};
    Room room;
    room.direct = Direct::lights;
    inside_of_both(room.scene, ball, of_wall, light, black);
    const Vec3 at =
        pt::frame_from_normal(towards).to_world(*direction_above_at(real(1.01 - 2 * bright, 1)));
    const pt::Ray ray{ball.center, at};
    room.point = surface_point(room.scene, ray, *room.scene.closest(ray));
    room.point.wo = room.point.frame.to_world(any_view());
    room.places = {{of_wall, direct, {}, {}, {bright}}};
    room.text = text_of(ball, of_wall, light, black);
    return room;
  });
}

// The seam of the two balls goes around the point, so that the bright ball is seen in all directions
// on one side of a plane. The wall and the point are so small beside it that they are at the same
// place.
rc::Gen<Room> smooth_wall_in_a_hall() {
  return rc::gen::exec([] {
    const Pose around = *pose();
    const Rectangle shape = *rectangle_above(0.6, 0.7, 1.1);
    const Vec3 of_shape = smooth_normal(shape);
    const Rgb of_point = *color(0.5, 1), of_wall = *color(0.5, 1), of_hall = *color(0.2, 0.4);
    const Rgb light = *color(0.25, 4);
    SceneMaker maker(around);
    const bool behind = *rc::gen::arbitrary<bool>();
    maker.surface(behind ? shape.flipped() : shape, of_wall, {}, behind ? -of_shape : of_shape);
    Situation made = maker.point(of_point, any_view()).done();

    // The seam's plane goes through the middle of the wall, too, along the side v.
    const bool lower_half = *rc::gen::arbitrary<bool>();
    const Vec3 along_u = normalize(cross(shape.v, shape.center));
    const Vec3 towards = (dot(along_u, shape.u) > 0) == lower_half ? -along_u : along_u;
    const double radius = 1e3 * around.size, off = *real(0.1, 0.3);
    const Vec3 to_center = off * radius * around.direction(towards);
    const pt::Sphere bright{around.shift - to_center, radius};
    const pt::Sphere black{around.shift + to_center, radius};
    inside_of_both(made.scene, bright, of_hall, light, black);
    made.point.scale = coordinate_size(made.scene.primitives);

    const auto half = [&](Vec3 n) { return cosine_of_half_space(towards, n) / pt::kPi; };
    const auto seen = [](const Rectangle& part) {
      return cosine_of_polygon(part.corners(), {}, {0, 0, 1}) / pt::kPi;
    };
    const double beside =
        half({0, 0, 1}) - seen(shape.part(lower_half ? 0 : 0.5, lower_half ? 0.5 : 1, 0, 1));
    return Room{made.scene,
                made.point,
                Direct::lights,
                {{of_point, {}, {}, {}, {0, seen(shape), beside}},
                 {of_wall, {}, {}, {}, {0, 0, half(of_shape)}},
                 {of_hall, of_hall * light / pt::kPi, {}, {}, {0, 0, (1 - off) / 2}}},
                made.text + text_of(bright, of_hall, light, black)};
  });
}

}  // namespace grader::check
