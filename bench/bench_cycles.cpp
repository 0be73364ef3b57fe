// Compares our renderer with an independent one, Blender's Cycles: the radiance of each part of a picture, and error
// against time. See docs/cycles.md.
#include "bench/against_cycles.h"
#include "bench/cycles.h"
#include "bench/cycles_report.h"
#include "bench/direct_formula.h"
#include "pt/command_line.h"
#include "pt/render/choose_engine.h"
#include "pt/render/cpu_time.h"
#include "pt/render/progress.h"
#include "pt/render/render_film.h"
#include "pt/scene/frame_camera.h"
#include "tests/fixtures/temporary_folder.h"

#include <cstdio>
#include <filesystem>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace {

namespace fs = std::filesystem;

// The course's framing shows a window of 480 x 360 pixels; our pictures show the same window.
constexpr int kFramedWidth = 480, kFramedHeight = 360;
constexpr int kWidth = 240, kQuickWidth = 160;  // of our pictures
constexpr int kMaxLeaf = 4;                     // the default of ./run render

struct Options {
  std::vector<std::string> scenes;
  std::string blender = "/usr/bin/blender";
  fs::path out = FIRSTLIGHT_ROOT "/build/cycles";
  int width = 0;  // 0: the default; a picture is three quarters as high
  std::vector<int> light_samples{1, 4};
  double survival = pt::PathSettings{}.survival;
  int bounces = 5;
  int sphere_level = 7;
  int threads = 1;
  std::uint32_t seed = 1;
  bool quick = false;

  int height() const { return width * 3 / 4; }
};

struct Loaded {
  pt::LoadedScene file;
  pt::Camera camera;
  pt::StartTimes times;
};

Loaded load(const fs::path& file) {
  const double start = pt::thread_cpu_seconds();
  Loaded loaded{pt::load_collada(file), {}, {}};
  for (const std::string& note : loaded.file.notes) fmt::print(stderr, "{}\n", note);
  require_supported(loaded.file, file);
  const double read = pt::thread_cpu_seconds();
  choose_engine(loaded.file.scene, pt::Engine::wide, kMaxLeaf);
  loaded.times = {"ours", read - start, pt::thread_cpu_seconds() - read};
  loaded.camera = frame_camera(loaded.file, pt::Framing::course, kFramedWidth, kFramedHeight);
  return loaded;
}

// One contender for each number of light samples.
std::vector<pt::Contender> ours(const pt::View& picture, const Options& options) {
  std::vector<pt::Contender> all;
  for (const int l : options.light_samples) {
    const auto render = [&picture, &options, l](int samples, std::uint32_t seed) {
      pt::View view = picture;
      view.settings.light_samples = l;
      const pt::RenderResult result = render_film(view, {samples, {}, seed, options.threads});
      return pt::TimedImage{mean(result.film), result.cpu_seconds};
    };
    all.push_back({fmt::format("ours, l = {}", l), render});
  }
  return all;
}

// A running Blender that has the scene.
struct Theirs {
  Theirs(const Options& options, const Loaded& loaded, const fs::path& file)
      : cycles(options.blender, folder.path(),
               cycles_scene(loaded.file, file, loaded.camera,
                            {options.width, options.height(), options.bounces, options.threads,
                             options.sphere_level})),
        first_seconds(cycles.render(1, 0).cpu_seconds) {}

  pt::Contender contender(const std::string& title) {
    return {title,
            [this](int samples, std::uint32_t seed) { return cycles.render(samples, seed); }};
  }

  TemporaryFolder folder;
  pt::Cycles cycles;
  double first_seconds;  // for a render of one sample, which has to build the tree
};

pt::SceneReport compare_scene(const fs::path& file, const Options& options,
                              const pt::Effort& effort) {
  const Loaded loaded = load(file);
  pt::View view{loaded.file.scene, loaded.camera, {}, options.width, options.height()};
  view.settings.to = options.bounces;
  view.settings.survival = options.survival;
  pt::SceneReport report{file.stem().string(), find_regions(view), {}, {}, {loaded.times}, {}};
  report.by_formula = direct_by_formula(view, report.regions);

  Theirs blender(options, loaded, file);
  std::vector<pt::Contender> contenders = ours(view, options);
  const int first_of_theirs = static_cast<int>(contenders.size());
  contenders.push_back(blender.contender("Cycles"));
  for (const pt::Contender& each : contenders) report.titles.push_back(each.title);

  pt::Progress progress;
  report.comparison = compare(contenders, {0, first_of_theirs}, report.regions, effort,
                              [&](double part) { progress.show(part); });
  progress.clear();
  const double again = report.comparison.curves[first_of_theirs].fixed_seconds;
  report.times.push_back({"Blender " + blender.cycles.version(), blender.cycles.start_cpu_seconds(),
                          blender.first_seconds - again});
  return report;
}

int run(Options options) {
  pt::Effort effort;
  if (options.quick) effort = {8, 32, {4, 16, 64}, 2};
  effort.seed = options.seed;
  if (options.width == 0) options.width = options.quick ? kQuickWidth : kWidth;
  if (options.scenes.empty()) {
    for (const char* name : {"box_spheres", "box_gems"}) {
      options.scenes.push_back(fmt::format(FIRSTLIGHT_ROOT "/scenes/{}.dae", name));
    }
  }
  fs::create_directories(options.out);
  std::vector<pt::SceneReport> reports;
  for (const std::string& scene : options.scenes) {
    reports.push_back(compare_scene(scene, options, effort));
    fmt::print("{}\n", pt::to_text(reports.back()));
  }
  pt::write_reports(reports, options.out);
  fmt::print("wrote regions.csv, charts and their numbers, and the long renders to {}\n",
             options.out.string());
  return 0;
}

}  // namespace

int main(int count, char** arguments) {
  std::setvbuf(stdout, nullptr, _IOLBF, 0);  // prints each line at once, also into a pipe
  CLI::App app(
      "Compares our renderer with Blender's Cycles: the radiance of each part of a picture, and\n"
      "error against processor time. Writes regions.csv, and for each scene a chart and two\n"
      "long renders.",
      "./run bench cycles");
  Options options;
  app.add_option("scene", options.scenes, "scene files; default: box_spheres and box_gems")
      ->check(CLI::ExistingFile);
  app.add_flag("--quick", options.quick, "takes only a minute: small pictures, fewer samples");
  app.add_option("--out", options.out, "folder for the files")->capture_default_str();
  app.add_option("-m,--bounces", options.bounces, "for both renderers; 1 is direct light")
      ->check(CLI::Range(1, 100))
      ->capture_default_str();
  app.add_option("-l,--light-samples", options.light_samples, "for ours; each number gives a curve")
      ->check(CLI::Range(1, 100))
      ->capture_default_str();
  app.add_option("--survival", options.survival, "for ours: Russian roulette")
      ->check(CLI::Range(0.01, 1.0))
      ->capture_default_str();
  app.add_option("--width", options.width,
                 "in pixels, default 240, with --quick 160; a picture is three quarters as high")
      ->check(CLI::Range(16, 4096));
  app.add_option("--sphere-level", options.sphere_level,
                 "Cycles has no spheres: 20 x 4^(level - 1) triangles replace each")
      ->check(CLI::Range(1, 9))
      ->capture_default_str();
  app.add_option("-t,--threads", options.threads, "for both renderers")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  app.add_option("--seed", options.seed, "for the first render; each other render uses the next")
      ->check(CLI::Range(0, 1 << 30))
      ->capture_default_str();
  app.add_option("--blender", options.blender, "the program")->capture_default_str();
  return pt::run_command_line(app, count, arguments, [&] { return run(options); });
}
