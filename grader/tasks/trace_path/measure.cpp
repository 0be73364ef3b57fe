#include "grader/check/scenes/closed_forms.h"
#include "measure/calls/exact.h"
#include "measure/calls/rooms.h"
#include "pt/tasks/trace_path.h"

namespace measure::calls {

namespace {

using pt::Rgb;
using pt::Vec3;

constexpr int kBounces = 5;
constexpr std::uint64_t kSeed = 31;

// The inside of a ball of radius 1 with a point light. From any point of a sphere, all patches of the same
// area get the same share of reflected light, so that the light of the second and later bounces is the same
// everywhere.
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

Subject measure_trace_path(int) {
  const std::shared_ptr<const Room> ball = make_ball();
  pt::PathSettings settings;
  settings.from = 1;
  settings.to = kBounces;
  return estimator_subject(ball->places, [ball, settings](const Place& at, pt::Sampler& sampler) {
    return Estimate{luminance(pt::trace_path(ball->scene, at.point, settings, sampler)), 0};
  });
}

}  // namespace measure::calls
