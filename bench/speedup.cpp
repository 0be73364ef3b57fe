#include "pt/error.h"
#include "pt/math/uncertain.h"
#include "pt/render/render_film.h"
#include "pt/scene/frame_camera.h"
#include "pt/scene/load_collada.h"
#include "scenes/meshes.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include <fmt/format.h>

// Prints the speed-up table of part 2 (tracing with the tree of the linked tasks, and without a
// tree) and the rate of a whole render of CBbunny. One thread, CPU time, medians. The engines take
// turns, so that a machine that slows down slows both.

namespace {

using pt::Engine;

constexpr int kRuns = 5;

pt::Scene blob_scene(int triangles) {
  pt::Scene scene;
  scene.primitives = scenes::to_primitives(scenes::make_blob(triangles));
  scene.material_of.assign(scene.primitives.size(), 0);
  scene.materials = {{"diffuse", {.7, .7, .7}, {}, ""}};
  return scene;
}

// Camera rays that show normals: the picture that part 2 of the course is about.
pt::View normals_view(const pt::Scene& scene, int width, int height) {
  pt::Camera camera;
  camera.position = {0, 0, 4};
  camera.hfov_deg = 40;
  camera.vfov_deg = 40;
  pt::PathSettings settings;
  settings.show_normals = true;
  return {scene, camera, settings, width, height};
}

struct Engines {
  double linear = 0;
  double task = 0;
};

// Microseconds per ray.
Engines time_engines(int triangles) {
  pt::Scene scene = blob_scene(triangles);
  // As many rays as the linear engine answers in about a fifth of a second.
  const int side = std::clamp(static_cast<int>(std::sqrt(2e7 / triangles)), 8, 256);
  std::vector<double> linear, task;
  for (int run = 0; run < kRuns; ++run) {
    for (const Engine engine : {Engine::linear, Engine::task}) {
      scene.tracer = pt::Tracer(engine, scene.primitives);
      const int samples = engine == Engine::linear ? 1 : 16;
      const auto result = render_film(normals_view(scene, side, side), {samples, {}, 1, 1});
      const double rays = static_cast<double>(result.rays.closest);
      (engine == Engine::linear ? linear : task).push_back(1e6 * result.cpu_seconds / rays);
    }
  }
  return {pt::median_of(linear), pt::median_of(task)};
}

void print_speedups() {
  fmt::print("{:>10}  {:>18}  {:>16}  {:>9}\n", "triangles", "linear, us per ray",
             "task, us per ray", "speed-up");
  for (const int triangles : {100, 1000, 10000, 28000, 100000}) {
    const Engines time = time_engines(triangles);
    fmt::print("{:>10}  {:>16.2f}  {:>14.3f}  {:>8.0f}x\n", triangles, time.linear, time.task,
               time.linear / time.task);
    std::fflush(stdout);
  }
}

void print_whole_render(const std::filesystem::path& file) {
  pt::LoadedScene loaded = pt::load_collada(file);
  loaded.scene.tracer = pt::Tracer(Engine::task, loaded.scene.primitives);
  pt::PathSettings settings;
  settings.light_samples = 8;
  settings.to = 6;
  const int width = 480, height = 360;
  const pt::View view{loaded.scene, frame_camera(loaded, pt::Framing::course, width, height),
                      settings, width, height};
  std::vector<double> rates;
  for (int run = 0; run < kRuns; ++run) {
    const auto result = render_film(view, {16, {}, 1, 1});
    const double rays = static_cast<double>(result.rays.closest + result.rays.occluded);
    rates.push_back(1e-6 * rays / result.cpu_seconds);
  }
  fmt::print(
      "{}, 480 x 360, -s 16 -l 8 -m 6, engine task: {:.2f} million rays per CPU second "
      "({:.2f} to {:.2f} in {} runs)\n",
      file.filename().string(), pt::median_of(rates), *std::min_element(rates.begin(), rates.end()),
      *std::max_element(rates.begin(), rates.end()), kRuns);
  std::fflush(stdout);
}

// The folder of the course's scenes; it need not exist.
std::filesystem::path course_scenes() {
  const char* folder = std::getenv("FIRSTLIGHT_COURSE_SCENES");
  return folder != nullptr ? std::filesystem::path(folder)
                           : std::filesystem::path(FIRSTLIGHT_ROOT) / "../shared/scenes";
}

}  // namespace

int main() {
  try {
    const auto bunny = course_scenes() / "sky/CBbunny.dae";
    if (std::filesystem::exists(bunny)) {
      print_whole_render(bunny);
    } else {
      fmt::print("the course's CBbunny.dae was not found (set FIRSTLIGHT_COURSE_SCENES)\n");
    }
    print_whole_render(std::filesystem::path(FIRSTLIGHT_ROOT) / "scenes/box_blob.dae");
    print_speedups();
  } catch (const pt::Error& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 2;
  }
}
