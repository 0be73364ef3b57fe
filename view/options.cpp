#include "view/options.h"

#include "grader/pictures/recipes/recipes.h"
#include "pt/command_line.h"
#include "pt/render/options.h"

#include <vector>

#include <fmt/format.h>

namespace view {

namespace {

const char* kFooter =
    "--from chooses the implementation of the tasks, as for render: --from student, or --from "
    "hit_bvh=student\n"
    "for one; the default is reference, and in a handout student. With --submission DIR, student "
    "means the\n"
    "files of that folder, which run in the box.\n\n"
    "Examples:\n"
    "  ./run view scenes/box_spheres.dae\n"
    "  ./run view scenes/box_spheres.dae --from trace_path=student --pixel 240 100\n"
    "  ./run view scenes/box_spheres.dae --pixel 240 100 --export path.html\n"
    "  ./run view bvh_coil --pixel 44 27 --from student\n";

using Settings = std::map<std::string, std::string>;

// What a picture shows, as options of ./run render.
void add_bounces(Settings& settings, const pt::PathSettings& path) {
  settings["bounces"] = std::to_string(path.to);
  if (path.from == 1 && path.to == 1) {
    settings["show"] = "direct";
  } else if (path.from > 0 && path.from == path.to) {
    settings["show"] = "bounce";
    settings["bounce"] = std::to_string(path.to);
  } else if (path.from > 0) {
    settings["show"] = "indirect";
  }
}

// The settings of a picture by which the grader judges.
Settings settings_of(const grader::pictures::Recipe& recipe) {
  Settings settings{{"w", std::to_string(recipe.width)},
                    {"h", std::to_string(recipe.height)},
                    {"light_samples", std::to_string(recipe.settings.light_samples)},
                    {"survival", fmt::format("{}", recipe.settings.survival)},
                    {"seed", std::to_string(recipe.seed)}};
  for (const auto& [word, framing] : pt::kFramingWords) {
    if (framing == recipe.framing) settings["camera"] = word;
  }
  add_bounces(settings, recipe.settings);
  if (recipe.settings.show_normals) {
    settings["show"] = "normals";
    settings["bounces"] = "1";
  }
  if (recipe.settings.direct == pt::PathSettings::Direct::hemisphere) settings["hemisphere"] = "1";
  if (recipe.adaptive) {
    settings["adaptive"] = fmt::format("{},{},{}", recipe.adaptive->max_samples,
                                       recipe.adaptive->batch, recipe.adaptive->tolerance);
    settings["shown"] = "samples";
  }
  return settings;
}

// A picture by which the grader judges has a name; a file has an ending.
void open_recipe(Options& options, const std::filesystem::path& recipes) {
  if (options.scene.has_extension() || options.scene.has_parent_path()) {
    options.settings["whole"] = "1";
    return;
  }
  const auto all = grader::pictures::load_recipes(recipes);
  const auto& recipe = grader::pictures::find(all, options.scene.string());
  options.scene = std::filesystem::proximate(recipe.scene);
  for (const auto& [name, value] : settings_of(recipe)) options.settings.emplace(name, value);
}

}  // namespace

Options parse_options(int argc, const char* const* argv) {
  Options options;
  std::filesystem::path recipes;
  std::vector<int> size, pixel;
  int samples = 0, bounces = -1;
  CLI::App app("Shows the light of a scene in a browser, and what the paths of one pixel did.",
               "./run view");
  app.footer(kFooter);
  app.add_option("scene", options.scene,
                 "Scene file (.dae), or the name of a picture by which the grader judges")
      ->required();
  app.add_option("--pixel", pixel, "Show the paths of this pixel, counted from the bottom left")
      ->expected(2)
      ->allow_extra_args(false)
      ->type_name("X Y");
  app.add_option("-r,--size", size, "Width and height in pixels, default 480 360")
      ->expected(2)
      ->allow_extra_args(false)
      ->check(CLI::Range(16, 2048))
      ->type_name("W H");
  app.add_option("-s,--samples", samples, "Samples of the pixel, default 16")
      ->check(CLI::Range(1, 1024));
  app.add_option("-m,--bounces", bounces, "How often light may bounce, default 5")
      ->check(CLI::Range(0, 100));
  app.add_option("--port", options.port, "Port of 127.0.0.1; default: any")
      ->check(CLI::Range(1, 65535));
  app.add_flag("--no-browser", options.no_browser, "Print the address, and open nothing");
  app.add_option("--export", options.page,
                 "Write one page for this pixel (.html), or its numbers (.json), and end")
      ->type_name("FILE");
  app.add_flag("--lambertian", options.lambertian,
               "Treat mirrors, glass and the like as diffuse, albedo 0.5");
  app.add_option("--worker", options.worker, "Given by ./run")->group("");
  app.add_option("--boxed", options.boxed, "Given by ./run")->group("");
  app.add_option("--reference", options.reference, "Given by ./run")->group("");
  app.add_option("--recipes", recipes, "Given by ./run")->group("");
  app.add_option("--tasks", options.tasks, "Given by ./run")->group("");
  app.add_option("--build", options.build, "Given by ./run")
      ->expected(2)
      ->allow_extra_args(false)
      ->group("");
  app.add_option("--mixture", options.from, "Given by ./run")->group("");
  pt::parse(app, argc, argv);
  options.settings["samples"] = std::to_string(samples > 0 ? samples : 16);
  if (!size.empty()) {
    options.settings["w"] = std::to_string(size[0]);
    options.settings["h"] = std::to_string(size[1]);
  }
  if (bounces >= 0) options.settings["bounces"] = std::to_string(bounces);
  open_recipe(options, recipes);
  options.settings.merge(Settings{{"w", "480"}, {"h", "360"}, {"bounces", "5"}});
  if (!pixel.empty()) options.pixel = {pixel[0], pixel[1]};
  return options;
}

}  // namespace view
