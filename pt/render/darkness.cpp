#include "pt/render/darkness.h"

#include "pt/geometry/spawn_ray.h"
#include "pt/image/tone_map.h"
#include "pt/render/choose_engine.h"
#include "pt/scene/frame_camera.h"
#include "pt/todo_list.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace pt {

namespace {

constexpr int kVisible = 26;  // of 255: a picture that is darker everywhere looks black

// The surfaces that a grid of rays meets, each ray the nearest. The tasks may be a learner's, so that no task is called here.
struct Reach {
  double nearest = kInfinity;  // as if nothing were clipped
  double farthest = 0;
  bool is_shown = false;     // the camera does not clip all of them
  bool is_coloured = false;  // of those that it shows, some are not black
  bool is_lit = false;       // some send light to the camera by the bounces 0 and 1 that are shown
};

// Takes one sample of each light.
bool is_lit(const View& view, const Tracer& tracer, const SurfacePoint& point, Sampler& sampler) {
  const PathSettings& settings = view.settings;
  if (settings.from <= 0 && !is_black(point.emission)) return true;
  if (settings.from > 1 || settings.to < 1 || is_black(point.albedo)) return false;
  for (const Light& light : view.scene.lights) {
    const LightSample sample = sample_light(light, point.p, sampler);
    if (!(dot(point.n, sample.wi) > 0) || is_black(sample.radiance)) continue;
    const Ray ray = shadow_ray(point, sample.wi, sample.distance);
    if (!tracer.occluded(view.scene.primitives, ray)) return true;
  }
  return false;
}

Reach reach_of_view(const View& view, const Tracer& tracer) {
  constexpr int kRays = 64;
  const Scene& scene = view.scene;
  Sampler sampler(1);
  Reach reach;
  for (int i = 0; i < kRays * kRays; ++i) {
    const int row = i / kRays;
    const Ray seen = look_through(view.camera, (i % kRays + 0.5) / kRays, (row + 0.5) / kRays);
    Ray ray = seen;
    ray.t_min = 0;
    ray.t_max = kInfinity;
    if (const std::optional<Hit> hit = tracer.closest(scene.primitives, ray)) {
      reach.nearest = std::min(reach.nearest, hit->t);
      reach.farthest = std::max(reach.farthest, hit->t);
    }
    if (const std::optional<Hit> hit = tracer.closest(scene.primitives, seen)) {
      const Material& material = scene.materials[scene.material_of[hit->primitive]];
      const SurfacePoint point = surface_point(scene, seen, *hit);
      reach.is_shown = true;
      reach.is_coloured |= !is_black(point.albedo) || !is_black(material.emission);
      reach.is_lit = reach.is_lit || is_lit(view, tracer, point, sampler);
    }
  }
  return reach;
}

bool is_met_by_a_pixel(const View& view, const Tracer& tracer) {
  for (int y = 0; y < view.height; ++y) {
    for (int x = 0; x < view.width; ++x) {
      const Ray ray = look_through(view.camera, (x + 0.5) / view.width, (y + 0.5) / view.height);
      if (tracer.closest(view.scene.primitives, ray)) return true;
    }
  }
  return false;
}

bool stands_in_a_lamp(const View& view) {
  const Scene& scene = view.scene;
  for (int i = 0; i < scene.primitives.size(); ++i) {
    if (scene.primitives.is_triangle(i)) continue;
    const Sphere& sphere = scene.primitives.sphere(i);
    if (!is_black(scene.materials[scene.material_of[i]].emission) &&
        length(view.camera.position - sphere.center) < sphere.radius) {
      return true;
    }
  }
  return false;
}

bool has_lamp_of_faces(const Scene& scene) {
  return std::ranges::any_of(scene.lights, [](const Light& light) {
    return std::holds_alternative<RectangleLight>(light) ||
           std::holds_alternative<MeshLight>(light);
  });
}

// The tasks of this render that are stubs. Without the tree, its tasks take no part.
std::vector<std::string> unwritten_here(Engine engine) {
  std::vector<std::string> tasks = todo_list();
  if (engine != Engine::task) {
    std::erase_if(tasks,
                  [](const std::string& task) { return std::ranges::count(kTreeTasks, task) > 0; });
  }
  return tasks;
}

}  // namespace

std::string note_on_darkness(const View& view, double brightest, double exposure) {
  if (encode(brightest, exposure) >= kVisible) return "";
  if (brightest > 0) {
    return fmt::format(
        "the picture is too dark to see: its brightest pixel has the radiance {:.2g}; give "
        "--exposure {:.2g}",
        brightest, 1 / brightest);
  }
  const std::vector<std::string> unwritten = unwritten_here(view.scene.tracer.engine());
  if (!unwritten.empty()) {
    return fmt::format("the picture is black: write {} before you look for another reason",
                       fmt::join(unwritten, ", "));
  }
  const std::string advice = "; give another --camera, such as fit, which clips nothing";
  const Tracer tracer(Engine::wide, view.scene.primitives);
  const Reach reach = reach_of_view(view, tracer);
  if (reach.nearest == kInfinity) {
    return "the picture is black: the camera looks past all surfaces" + advice;
  }
  if (!reach.is_shown) {
    return fmt::format(
        "the picture is black: the camera clips all surfaces, it shows what is {:.4g} to {:.4g} "
        "away (znear, zfar) and they are {:.4g} to {:.4g} away{}",
        view.camera.near_clip, view.camera.far_clip, reach.nearest, reach.farthest, advice);
  }
  if (view.settings.show_normals && is_met_by_a_pixel(view, tracer)) {
    return "the picture is black, though pixels look at surfaces: a task of part 1 or 2 is wrong; "
           "./run grade finds it";
  }
  if (view.settings.show_normals) {
    return "the picture is black: the surfaces in view are smaller than a pixel; give a larger -r, "
           "or --camera fit";
  }
  if (!reach.is_coloured) {
    return "the picture is black: the surfaces in view reflect nothing, because their materials "
           "state a black diffuse colour; give them another";
  }
  if (!reach.is_lit && stands_in_a_lamp(view)) {
    return "the picture is black: the camera stands inside an emitting sphere, which shines "
           "outwards; for a sky use an ambient light";
  }
  if (reach.is_lit) {
    return "the picture is black, though light reaches the surfaces in view: no sample found it, "
           "or "
           "a task is wrong; give more samples (-s) and leave out -H, and ./run grade finds the "
           "task";
  }
  return std::string(
             "the picture is black: no light reaches the surfaces in view by the bounces that are "
             "shown (-m, --show); --light camera puts a lamp at the camera") +
         (has_lamp_of_faces(view.scene) ? "; the file's lamps shine only to the side from which "
                                          "their corners run anticlockwise"
                                        : "");
}

}  // namespace pt
