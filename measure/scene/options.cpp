#include "measure/scene/options.h"

#include "measure/scene/model.h"
#include "pt/command_line.h"
#include "pt/error.h"
#include "pt/number.h"
#include "pt/render/choose_engine.h"
#include "pt/render/options.h"
#include "pt/todo_list.h"

#include <algorithm>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace measure::scene {

namespace {

const char* kError =
    "The error is relative: the root of the mean over the pixels of (x - g)^2 / (g + d)^2, where "
    "g is\n"
    "what the picture would be without noise and d 4 % of its mean, so that the lamps' brightness "
    "does not\nmatter. Times are of one processor.\n\nExamples:\n";
const char* kCheapestExamples =
    "  ./run cheapest scenes/box_spheres.dae\n"
    "  ./run cheapest scenes/box_spheres.dae --error 1% --out box\n"
    "  ./run cheapest scenes/box_spheres.dae --from student\n";
const char* kConvergeExamples =
    "  ./run converge scenes/box_spheres.dae --out box\n"
    "  ./run converge scenes/box_spheres.dae -m 1 --from direct_lights=student\n"
    "  ./run converge scenes/box_spheres.dae --submission anna --submission ben --out box\n";

const char* kLadder =
    "The worth of an idea is a factor in time x variance: without the idea, the picture takes "
    "that\n"
    "many times as long for the same error. Times are of one processor.\n\nExamples:\n"
    "  ./run ladder scenes/box_spheres.dae --out box\n"
    "  ./run ladder scenes/box_blob.dae -s 16 --seconds 300\n";

// "2%", "2 %" or ".02".
double error_of(std::string word) {
  double unit = 1;
  if (!word.empty() && word.back() == '%') {
    unit = 0.01;
    word.pop_back();
  }
  while (!word.empty() && word.back() == ' ') word.pop_back();
  const auto value = pt::number_in<double>(word);
  if (!value || !(*value * unit > 0 && *value * unit <= 1)) {
    throw pt::Error("--error takes a part of the radiance above 0 and at most 1, as 2% or .02");
  }
  return *value * unit;
}

// Sorts the numbers and removes duplicates. A line needs two numbers.
std::vector<int> sorted_light_samples(std::vector<int> numbers) {
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  if (numbers.size() < 2) {
    throw pt::Error("--light-samples takes two different numbers or more, as 1,2,4,8");
  }
  return numbers;
}

// The options of all commands.
void describe(CLI::App& app, Options& options, std::vector<int>& size) {
  app.add_option("scene", options.scene, "Scene file (.dae)")->required();
  app.add_option("-r,--size", size, "Width and height of the picture, default 480 360")
      ->expected(2)
      ->allow_extra_args(false)
      ->check(CLI::Range(1, 16384))
      ->type_name("W H");
  app.add_option("--camera", options.framing, "As ./run render has it")
      ->transform(CLI::CheckedTransformer(pt::kFramingWords, CLI::ignore_case).description(""))
      ->type_name("course|fit|file")
      ->default_str("course");
  app.add_option("--engine", options.engine, "How rays are traced")
      ->transform(CLI::CheckedTransformer(pt::kEngineWords, CLI::ignore_case).description(""))
      ->type_name("task|linear|wide")
      ->default_str("wide");
  app.add_flag("--lambertian", options.lambertian,
               "Treat mirrors, glass and the like as diffuse, albedo 0.5");
  app.add_option("--seconds", options.seconds, "How long to measure; more is more exact")
      ->check(CLI::Range(0.1, 36000.0))
      ->capture_default_str();
  app.add_option("--out", options.out, "A folder for charts and their numbers; default: none");
  app.add_option("--pixels", options.pixels)->group("")->check(CLI::Range(100, 1000000));
  const auto several = [&](const char* name, std::vector<std::string>& values, const char* help) {
    return app.add_option(name, values, help)->allow_extra_args(false);
  };
  several("--submission", options.submissions,
          "Somebody else's code, in the box: a folder, an archive, or a clone of CS184's skeleton")
      ->check(CLI::ExistingPath);
  several(
      "--golden", options.goldens,
      "A right picture of this size (.exr) to measure errors against; twice: two of other seeds")
      ->check(CLI::ExistingFile);
  several("--built", options.built, "")->group("");
  several("--name", options.names, "")->group("");
  app.add_flag("--reference", options.reference)->group("");
  app.add_option("--seed", options.seed, "Of the random numbers")->capture_default_str();
  app.add_option("-t,--threads", options.threads, "Threads; default: one per processor")
      ->check(CLI::Range(1, 1024));
}

void add_bounces(CLI::App& app, Options& options) {
  app.add_option("-m,--bounces", options.bounces, "How often light may bounce")
      ->check(CLI::Range(1, 16))
      ->capture_default_str();
}

// `code`: adds options to choose the measured code. The ladder's rungs have their own code, and are
// started with an engine.
void parse(CLI::App& app, Options& options, int argc, const char* const* argv, bool code = true) {
  options.threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  std::vector<int> size;
  describe(app, options, size);
  if (!code) {
    app.get_option("--engine")->group("")->take_last();  // hidden in the help
    for (const char* name : {"--submission", "--golden"}) app.remove_option(app.get_option(name));
  }
  pt::parse(app, argc, argv);
  if (options.goldens.size() > 2) throw pt::Error("--golden takes one picture, or two");
  if (!size.empty()) {
    options.width = size[0];
    options.height = size[1];
  }
}

}  // namespace

