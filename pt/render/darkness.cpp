#include "pt/render/darkness.h"

#include "pt/error.h"
#include "pt/image/tone_map.h"
#include "pt/scene/field_of_view.h"

#include <algorithm>

#include <fmt/format.h>

namespace pt {

namespace {

constexpr int kVisible = 26;  // of 255: a picture that is darker everywhere looks black

// The surfaces that a grid of rays meets, each ray the nearest.
struct Reach {
  double nearest = kInfinity;  // as if nothing were clipped
  double farthest = 0;
  bool is_shown = false;     // the camera does not clip all of them
  bool is_coloured = false;  // of those that it shows, some are not black
};

// The tasks may be a learner's, so that neither camera_ray nor hit_bvh is called here.
Reach reach_of_view(const View& view) {
  constexpr int kRays = 64;
  const Camera& camera = view.camera;
  const Scene& scene = view.scene;
  const Tracer tracer(Engine::wide, scene.primitives);
  const double x = half_tangent(camera.hfov_deg), y = half_tangent(camera.vfov_deg);
  Reach reach;
  for (int i = 0; i < kRays * kRays; ++i) {
    const double across = (i % kRays + 0.5) / kRays * 2 - 1;
    const double up = (i / kRays + 0.5) / kRays * 2 - 1;
    const Vec3 direction = camera.camera_to_world.to_world({across * x, up * y, -1});
    Ray ray{camera.position, normalize(direction), 0, kInfinity};
    if (const std::optional<Hit> hit = tracer.closest(scene.primitives, ray)) {
      reach.nearest = std::min(reach.nearest, hit->t);
      reach.farthest = std::max(reach.farthest, hit->t);
    }
    ray.t_min = camera.near_clip;
    ray.t_max = camera.far_clip;
    if (const std::optional<Hit> hit = tracer.closest(scene.primitives, ray)) {
      const Material& material = scene.materials[scene.material_of[hit->primitive]];
      reach.is_shown = true;
      reach.is_coloured |= !is_black(material.albedo) || !is_black(material.emission);
    }
  }
  return reach;
}

}  // namespace

std::string no_light(const LoadedScene& loaded) {
  if (!loaded.scene.lights.empty()) return "";
  return std::string("the scene has no light") +
         (loaded.ignores_emission ? ": emission colours in profile_COMMON are ignored" : "");
}

void require_light(const LoadedScene& loaded, const std::filesystem::path& file) {
  require_supported(loaded, file);
  if (const std::string what = no_light(loaded); !what.empty()) {
    throw Error(file.string() + ": " + what +
                "; add one, or give a surface the course's emission/radiance");
  }
}

std::string note_on_darkness(const View& view, double brightest, double exposure) {
  if (encode(brightest, exposure) >= kVisible) return "";
  if (brightest > 0) {
    return fmt::format(
        "the picture is too dark to see: its brightest pixel has the radiance {:.2g}; give "
        "--exposure {:.2g}",
        brightest, 1 / brightest);
  }
  const std::string advice = "; give another --camera, such as fit, which clips nothing";
  const Reach reach = reach_of_view(view);
  if (reach.nearest == kInfinity) {
    return "the picture is black: the camera looks past all surfaces" + advice;
  }
  if (!reach.is_shown) {
    return fmt::format(
        "the picture is black: the camera clips all surfaces, it shows what is {:.4g} to {:.4g} "
        "away (znear, zfar) and they are {:.4g} to {:.4g} away{}",
        view.camera.near_clip, view.camera.far_clip, reach.nearest, reach.farthest, advice);
  }
  if (view.settings.show_normals) {
    return "the picture is black: the surfaces in view are smaller than a pixel; give a larger -r, "
           "or --camera fit";
  }
  if (!reach.is_coloured) {
    return "the picture is black: the surfaces in view reflect nothing, because their materials "
           "state a black diffuse colour; give them another";
  }
  return "the picture is black: no light reaches the surfaces in view by the bounces that are "
         "shown (-m, --show); a lamp shines only to the side from which its corners run "
         "anticlockwise";
}

}  // namespace pt
