#include "pt/end_of_program.h"
#include "pt/error.h"
#include "pt/image/film.h"
#include "pt/image/image_io.h"
#include "pt/image/sample_map.h"
#include "pt/image/tone_map.h"
#include "pt/printable.h"
#include "pt/render/choose_engine.h"
#include "pt/render/options.h"
#include "pt/render/progress.h"
#include "pt/render/render_film.h"
#include "pt/scene/field_of_view.h"
#include "pt/scene/load_collada.h"
#include "pt/scene/view.h"
#include "pt/todo_list.h"

#include <algorithm>
#include <atomic>
#include <csignal>
#include <cstdio>
#include <string>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace pt {
namespace {

constexpr int kVisible = 26;  // of 255: a picture that is darker everywhere looks black

// The distances of the nearest and the farthest surface, in view of a grid of rays that nothing
// clips; the nearest surface of each ray counts.
struct Reach {
  double nearest = kInfinity;
  double farthest = 0;
};

// The tasks may be a learner's, so that neither camera_ray nor hit_bvh is called here.
Reach reach_of_view(const View& view) {
  constexpr int kRays = 64;
  const Camera& camera = view.camera;
  const Tracer tracer(Engine::wide, view.scene.primitives);
  const double x = half_tangent(camera.hfov_deg), y = half_tangent(camera.vfov_deg);
  Reach reach;
  for (int i = 0; i < kRays * kRays; ++i) {
    const double across = (i % kRays + 0.5) / kRays * 2 - 1;
    const double up = (i / kRays + 0.5) / kRays * 2 - 1;
    const Vec3 direction = camera.camera_to_world.to_world({across * x, up * y, -1});
    const Ray ray{camera.position, normalize(direction), 0, kInfinity};
    if (const std::optional<Hit> hit = tracer.closest(view.scene.primitives, ray)) {
      reach.nearest = std::min(reach.nearest, hit->t);
      reach.farthest = std::max(reach.farthest, hit->t);
    }
  }
  return reach;
}

// Says why nothing can be seen in a picture at that exposure, and what to do; empty if something
// can. The scene has a light.
std::string note_on_darkness(const View& view, const Film& film, double exposure) {
  double brightest = 0;
  for (const FilmPixel& pixel : film.pixels) {
    brightest = std::max(brightest, max_channel(pixel.mean));
  }
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
  if (reach.nearest > view.camera.far_clip) {
    return fmt::format(
        "the picture is black: the camera clips all surfaces, its zfar is {:.4g} and the nearest "
        "is {:.4g} away{}",
        view.camera.far_clip, reach.nearest, advice);
  }
  if (reach.farthest < view.camera.near_clip) {
    return fmt::format(
        "the picture is black: the camera clips all surfaces, its znear is {:.4g} and the farthest "
        "is {:.4g} away{}",
        view.camera.near_clip, reach.farthest, advice);
  }
  if (view.settings.show_normals) {
    return "the picture is black: the surfaces in view are smaller than a pixel; give a larger -r, "
           "or --camera fit";
  }
  return "the picture is black: no light reaches the surfaces in view by the bounces that are "
         "shown (-m, --show); a lamp shines only to the side from which its corners run "
         "anticlockwise";
}

std::atomic<bool> interrupted = false;                  // set by Ctrl-C
static_assert(std::atomic<bool>::is_always_lock_free);  // or a signal handler could not set it

constexpr int kInterruptedExit = 130;  // the exit status of shells for Ctrl-C

std::filesystem::path beside(const std::filesystem::path& picture, const char* ending) {
  std::filesystem::path path = picture;
  return path.replace_filename(picture.stem().string() + ending);
}

void write_pictures(const RenderOptions& options, const Film& film) {
  write_image(options.output, film, options.exposure);
  fmt::print("wrote {}\n", printable(options.output.string()));
  if (!options.adaptive) return;
  const SampleMap map = sample_map(film, options.adaptive->max_samples);
  const auto picture = beside(options.output, "_rate.png");
  const auto counts = beside(options.output, "_rate.csv");
  write_png(picture, sample_picture(map));
  write_counts(counts, map);
  fmt::print("wrote {} and {}\n", printable(picture.string()), printable(counts.string()));
}

void print_summary(const RenderResult& result, const RenderOptions& options, const Scene& scene) {
  const double rays = static_cast<double>(result.rays.closest + result.rays.occluded);
  fmt::print("{} primitives, {} lights, engine {}, {} threads, seed {}\n", scene.primitives.size(),
             scene.lights.size(), name(scene.tracer.engine()), options.threads, options.seed);
  fmt::print(
      "{:.2f} s, {:.2f} CPU s; {:.3g} M rays ({:.0f} % shadow), {:.3g} M per second, "
      "{:.3g} M per CPU second\n",
      result.seconds, result.cpu_seconds, rays * 1e-6,
      100 * static_cast<double>(result.rays.occluded) / std::max(rays, 1.0),
      rays * 1e-6 / result.seconds, rays * 1e-6 / result.cpu_seconds);
  const auto per_ray = [&](long long count) {
    return static_cast<double>(count) / std::max(rays, 1.0);
  };
  fmt::print("tests per ray: {:.2f} boxes, {:.2f} triangles, {:.2f} spheres\n",
             per_ray(result.tests.boxes), per_ray(result.tests.triangles),
             per_ray(result.tests.spheres));
  if (result.not_finite > 0) {
    fmt::print(
        "{} samples were not finite and are left out; the first at pixel x {} y {} "
        "(from the bottom left), seed {}\n",
        result.not_finite, result.first_bad->x, result.first_bad->y, options.seed);
  } else {
    fmt::print("non-finite samples: 0\n");
  }
}

// Prints one line, however many tasks are not written.
void name_unwritten_tasks(const RenderOptions& options, const Scene& scene) {
  const std::vector<std::string> unwritten = todo_list();
  if (unwritten.empty()) return;
  const bool no_tree = options.engine == Engine::task && scene.tracer.engine() == Engine::linear;
  fmt::print(stderr, "not written yet: {}{}\n", fmt::join(unwritten, ", "),
             no_tree ? " (traced without a tree)" : "");
}

std::string note_on_no_light(const LoadedScene& loaded) {
  return fmt::format(
      "the scene has no light, so that the picture is black{}--show normals to see its surfaces",
      loaded.ignores_emission ? ": emission colours in profile_COMMON are ignored; give "
                                "--common-emission to make them shine, or "
                              : "; give ");
}

int run(int argc, const char* const* argv) {
  const RenderOptions options = parse_options(argc, argv);
  check_image_target(options.output);
  LoadedScene loaded = load_collada(options.scene, {options.lambertian, options.common_emission});
  for (const std::string& note : loaded.notes) fmt::print(stderr, "{}\n", note);
  if (const std::string note = note_on_framing(loaded, options.framing); !note.empty()) {
    fmt::print(stderr, "{}\n", note);
  }
  if (options.show != Show::normals) {
    require_supported(loaded, options.scene);
    if (loaded.scene.lights.empty()) fmt::print(stderr, "{}\n", note_on_no_light(loaded));
  }
  silence_todo();
  choose_engine(loaded.scene, options.engine, options.max_leaf);

  const View view{loaded.scene,
                  frame_camera(loaded, options.framing, options.width, options.height),
                  path_settings(options), options.width, options.height};
  const RenderSettings settings{options.samples, options.adaptive, options.seed, options.threads};

  std::signal(SIGINT, [](int) { interrupted = true; });
  std::signal(SIGTERM, [](int) { interrupted = true; });
  Progress progress;
  const RenderResult result = render_film(
      view, settings, [&](double part) { progress.show(part); }, &interrupted);
  progress.clear();
  if (!result.complete) {
    fmt::print(stderr, "interrupted: nothing was written\n");
    return kInterruptedExit;
  }
  name_unwritten_tasks(options, loaded.scene);
  print_summary(result, options, loaded.scene);
  if (options.show == Show::normals || !loaded.scene.lights.empty()) {
    const std::string note = note_on_darkness(view, result.film, options.exposure);
    if (!note.empty()) fmt::print(stderr, "{}\n", note);
  }
  write_pictures(options, result.film);
  return 0;
}

}  // namespace
}  // namespace pt

int main(int argc, char** argv) {
  return pt::run_program([&] { return pt::run(argc, argv); });
}