Options parse_cheapest(int argc, const char* const* argv) {
  Options options;
  std::string error = "2%";
  CLI::App app("Finds the settings that render a scene with a given error in the least time.",
               "./run cheapest");
  app.footer(std::string(kError) + kCheapestExamples);
  app.add_option("--error", error, "The error wanted, as 2% or .02")->capture_default_str();
  app.add_option("--light-samples", options.light_samples,
                 "Numbers of light samples that are tried, two or more; default 1,2,4,8")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->type_name("L,L,...")
      ->check(CLI::Range(1, kMaxLightSamples));
  parse(app, options, argc, argv);
  options.light_samples = sorted_light_samples(std::move(options.light_samples));
  options.error = error_of(error);
  if (options.submissions.size() > 1) {
    throw pt::Error("cheapest takes one --submission; ./run converge compares several");
  }
  return options;
}

Options parse_converge(int argc, const char* const* argv) {
  Options options;
  CLI::App app(
      "Compares methods in a scene: the error that each has left after so many samples and "
      "seconds.",
      "./run converge");
  app.footer(std::string(kError) + kConvergeExamples);
  add_bounces(app, options);
  app.add_option("--beside", options.beside,
                 "The method that all are compared with, as the table has it; default: the fastest")
      ->type_name("METHOD");
  parse(app, options, argc, argv);
  return options;
}

Call parse_call(int argc, const char* const* argv) {
  const std::string command = argc > 1 ? argv[1] : "";
  if (command == "cheapest")
    return {Command::cheapest, parse_cheapest(argc - 1, argv + 1), argv[0]};
  if (command == "converge")
    return {Command::converge, parse_converge(argc - 1, argv + 1), argv[0]};
  throw pt::Error("there is no command '" + command + "': write cheapest or converge");
}

Options parse_ladder(int argc, const char* const* argv) {
  Options options;
  options.seconds = 120;
  CLI::App app(
      "A ladder from the plainest right renderer to the best one, one idea per rung: what each is "
      "worth in a scene.",
      "./run ladder");
  app.footer(kLadder);
  add_bounces(app, options);
  app.add_option("-s,--samples", options.samples, "Camera rays per pixel of each render")
      ->check(CLI::Range(4, 4096))
      ->capture_default_str();
  parse(app, options, argc, argv, false);
  return options;
}

pt::LoadedScene load_scene(const Options& options) {
  pt::LoadedScene loaded = pt::load_collada(options.scene, {options.lambertian});
  require_supported(loaded, options.scene);
  if (!options.out.empty()) std::filesystem::create_directories(options.out);
  pt::silence_todo();
  choose_engine(loaded.scene, options.engine, kMaxLeaf);
  return loaded;
}

std::string subject_of(const Options& options, const char* between) {
  // A chart's title is between quotation marks, in which gnuplot reads some signs as commands.
  std::string scene = options.scene.filename();
  for (const char sign : {'"', '`', '\\'}) std::ranges::replace(scene, sign, '_');
  return fmt::format("{}{}{}{} x {} pixels", scene,
                     options.whose.empty() ? "" : " by " + options.whose, between, options.width,
                     options.height);
}

std::string title_of(const Options& options, const std::string& settings) {
  return fmt::format("set title \"{}\\n{}\" noenhanced\n", subject_of(options, "\\n"), settings);
}

std::string caption_of(const Options& options, const std::string& what, const std::string& settings,
                       const std::string& machine) {
  return fmt::format("{}: {}, {}{}. {}", what, subject_of(options), settings,
                     machine.empty() ? "" : ", on " + machine, kErrorCaption);
}

void print_notes(const pt::LoadedScene& loaded) {
  for (const std::string& note : loaded.notes) fmt::print(stderr, "{}\n", note);
}

}  // namespace measure::scene
