#include "writeup/cheapest/options.h"

#include "pt/error.h"
#include "pt/render/option_words.h"

#include <charconv>
#include <cstdlib>
#include <string>
#include <thread>
#include <vector>

#include <CLI/CLI.hpp>

namespace writeup::cheapest {

namespace {

const char* kFooter =
    "The error is relative: the root of the mean over the pixels of (x - g)^2 / (g + .01)^2, where "
    "g is\n"
    "what the picture would be without noise and with all bounces. Times are of one processor.\n\n"
    "Examples:\n"
    "  ./run cheapest scenes/box_spheres.dae\n"
    "  ./run cheapest scenes/box_spheres.dae --error 1% --out box\n"
    "  ./run cheapest scenes/box_spheres.dae --from student\n";

// "2%", "2 %" or ".02".
double error_of(std::string word) {
  double unit = 1;
  if (!word.empty() && word.back() == '%') {
    unit = 0.01;
    word.pop_back();
  }
  while (!word.empty() && word.back() == ' ') word.pop_back();
  double value = 0;
  const auto [end, problem] = std::from_chars(word.data(), word.data() + word.size(), value);
  const bool whole = problem == std::errc{} && end == word.data() + word.size();
  if (!whole || !(value * unit > 0 && value * unit <= 1)) {
    throw pt::Error("--error takes a part of the radiance above 0 and at most 1, as 2% or .02");
  }
  return value * unit;
}

}  // namespace

Options parse_options(int argc, const char* const* argv) {
  Options options;
  options.threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  std::vector<int> size;
  std::string error = "2%";
  CLI::App app("Finds the settings that render a scene with a given error in the least time.",
               "./run cheapest");
  app.footer(kFooter);
  app.add_option("scene", options.scene, "Scene file (.dae)")->required();
  app.add_option("--error", error, "The error wanted, as 2% or .02")->capture_default_str();
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
      ->check(CLI::Range(2, 36000))
      ->capture_default_str();
  app.add_option("--out", options.out, "A folder for charts and their numbers; default: none");
  app.add_option("--seed", options.seed, "Of the random numbers")->capture_default_str();
  app.add_option("-t,--threads", options.threads, "Threads; default: one per processor")
      ->check(CLI::Range(1, 1024));
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp& help) {
    std::exit(app.exit(help));
  } catch (const CLI::ParseError& problem) {
    throw pt::Error(std::string(problem.what()) + "; see ./run cheapest --help");
  }
  if (!size.empty()) {
    options.width = size[0];
    options.height = size[1];
  }
  options.error = error_of(error);
  return options;
}

}  // namespace writeup::cheapest
