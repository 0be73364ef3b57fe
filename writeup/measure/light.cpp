#include "grader/check/closed_forms.h"
#include "pt/tasks/diffuse_bsdf.h"
#include "pt/tasks/direct_hemisphere.h"
#include "pt/tasks/direct_lights.h"
#include "pt/tasks/trace_path.h"
#include "scenes/meshes.h"
#include "writeup/measure/draw.h"
#include "writeup/measure/estimates.h"
#include "writeup/measure/precise.h"

#include <array>

namespace writeup::measure {

namespace {

using pt::Rgb;
using pt::Vec3;

constexpr std::array kSamples{1, 16};
constexpr int kBounces = 5;
constexpr std::uint64_t kSeed = 31;

// A point of a surface, and the luminance that leaves it.
struct Place {
  pt::SurfacePoint point;
  double truth = 0;
};

struct Patch {
  Rgb albedo;
  Vec3 wo;
  double truth = 0;
};

// The sky over a patch. Weighted by the cosine its mean is 1: that of wi.x is 0, that of wi.z^2 is 1/2.
double sky(Vec3 wi) { return 0.5 + 0.4 * wi.x + wi.z * wi.z; }

std::vector<Patch> patches() {
  pt::Sampler sampler(kSeed);
  std::vector<Patch> all;
  while (all.size() < kPlaces) {
    Vec3 wo = any_direction(sampler);
    wo.z = std::abs(wo.z) + 1e-3;
    const double r = between(0.1, 1, sampler), g = between(0.1, 1, sampler);
    const Rgb albedo{r, g, between(0.1, 1, sampler)};
    all.push_back({albedo, normalize(wo), luminance(albedo)});
  }
  return all;
}

// Notes the errors of f, and of the density that a sample says it has.
void look_at_bsdf(const Patch& patch, pt::Sampler& sampler, Found& found) {
  const pt::BsdfSample sample = pt::diffuse_sample(patch.albedo, patch.wo, sampler);
  for (const Rgb& f : {pt::diffuse_f(patch.albedo, patch.wo, sample.wi), sample.f}) {
    for (int channel = 0; channel < 3; ++channel) {
      keep_largest(found.errors[0], f[channel] * pt::kPi / patch.albedo[channel] - 1);
    }
  }
  keep_largest(found.errors[0], sample.pdf / pt::diffuse_pdf(patch.wo, sample.wi) - 1);
}

pt::Scene complete(pt::Scene scene) {
  scene.tracer = pt::Tracer(pt::Engine::wide, scene.primitives);
  return scene;
}

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

struct Room {
  pt::Scene scene;
  std::vector<Place> places;
};

// The point that the ray from `origin` meets.
Place place(const pt::Scene& scene, Vec3 origin, Vec3 direction) {
  pt::Ray ray;
  ray.origin = origin;
  ray.direction = direction;
  return {surface_point(scene, ray, scene.closest(ray).value()), 0};
}

// A floor below two lamps, none of which is hidden from it. The mesh beside costs time, as others do.
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

// The inside of a ball of radius 1 with a point light. From any point of a sphere all patches of the same area
// get the same share of what is reflected, so that the light of the second bounce and of those after it is
// the same everywhere.
std::shared_ptr<const Room> make_ball() {
  const Rgb albedo{0.8, 0.5, 0.2};
  const Vec3 light{0.6, 0, 0};
  Room room;
  room.scene.primitives.spheres = {{{0, 0, 0}, 1}};
  room.scene.material_of = {0};
  room.scene.materials = {{"colored", albedo, {}, ""}};
  room.scene.lights.emplace_back(pt::PointLight{light, pt::gray(pt::kPi)});
  room.scene = complete(std::move(room.scene));
  pt::Sampler sampler(kSeed);
  for (int i = 0; i < kPlaces; ++i) {
    Place each = place(room.scene, {0, 0, 0}, any_direction(sampler));
    const Vec3 way = light - each.point.p;
    const double direct = -dot(way, each.point.p) / std::pow(length(way), 3);
    each.truth = luminance(direct * albedo + grader::check::power_sum(albedo, 2, kBounces));
    room.places.push_back(each);
  }
  return std::make_shared<const Room>(std::move(room));
}

}  // namespace

Subject diffuse_samples() {
  const std::vector<Patch> all = patches();
  Subject subject = estimator_subject(all, [](const Patch& patch, pt::Sampler& sampler) {
    const pt::BsdfSample sample = pt::diffuse_sample(patch.albedo, patch.wo, sampler);
    return Estimate{luminance(sample.f) * sample.wi.z / sample.pdf * sky(sample.wi), 0};
  });
  subject.find = [all, estimates = subject.find](std::uint64_t seed) {
    Found found = estimates(seed);
    pt::Sampler sampler(seed + 1);
    for (const Patch& patch : all) look_at_bsdf(patch, sampler, found);
    return found;
  };
  return subject;
}

Subject direct_light(bool by_lights, int of_cases) {
  static const std::shared_ptr<const Room> hall = make_hall();
  const auto direct = by_lights ? pt::direct_lights : pt::direct_hemisphere;
  const int samples = kSamples.at(of_cases);
  return estimator_subject(hall->places, [direct, samples](const Place& at, pt::Sampler& sampler) {
    return Estimate{luminance(direct(hall->scene, at.point, samples, sampler)), 0};
  });
}

Subject paths() {
  const std::shared_ptr<const Room> ball = make_ball();
  pt::PathSettings settings;
  settings.from = 1;
  settings.to = kBounces;
  return estimator_subject(ball->places, [ball, settings](const Place& at, pt::Sampler& sampler) {
    return Estimate{luminance(pt::trace_path(ball->scene, at.point, settings, sampler)), 0};
  });
}

}  // namespace writeup::measure
