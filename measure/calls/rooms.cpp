#include "measure/calls/rooms.h"

#include "grader/check/scenes/closed_forms.h"
#include "measure/calls/exact.h"
#include "scenes/meshes.h"

#include <array>

namespace measure::calls {

pt::Scene complete(pt::Scene scene) {
  scene.tracer = pt::Tracer(pt::Engine::wide, scene.primitives);
  return scene;
}

Place place(const pt::Scene& scene, pt::Vec3 origin, pt::Vec3 direction) {
  pt::Ray ray;
  ray.origin = origin;
  ray.direction = direction;
  return {surface_point(scene, ray, scene.closest(ray).value()), 0};
}

namespace {

using pt::Vec3;

constexpr std::array kSamples{1, 16};
constexpr std::uint64_t kSeed = 31;

void add_surface(pt::Scene& scene, const std::vector<Vec3>& corners, int material) {
  scene.primitives.triangles.push_back(pt::flat_triangle(corners[0], corners[1], corners[2]));
  scene.primitives.triangles.push_back(pt::flat_triangle(corners[0], corners[2], corners[3]));
  scene.material_of.insert(scene.material_of.end(), 2, material);
}

struct Lamp {
  std::vector<Vec3> corners;
  double radiance = 0;
};

// A square that shines down, as a light and as a surface.
Lamp add_lamp(pt::Scene& scene, Vec3 center, double side, double radiance) {
  const Vec3 u{side, 0, 0}, v{0, 0, side};
  scene.lights.emplace_back(pt::RectangleLight{center, u, v, {0, -1, 0}, pt::gray(radiance)});
  scene.materials.push_back({"lamp", {}, pt::gray(radiance), ""});
  const Vec3 first = center - 0.5 * u - 0.5 * v;
  const std::vector<Vec3> corners{first, first + u, first + u + v, first + v};
  add_surface(scene, corners, static_cast<int>(scene.materials.size()) - 1);
  return {corners, radiance};
}

// A floor below two lamps without shadows. The mesh next to it costs time, like other surfaces.
std::shared_ptr<const Room> make_hall() {
  constexpr double kAlbedo = 0.6;
  Room room;
  pt::Scene& scene = room.scene;
  scene.materials = {{"diffuse", pt::gray(kAlbedo), {}, ""}};
  add_surface(scene, {{-9, 0, -9}, {-9, 0, 9}, {9, 0, 9}, {9, 0, -9}}, 0);
  const std::array lamps{add_lamp(scene, {0, 1, 0}, 1, 4),
                         add_lamp(scene, {1.5, 0.5, 0.5}, 0.25, 20)};
  for (pt::Triangle triangle : scenes::to_primitives(scenes::make_blob(4000)).triangles) {
    for (Vec3* corner : {&triangle.p0, &triangle.p1, &triangle.p2}) *corner += Vec3{-4, 1.2, 0};
    scene.primitives.triangles.push_back(triangle);
    scene.material_of.push_back(0);
  }
  scene = complete(std::move(scene));
  pt::Sampler sampler(kSeed);
  for (int i = 0; i < kPlaces; ++i) {
    Vec3 at = in_cube(1, sampler);
    at.y = 0;
    const Vec3 eye = at + 0.1 * normalize(Vec3{at.z, 1, -at.x});
    Place each = place(scene, eye, normalize(at - eye));
    for (const Lamp& lamp : lamps) {
      each.truth += kAlbedo / pt::kPi * lamp.radiance *
                    grader::check::cosine_of_polygon(lamp.corners, each.point.p, {0, 1, 0});
    }
    room.places.push_back(each);
  }
  return std::make_shared<const Room>(std::move(room));
}

}  // namespace

Subject measure_direct(Direct direct, int of_case) {
  static const std::shared_ptr<const Room> hall = make_hall();
  const int samples = kSamples.at(of_case);
  return estimator_subject(hall->places, [direct, samples](const Place& at, pt::Sampler& sampler) {
    return Estimate{luminance(direct(hall->scene, at.point, samples, sampler)), 0};
  });
}

}  // namespace measure::calls
