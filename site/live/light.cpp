#include "pt/render/radiance.h"
#include "pt/scene/recorder.h"
#include "pt/tasks/adaptive_pixel.h"
#include "pt/tasks/camera_ray.h"
#include "pt/tasks/direct_hemisphere.h"
#include "pt/tasks/direct_lights.h"
#include "pt/tasks/estimate_pixel.h"
#include "site/live/exchange.h"
#include "site/live/room.h"

#include <cmath>

namespace site::live {

namespace {

// Lamp, yaw, pitch, width, height, first and last bounce, light samples, 1 for hemisphere sampling, survival, 1 for normals.
pt::View view_of(Given& in) {
  const pt::Scene& scene = room(in.number());
  const double yaw = in.number(), pitch = in.number();
  pt::View view{scene, camera_at(yaw, pitch), {}, 0, 0};
  view.width = in.whole();
  view.height = in.whole();
  view.settings.from = in.whole();
  view.settings.to = in.whole();
  view.settings.light_samples = in.whole();
  view.settings.direct =
      in.whole() == 1 ? pt::PathSettings::Direct::hemisphere : pt::PathSettings::Direct::lights;
  view.settings.survival = in.number();
  view.settings.show_normals = in.whole() == 1;
  return view;
}

pt::Sampler sampler_of(int seed, int x, int y) {
  return pt::Sampler::for_pixel(static_cast<std::uint64_t>(seed), x, y);
}

// The place in the picture, in [0, 1] from the bottom left.
void add_place(const pt::Camera& camera, pt::Vec3 p) {
  const pt::Vec3 local = camera.camera_to_world.to_local(p - camera.position);
  const double half = pt::kPi / 360;
  add(0.5 - local.x / local.z / (2 * std::tan(camera.hfov_deg * half)));
  add(0.5 - local.y / local.z / (2 * std::tan(camera.vfov_deg * half)));
}

}  // namespace

extern "C" {

// A view, samples, seed, first row and number of rows -> colours of these rows, each from the left.
int live_rows() {
  Given in;
  const pt::View view = view_of(in);
  const int samples = in.whole(), seed = in.whole(), first = in.whole(), rows = in.whole();
  begin();
  for (int y = first; y < first + rows; ++y) {
    for (int x = 0; x < view.width; ++x) {
      pt::Sampler sampler = sampler_of(seed, x, y);
      add(pt::estimate_pixel(view, x, y, samples, sampler));
    }
  }
  return count();
}

// A view, x, y, samples, seed -> the colour of the pixel; for each sample its place in the pixel and its colour. One sample is at the
// pixel's centre.
int live_pixel() {
  Given in;
  const pt::View view = view_of(in);
  const int x = in.whole(), y = in.whole(), samples = in.whole(), seed = in.whole();
  pt::Sampler sampler = sampler_of(seed, x, y), again = sampler;
  begin();
  add(pt::estimate_pixel(view, x, y, samples, sampler));
  for (int i = 0; i < samples; ++i) {
    const pt::Vec2 at = samples == 1 ? pt::Vec2{0.5, 0.5} : again.next_2d();
    add(at.x);
    add(at.y);
    const pt::Ray ray =
        pt::camera_ray(view.camera, (x + at.x) / view.width, (y + at.y) / view.height);
    add(pt::radiance(view.scene, ray, view.settings, again));
  }
  return count();
}

// A view, place in the picture, number, seed -> 0 if nothing is there, else 1; the luminance of so many estimates of direct light at the
// point seen there, by one direction of the hemisphere each, and then by one sample of the lamp each.
int live_direct() {
  Given in;
  const pt::View view = view_of(in);
  const double x = in.number(), y = in.number();
  const int number = in.whole(), seed = in.whole();
  const pt::Ray ray = pt::camera_ray(view.camera, x, y);
  const std::optional<pt::Hit> hit = view.scene.closest(ray);
  begin();
  add(hit ? 1 : 0);
  if (!hit) return count();
  const pt::SurfacePoint point = surface_point(view.scene, ray, *hit);
  for (const auto& estimate : {pt::direct_hemisphere, pt::direct_lights}) {
    pt::Sampler sampler = sampler_of(seed, 0, 0);
    for (int i = 0; i < number; ++i) {
      add(luminance(estimate(view.scene, point, 1, sampler)));
    }
  }
  return count();
}

// A view, place in the picture, seed -> the light along one path; for each point of the path, the camera's excluded, its place in the
// picture.
int live_path() {
  Given in;
  const pt::View view = view_of(in);
  const double x = in.number(), y = in.number();
  pt::Sampler sampler = sampler_of(in.whole(), 0, 0);
  pt::PathTape tape;
  pt::recorder.path = &tape;
  const pt::Rgb light =
      pt::radiance(view.scene, pt::camera_ray(view.camera, x, y), view.settings, sampler);
  pt::recorder.path = nullptr;
  begin();
  add(light);
  for (const pt::PathTape::TracedRay& traced : tape.rays) {
    if (traced.hit) add_place(view.camera, traced.ray.at(traced.hit->t));
  }
  return count();
}

// A view, x, y, number, seed -> the luminance of so many samples of the pixel.
int live_samples() {
  Given in;
  const pt::View view = view_of(in);
  const int x = in.whole(), y = in.whole(), number = in.whole(), seed = in.whole();
  pt::Sampler sampler = sampler_of(seed, x, y);
  begin();
  for (int i = 0; i < number; ++i) {
    const pt::Vec2 at = sampler.next_2d();
    const pt::Ray ray =
        pt::camera_ray(view.camera, (x + at.x) / view.width, (y + at.y) / view.height);
    add(luminance(pt::radiance(view.scene, ray, view.settings, sampler)));
  }
  return count();
}

// A view, largest number of samples, batch, tolerance, seed, first pixel, number of pixels -> colour and number of samples of each. Pixels
// are counted from the bottom left.
int live_adaptive() {
  Given in;
  const pt::View view = view_of(in);
  pt::AdaptiveSettings settings;
  settings.max_samples = in.whole();
  settings.batch = in.whole();
  settings.tolerance = in.number();
  const int seed = in.whole(), first = in.whole(), number = in.whole();
  begin();
  for (int i = first; i < first + number; ++i) {
    const int x = i % view.width, y = i / view.width;
    pt::Sampler sampler = sampler_of(seed, x, y);
    const pt::PixelEstimate pixel = pt::adaptive_pixel(view, x, y, settings, sampler);
    add(pixel.mean);
    add(pixel.samples);
  }
  return count();
}
}

}  // namespace site::live
