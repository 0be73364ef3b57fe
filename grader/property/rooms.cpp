#include "grader/property/rooms.h"

#include "grader/property/closed_forms.h"
#include "grader/property/generators.h"
#include "grader/property/show.h"

#include <utility>

#include <fmt/format.h>

namespace grader {

using pt::Rgb;
using pt::Vec3;

namespace {

// A point with the normal n, on wo's side; wo is given around n as z.
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

Rgb any_radiance() { return *color(0.25, 4); }

// A dull ball around the middle of the pose, of its size.
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
                  scene.materials[0].albedo, *direction_above());
}

}  // namespace

Rgb Room::sum(int from, int to) const {
  Rgb sum;
  for (int k = from; k <= to; ++k) sum += bounce[k];
  return sum;
}

void showValue(const Room& room, std::ostream& out) { out << room.text << show(room.point); }

rc::Gen<Room> round_room(const rc::Gen<Rgb>& albedo) {
  return rc::gen::exec([=] {
    const Pose around = *pose();
    Room room;
    room.scene = inside_of_a_ball(around, *albedo);
    const Vec3 offset = *real(0.3, 0.5) * *direction();  // of the light, for a ball of radius 1
    const Rgb intensity = any_radiance();
    const pt::PointLight light{around.shift + around.size * offset,
                               around.size * around.size * intensity};
    room.scene.lights.emplace_back(light);
    room.scene = ready(std::move(room.scene));

    const Vec3 at = *direction();
    room.point = point_on_the_inside(room.scene, at);
    const Rgb reflected = room.point.albedo * intensity / pt::kPi;
    const double distance = length(at - offset);
    room.bounce = {{}, reflected * (dot(at - offset, at) / (distance * distance * distance))};
    for (int k = 2; k <= kMostBounces; ++k) {
      room.bounce.push_back(reflected * power_sum(room.point.albedo, k - 1, k - 1));
    }
    room.text =
        fmt::format("in a ball around {}, radius {}, albedo {}\npoint light at {}, intensity {}\n",
                    show(around.shift), around.size, show(room.point.albedo), show(light.position),
                    show(light.intensity));
    return room;
  });
}

// With q the part of what an outer point sees, weighed by the cosine, that the lamp fills, the
// light that leaves the wall and the lamp after k bounces is
//   wall_k = albedo of the wall ((1 - q) wall_(k-1) + q lamp_(k-1))
//   lamp_k = albedo of the lamp wall_(k-1)
rc::Gen<Room> room_around_a_lamp(const rc::Gen<Rgb>& albedo) {
  return rc::gen::exec([=] {
    const Pose around = *pose();
    const double ratio = *real(0.4, 0.7);
    const Rgb of_wall = *albedo, of_lamp = *albedo, radiance = any_radiance();
    Room room;
    room.scene = inside_of_a_ball(around, of_wall);
    const pt::Sphere lamp{around.shift, ratio * around.size};
    room.scene.primitives.spheres.push_back(lamp);
    room.scene.material_of.push_back(1);
    room.scene.materials.push_back({"", of_lamp, radiance, ""});
    room.scene.lights.emplace_back(pt::SphereLight{lamp.center, lamp.radius, radiance});
    room.scene = ready(std::move(room.scene));

    const Vec3 at = *direction();
    const bool on_lamp = *rc::gen::arbitrary<bool>();
    room.point = on_lamp ? point_on(room.scene, lamp.center + lamp.radius * at, at, at, of_lamp,
                                    *direction_above())
                         : point_on_the_inside(room.scene, at);
    if (on_lamp) room.point.emission = radiance;
    Rgb wall_leaves, lamp_leaves = radiance;
    room.bounce = {{}};
    for (int k = 1; k <= kMostBounces; ++k) {
      const double q = ratio * ratio;
      const Rgb before = wall_leaves;
      wall_leaves = of_wall * ((1 - q) * before + q * lamp_leaves);
      lamp_leaves = of_lamp * before;
      room.bounce.push_back(on_lamp ? lamp_leaves : wall_leaves);
    }
    room.text = fmt::format(
        "in a ball around {}, radius {}, albedo {}\nround a sphere light, radius {}, albedo {}, "
        "radiance {}, a surface of its own\n",
        show(around.shift), around.size, show(of_wall), lamp.radius, show(of_lamp), show(radiance));
    return room;
  });
}

rc::Gen<Room> glowing_room(const rc::Gen<Rgb>& albedo) {
  return rc::gen::exec([=] {
    const Rgb of_walls = *albedo, radiance = any_radiance();
    Stage stage(*pose());
    for (const Rectangle& wall : cube()) stage.surface(wall, of_walls, radiance);
    const Situation made = stage.patch(of_walls, *direction_above(), false, radiance).done();
    Room room{made.scene, made.point, {{}}, ""};
    room.text = fmt::format("a closed room of {} surfaces, all of albedo {} and emission {}\n",
                            made.scene.primitives.size(), show(of_walls), show(radiance));
    for (int k = 1; k <= kMostBounces; ++k) {
      room.bounce.push_back(radiance * power_sum(of_walls, k, k));
    }
    return room;
  });
}

rc::Gen<Room> sunny_wall(const rc::Gen<Rgb>& albedo) {
  return rc::gen::exec([=] {
    const Pose around = *pose();
    const Rectangle wall = *rectangle_above(0.9, 0.8, 2);
    const Rgb of_wall = *albedo, irradiance = any_radiance();
    const Vec3 to_sun = pt::frame_from_normal(wall.n()).to_world(*direction_above(1.2));
    Stage stage(around);
    stage.surface(wall, of_wall).directional_light(to_sun, irradiance);
    const Situation made = stage.done();

    Room room{made.scene, {}, {{}, {}}, made.text};
    const Vec3 n = around.direction({0, 0, 1});
    room.point = point_on(room.scene, around.shift, n, n, *albedo, *direction_above());
    const double seen = cosine_of_polygon(wall.corners(), {}, {0, 0, 1}) / pt::kPi;
    room.bounce.push_back(room.point.albedo * of_wall * irradiance *
                          (dot(to_sun, wall.n()) * seen / pt::kPi));
    room.bounce.resize(kMostBounces + 1);
    return room;
  });
}

}  // namespace grader
