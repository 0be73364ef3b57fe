#include "pt/render/options.h"

#include "pt/command_line.h"
#include "pt/error.h"
#include "pt/number.h"

#include <array>
#include <cmath>
#include <iostream>
#include <map>
#include <string>
#include <thread>
#include <vector>

#include <CLI/CLI.hpp>

namespace pt {

namespace {

const std::map<std::string, Show> kShow{{"full", Show::full},
                                        {"direct", Show::direct},
                                        {"indirect", Show::indirect},
                                        {"bounce", Show::bounce},
                                        {"normals", Show::normals}};

constexpr int kMaxSamples = 1 << 24;

const char* kFooter =
    "--from chooses the implementation of the tasks: ./run render --from student for all of them, "
    "or\n"
    "--from hit_bvh=student for one; the default is reference, and in a handout student. A name "
    "like\n"
    "hit_bvh=first_child_that_hits takes a mistake that the handbook shows.\n\n"
    "Examples:\n"
    "  ./run render scenes/box_spheres.dae -f box.png -s 64 -l 4 -m 5\n"
    "  ./run render scenes/box_spheres.dae -f normals.png --show normals\n"
    "  ./run render scenes/box_spheres.dae -f adaptive.png -s 1024 -a 32 0.05\n";

// Options of two values come as vectors.
struct Pairs {
  std::vector<int> size;
  std::vector<double> adaptive;
};

void describe_picture(CLI::App& app, RenderOptions& options, Pairs& pairs) {
  app.add_option("scene", options.scene, "Scene file (.dae)")->required();
  app.add_option("-f,--output", options.output,
                 "Picture to write: .png, or .exr with mean and variance; default <scene>.png");
  app.add_option("--notes", options.notes)->group("");
  app.add_option(
         "-r,--size", pairs.size,
         "Width and height in pixels, default 480 360; with --camera course they cut a window "
         "out of a picture of 800 x 600, with fit and file they scale it")
      ->expected(2)
      ->allow_extra_args(false)
      ->check(CLI::Range(1, 16384))
      ->type_name("W H");
  app.add_option("--show", options.show, "What to show")
      ->transform(CLI::CheckedTransformer(kShow, CLI::ignore_case).description(""))
      ->type_name("full|direct|indirect|bounce|normals")
      ->default_str("full");
  app.add_option("--bounce", options.bounce, "Which bounce alone, with --show bounce")
      ->check(CLI::Range(0, 10000))
      ->capture_default_str();
  app.add_option("--exposure", options.exposure,
                 "Factor on radiance in a .png; 1.4142 matches the course's pictures")
      ->check(check_above_zero)
      ->capture_default_str();
  app.add_option(
         "--camera", options.framing,
         "course: the course's framing rule, for files in its dialect; fit: the file's field "
         "of view from far enough to see everything; file: the file's own camera")
      ->transform(CLI::CheckedTransformer(kFramingWords, CLI::ignore_case).description(""))
      ->type_name("course|fit|file")
      ->default_str("course");
}

// "90", "90s", "10m" or "1.5h" in seconds.
double read_time(const std::string& word) {
  const std::size_t end = word.find_last_not_of("smh") + 1;
  const auto value = number_in<double>(word.substr(0, end));
  const std::map<std::string, double> units{{"", 1}, {"s", 1}, {"m", 60}, {"h", 3600}};
  const auto unit = units.find(word.substr(end));
  if (!value || unit == units.end() || !(*value > 0 && *value <= 1e9)) {
    throw Error("--time takes a time such as 90s, 10m or 1.5h, not '" + word + "'");
  }
  return *value * unit->second;
}

void describe_stops(CLI::App& app, RenderOptions& options, std::string& time) {
  app.add_option("--time", time,
                 "Stop when the next round of 64 samples per pixel would not end within this time, "
                 "as 10m; -s is the maximum, by default 16777216")
      ->type_name("90s|10m|1h");
  app.add_option("--resume", options.resume,
                 "Go on with an .exr that was interrupted or has fewer samples, made with the same "
                 "options; -f is that file, unless it is given")
      ->type_name("FILE.exr");
}

void describe_transport(CLI::App& app, RenderOptions& options, Pairs& pairs) {
  app.add_option("-s,--samples", options.samples, "Camera rays per pixel (with -a: at most)")
      ->check(CLI::Range(1, kMaxSamples))
      ->capture_default_str();
  app.add_option("-l,--light-samples", options.path.light_samples,
                 "Samples per area light (with -H: directions)")
      ->check(CLI::Range(1, 1 << 20))
      ->capture_default_str();
  app.add_option("-m,--bounces", options.bounces,
                 "How often light may bounce: 0 emitters only, 1 direct light, more: indirect")
      ->check(CLI::Range(0, 10000))
      ->capture_default_str();
  app.add_option("--survival", options.path.survival,
                 "The chance of a path to go on after each bounce but the first; 1: no roulette")
      ->check([](const std::string& word) {
        const bool is_chance = check_above_zero(word).empty() && std::stod(word) <= 1;
        return is_chance ? "" : "takes a chance above 0 and at most 1, as .7";
      })
      ->capture_default_str();
  app.add_flag("-H,--hemisphere", options.hemisphere,
               "Direct light by hemisphere sampling, not by light sampling");
  app.add_option("-a,--adaptive", pairs.adaptive,
                 "Stop a pixel when its 95 % interval is narrower than TOLERANCE x mean, checked "
                 "every BATCH samples")
      ->expected(2)
      ->allow_extra_args(false)
      ->type_name("BATCH TOLERANCE");
  app.add_flag("--lambertian", options.load.lambertian,
               "Treat mirrors, glass and the like as diffuse, albedo 0.5");
  app.add_flag("--common-emission", options.load.common_emission,
               "Let surfaces emit the emission colour that exporters write (profile_COMMON)");
  app.add_option(
         "--light", options.load.light,
         std::string("file: the file's own lights, or a sky where it has none; sky: a white "
                     "sky too; camera: a lamp at the camera too; ") +
             kCourseLightHelp)
      ->transform(CLI::CheckedTransformer(kLightWords, CLI::ignore_case).description(""))
      ->type_name("file|sky|camera|course")
      ->default_str("file");
}

void describe_machine(CLI::App& app, RenderOptions& options) {
  app.add_option("-t,--threads", options.threads, "Threads; default: one per processor")
      ->check(CLI::Range(1, 1024));
  app.add_option("--engine", options.engine, "How rays are traced")
      ->transform(CLI::CheckedTransformer(kEngineWords, CLI::ignore_case).description(""))
      ->type_name("task|linear|wide")
      ->default_str("task");
  app.add_option("--leaf", options.max_leaf, "Maximum number of primitives in a leaf of the BVH")
      ->check(CLI::Range(1, 1 << 20))
      ->capture_default_str();
  app.add_option("--seed", options.seed, "Same seed, same picture, bit for bit")
      ->check(check_seed)
      ->capture_default_str();
}

AdaptiveSettings adaptive_settings(const std::vector<double>& pair, int max_samples) {
  const double batch = pair[0], tolerance = pair[1];
  if (!(batch >= 2 && batch <= max_samples && batch == std::floor(batch))) {
    throw Error("-a takes a batch of at least 2 samples and at most the maximum of -s (" +
                std::to_string(max_samples) + "): give -a BATCH TOLERANCE, as in -a 32 0.05");
  }
  if (!(tolerance > 0 && std::isfinite(tolerance))) {
    throw Error("-a takes a tolerance above 0: give -a BATCH TOLERANCE, as in -a 32 0.05");
  }
  return {max_samples, static_cast<int>(batch), tolerance};
}

}  // namespace

RenderOptions parse_options(int argc, const char* const* argv) {
  RenderOptions options;
  options.threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  Pairs pairs;
  CLI::App app("Renders a scene with the tasks of the course.", "./run render");
  app.footer(kFooter);
  describe_picture(app, options, pairs);
  describe_transport(app, options, pairs);
  describe_machine(app, options);
  std::string time;
  describe_stops(app, options, time);
  parse(app, argc, argv);
  if (!time.empty()) {
    options.seconds = read_time(time);
    if (app.count("--samples") == 0) options.samples = kMaxSamples;
    if (!pairs.adaptive.empty()) {
      throw Error("--time renders rounds of equal samples, and -a chooses them: leave out one");
    }
  }
  if (!pairs.size.empty()) {
    options.width = pairs.size[0];
    options.height = pairs.size[1];
  }
  if (!pairs.adaptive.empty()) {
    options.adaptive = adaptive_settings(pairs.adaptive, options.samples);
  }
  if (options.output.empty()) options.output = options.resume;
  if (options.output.empty()) options.output = options.scene.stem().string() + ".png";
  return options;
}

PathSettings path_settings(const RenderOptions& options) {
  PathSettings settings = options.path;
  settings.direct =
      options.hemisphere ? PathSettings::Direct::hemisphere : PathSettings::Direct::lights;
  settings.show_normals = options.show == Show::normals;
  settings.to = options.bounces;
  switch (options.show) {
    case Show::full:
    case Show::normals:
      break;
    case Show::direct:
      settings.from = settings.to = 1;
      break;
    case Show::indirect:
      settings.from = 2;
      break;
    case Show::bounce:
      settings.from = settings.to = options.bounce;
      break;
  }
  return settings;
}

}  // namespace pt
