#include "pt/end_of_program.h"
#include "pt/error.h"
#include "pt/file.h"
#include "pt/image/film.h"
#include "pt/image/image_io.h"
#include "pt/image/sample_map.h"
#include "pt/image/tone_map.h"
#include "pt/printable.h"
#include "pt/render/choose_engine.h"
#include "pt/render/darkness.h"
#include "pt/render/options.h"
#include "pt/render/progress.h"
#include "pt/render/render_film.h"
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

// One line, however many tasks are not written; empty if all are.
std::string unwritten_tasks(const RenderOptions& options, const Scene& scene) {
  const std::vector<std::string> unwritten = todo_list();
  if (unwritten.empty()) return "";
  const bool no_tree = options.engine == Engine::task && scene.tracer.engine() == Engine::linear;
  return fmt::format("not written yet: {}{}", fmt::join(unwritten, ", "),
                     no_tree ? " (traced without a tree)" : "");
}

double brightest(const Film& film) {
  double most = 0;
  for (const FilmPixel& pixel : film.pixels) most = std::max(most, max_channel(pixel.mean));
  return most;
}

int run(int argc, const char* const* argv) {
  const RenderOptions options = parse_options(argc, argv);
  check_image_target(options.output);
  LoadedScene loaded = load_collada(options.scene, options.load);
  for (const std::string& note : loaded.notes) fmt::print(stderr, "{}\n", note);
  if (const std::string note = note_on_framing(loaded, options.framing); !note.empty()) {
    fmt::print(stderr, "{}\n", note);
  }
  if (options.show != Show::normals) require_supported(loaded, options.scene);
  silence_todo();
  choose_engine(loaded.scene, options.engine, options.max_leaf);

  const Camera camera = frame_camera(loaded, options.framing, options.width, options.height);
  add_camera_light(loaded, camera);
  const View view{loaded.scene, camera, path_settings(options), options.width, options.height};
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
  const std::string unwritten = unwritten_tasks(options, loaded.scene);
  const std::string darkness = note_on_darkness(view, brightest(result.film), options.exposure);
  if (!unwritten.empty()) fmt::print(stderr, "{}\n", unwritten);
  print_summary(result, options, loaded.scene);
  if (!darkness.empty()) fmt::print(stderr, "{}\n", darkness);
  if (!options.notes.empty()) {
    write_file(options.notes, unwritten.empty() ? darkness : unwritten);
  }
  write_pictures(options, result.film);
  return 0;
}

}  // namespace
}  // namespace pt

int main(int argc, char** argv) {
  return pt::run_program([&] { return pt::run(argc, argv); });
}
