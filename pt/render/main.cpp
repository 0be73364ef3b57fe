#include "pt/end_of_program.h"
#include "pt/file.h"
#include "pt/image/film.h"
#include "pt/render/choose_engine.h"
#include "pt/render/darkness.h"
#include "pt/render/options.h"
#include "pt/render/output.h"
#include "pt/render/progress.h"
#include "pt/render/rounds.h"
#include "pt/scene/load_collada.h"
#include "pt/scene/view.h"
#include "pt/todo_list.h"

#include <algorithm>
#include <atomic>
#include <csignal>
#include <cstdio>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace pt {
namespace {

std::atomic<bool> interrupted = false;                  // set by Ctrl-C
std::atomic<int> caught = 0;                            // the signal
static_assert(std::atomic<bool>::is_always_lock_free);  // or a signal handler could not set it

constexpr int kSignalExit = 128;  // added to a signal's number, as shells do

// A second signal of the same kind ends the program at once. One that is ignored stays so (nohup).
void catch_signals() {
#ifdef SIGHUP
  constexpr int kHangUp = SIGHUP;
#else
  constexpr int kHangUp = SIGTERM;  // Windows has no other
#endif
  for (const int number : {SIGINT, SIGTERM, kHangUp}) {
    const auto stop = [](int which) {
      interrupted = true;
      caught = which;
      std::signal(which, SIG_DFL);
    };
    if (std::signal(number, stop) == SIG_IGN) std::signal(number, SIG_IGN);
  }
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
      rays * 1e-6 / std::max(result.seconds, 1e-9),
      rays * 1e-6 / std::max(result.cpu_seconds, 1e-9));
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
  check_targets(options);
  Film start = picture_to_go_on_with(options);
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

  catch_signals();
  Progress progress;
  const RenderResult result = render_rounds(
      view, settings, std::move(start), options.seconds, [&](double part) { progress.show(part); },
      &interrupted);
  progress.clear();
  const std::string unwritten = unwritten_tasks(options, loaded.scene);
  const std::string darkness =
      result.complete ? note_on_darkness(view, brightest(result.film), options.exposure) : "";
  if (!unwritten.empty()) fmt::print(stderr, "{}\n", unwritten);
  print_summary(result, options, loaded.scene);
  if (!darkness.empty()) fmt::print(stderr, "{}\n", darkness);
  if (!options.notes.empty()) {
    write_file(options.notes, unwritten.empty() ? darkness : unwritten);
  }
  write_pictures(options, result.film);
  if (result.complete) return 0;
  fmt::print(stderr, "{}\n", note_on_missing_samples(options, result.film, caught != 0));
  return caught != 0 ? kSignalExit + caught : 0;
}

}  // namespace
}  // namespace pt

int main(int argc, char** argv) {
  return pt::run_program([&] { return pt::run(argc, argv); });
}
