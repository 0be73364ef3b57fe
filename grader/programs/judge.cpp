// judge: the verdict on a renderer that somebody else wrote, scene by scene. The exit status is 0 if every picture agrees with the
// reference, 1 if one does not, 2 if the arguments cannot be used or a picture is too noisy to say.
#include "grader/base/sha256.h"
#include "grader/renderers/judge_renderer.h"
#include "grader/report/pictures.h"
#include "grader/report/side_by_side.h"
#include "grader/report/write_reports.h"
#include "grader/service/process/spawn.h"
#include "grader/service/sandbox/probe.h"
#include "pt/command_line.h"
#include "pt/error.h"
#include "pt/file.h"
#include "pt/image/compare.h"
#include "pt/image/image_io.h"
#include "pt/render/options.h"
#include "pt/render/progress.h"
#include "pt/scene/export/export.h"
#include "pt/scene/load_collada.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <map>
#include <string>
#include <thread>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

namespace {

namespace fs = std::filesystem;
using namespace grader;
using results::State;

struct Options {
  std::vector<std::string> scenes;
  std::vector<int> size{96, 72};
  int depth = 5;
  pt::Framing framing = pt::Framing::file;
  pt::LightChoice light = pt::LightChoice::file;
  std::optional<pt::SceneFormat> format;  // of {scene}; nothing: the COLLADA file
  std::string isolation;
  report::ReportFiles files;
  std::string page;
  fs::path work = "build/judge";
  int threads = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  renderers::OtherRenderer renderer;
};

pictures::Recipe recipe_of(const fs::path& scene, const Options& options) {
  pictures::Recipe recipe;
  recipe.name = scene.stem();
  recipe.title = fmt::format("{}, {} x {}, {} bounces", scene.filename().string(), options.size[0],
                             options.size[1], options.depth);
  recipe.scene = scene;
  recipe.framing = options.framing;
  recipe.load.light = options.light;
  recipe.width = options.size[0];
  recipe.height = options.size[1];
  recipe.settings.to = options.depth;
  recipe.seed = 1;
  return recipe;
}

// The whole picture of the scene and, for a renderer that can leave bounces out, each bounce alone.
std::vector<pictures::Recipe> recipes_of(const fs::path& scene, const Options& options) {
  std::vector<pictures::Recipe> recipes{recipe_of(scene, options)};
  if (!renderers::takes_bounces(options.renderer.command)) return recipes;
  for (int bounce = 0; bounce <= options.depth; ++bounce) {
    pictures::Recipe one = recipes[0];
    one.name += fmt::format("_bounce_{}", bounce);
    one.title = fmt::format("{}, bounce {} alone", scene.filename().string(), bounce);
    one.settings.from = one.settings.to = bounce;
    recipes.push_back(one);
  }
  return recipes;
}

pt::Film golden_of(const pictures::Recipe& recipe, const Options& options) {
  pt::Progress progress;
  pt::Film golden = renderers::golden_of(recipe, options.work / "goldens", options.threads,
                                         [&](double part) { progress.show(part); });
  progress.clear();
  return golden;
}

bool is_black(const pt::Film& film) {
  return std::ranges::all_of(film.pixels, [](const auto& pixel) { return is_black(pixel.mean); });
}

// The file that the renderer reads. A sky that is not in the COLLADA file is in the others.
fs::path scene_for(const pictures::Recipe& recipe, const Options& options) {
  const pt::LoadedScene loaded = pt::load_collada(recipe.scene);
  if (!options.format && !loaded.has_own_light) {
    throw pt::Error(recipe.scene.string() +
                    ": the file has no light; add one, or give --as, whose files have a sky");
  }
  if (!options.format) return recipe.scene;
  const fs::path folder = options.work / (recipe.name + "_scene");
  fs::create_directories(folder);
  return pt::export_scene(
      {loaded.scene, pt::frame_camera(loaded, recipe.framing, recipe.width, recipe.height),
       recipe.width, recipe.height, recipe.settings.to},
      *options.format, folder, recipe.scene.string());
}

results::PictureResult judged(const pictures::Recipe& recipe, const Options& options) {
  const pt::Film golden = golden_of(recipe, options);
  if (recipe.settings.from == 0 && is_black(golden)) {
    throw pt::Error(recipe.scene.string() +
                    ": the reference sees no light; --camera fit shows the whole scene");
  }
  const fs::path beside = options.work / recipe.name;
  pictures::PictureFiles files;
  files.golden = beside.string() + "_golden.exr";
  files.render = beside.string() + ".exr";
  files.evidence = beside.string() + "_evidence.exr";
  pt::write_exr(files.golden, golden);
  return renderers::judge_renderer(recipe, golden, options.renderer, scene_for(recipe, options),
                                   files);
}

std::string described(const results::PictureResult& picture) {
  const std::string noise = picture.samples > 0
                                ? fmt::format("; {} samples a pixel, {:.2g} times our variance",
                                              picture.samples, picture.noise)
                                : "";
  const std::string after = fmt::format("{}, {:.1f} s", noise, picture.seconds);
  switch (picture.state) {
    case State::pass:
      return "agrees" + after;
    case State::too_noisy:
      return fmt::format("cannot say: {}{}", picture.text, after);
    default:
      return fmt::format("wrong: {}{}", picture.text, after);
  }
}

const char* verdict_of(State state) {
  return state == State::pass ? "agrees" : state == State::too_noisy ? "cannot say" : "wrong";
}

// A picture as a page shows it; one that could not be rendered has only its sentence.
report::SideBySide shown(const results::PictureResult& picture, const Options& options) {
  report::SideBySide pair;
  pair.title = picture.title;
  pair.verdict = verdict_of(picture.state);
  pair.text = described(picture);
  pair.right = pt::read_image(picture.golden);
  pair.right_name = "the reference";
  pair.left = picture.render.empty() ? pt::Image(pair.right.width, pair.right.height)
                                     : pt::read_image(picture.render);
  pair.left_name = options.renderer.command[0];
  if (!picture.render.empty()) {
    pair.map = pt::difference_map(pair.left, pair.right);
    pair.map_text =
        "The difference in luminance: blue where the first is darker, orange where it is brighter, "
        "full at 20 %";
  }
  return pair;
}

void write_page(const results::Results& results, const Options& options) {
  std::vector<report::SideBySide> pairs;
  for (const results::TaskResult& task : results.tasks) {
    for (const results::PictureResult& each : task.pictures) pairs.push_back(shown(each, options));
  }
  pt::write_file(options.page, report::side_by_side_page("A renderer and the reference", pairs,
                                                         "To repeat it: " + results.command));
  fmt::print("{}\n", options.page);
}

// The first that is wrong decides.
State worst_of(const std::vector<results::PictureResult>& pictures) {
  State worst = State::pass;
  for (const results::PictureResult& each : pictures) {
    if (each.state == State::pass) continue;
    if (worst == State::pass || worst == State::too_noisy) worst = each.state;
  }
  return worst;
}

int run(Options options, const std::vector<std::string>& typed) {
  renderers::require_command(options.renderer.command);
  report::check_targets(options.files);
  if (!options.page.empty()) pt::check_target(options.page);
  fs::create_directories(options.work);
  options.work = fs::absolute(options.work);
  const fs::path own = options.work / fmt::format("files.{}", getpid());
  fs::create_directories(own);
  options.renderer.folder = own;
  std::optional<sandbox::Tier> forced;
  if (!options.isolation.empty()) forced = sandbox::tier_of(options.isolation);
  const sandbox::Isolation isolation =
      sandbox::probe_isolation(FIRSTLIGHT_ROOT, options.work, forced);
  options.renderer.tier = isolation.tier;

  results::Results results;
  results.submission = fmt::format("{}", fmt::join(options.renderer.command, " "));
  results.command = fmt::format("./run judge {}", fmt::join(typed, " "));
  results.isolation = isolation.words;
  for (const std::string& scene : options.scenes) {
    results::TaskResult task;
    task.slug = fs::path(scene).stem();
    for (const pictures::Recipe& recipe : recipes_of(fs::absolute(scene), options)) {
      fmt::print("{} ... ", recipe.title);
      std::fflush(stdout);
      task.pictures.push_back(judged(recipe, options));
      fmt::print("{}\n", described(task.pictures.back()));
    }
    task.state = worst_of(task.pictures);
    results.asked.push_back(task.slug);
    results.tasks.push_back(task);
  }
  results.complete = true;
  fs::remove_all(own);
  report::write_reports(results, options.files);
  if (!options.page.empty()) write_page(results, options);
  bool is_wrong = false, is_open = false;
  for (const results::TaskResult& task : results.tasks) {
    is_wrong = is_wrong || (task.state != State::pass && task.state != State::too_noisy);
    is_open = is_open || task.state == State::too_noisy;
  }
  return is_wrong ? 1 : is_open ? 2 : 0;
}

}  // namespace

int main(int argc, char** argv) {
  process::hide_process();
  const std::vector<std::string> words(argv + 1, argv + argc);
  const auto split = std::ranges::find(words, "--");
  Options options;
  if (split != words.end()) options.renderer.command.assign(split + 1, words.end());
  CLI::App app(
      "Says whether a renderer agrees with the reference: it renders each scene again and again, "
      "in a box, until that\n"
      "is decided.",
      "./run judge");
  app.footer(
      "COMMAND is the program and its words, with {scene} {width} {height} {samples} {depth} "
      "{seed} {out} in the places of what is\n"
      "asked, and {from} {to} if it can add up bounces alone. Bounce 0 is emitted light, 1 is "
      "direct light; {depth} is the\n"
      "last. The picture is linear radiance, an average over the pixel's own square.\n\n"
      "  ./run judge scenes/box_spheres.dae -- ./mine --spp {samples} --seed {seed} {scene} {out}");
  app.add_option("scenes", options.scenes, "COLLADA files")->required()->check(CLI::ExistingFile);
  app.add_option("-r,--size", options.size, "width and height in pixels, default 96 72")
      ->expected(2)
      ->allow_extra_args(false)
      ->check(CLI::Range(8, 1024))
      ->type_name("W H");
  app.add_option("-m,--bounces", options.depth, "the last bounce: {depth}")
      ->check(CLI::Range(0, 100))
      ->capture_default_str();
  app.add_option("--camera", options.framing,
                 "file, fit or course, as for ./run render; default file")
      ->transform(CLI::CheckedTransformer(pt::kFramingWords).description(""))
      ->type_name("course|fit|file")
      ->default_str("file");
  const std::map<std::string, pt::LightChoice> lights{{"file", pt::LightChoice::file},
                                                      {"course", pt::LightChoice::course}};
  app.add_option("--light", options.light, pt::kCourseLightHelp)
      ->transform(CLI::CheckedTransformer(lights).description(""))
      ->type_name("file|course")
      ->default_str("file");
  app.add_option("--as", options.format,
                 "what {scene} is: plain, pbrt, mitsuba or blender, as ./run export writes it; "
                 "else COLLADA")
      ->transform(CLI::CheckedTransformer(pt::kSceneFormats).description(""))
      ->type_name("plain|pbrt|mitsuba|blender");
  app.add_option("--format", options.renderer.format, "of {out}: exr, pfm or hdr")
      ->check(CLI::IsMember({"exr", "pfm", "hdr"}))
      ->capture_default_str();
  app.add_option("--see", options.renderer.visible,
                 "another file or folder that the command may read")
      ->check(CLI::ExistingPath);
  int seconds = 600, gibibytes = 8;
  app.add_option("--seconds", seconds, "of processor time for one picture")
      ->check(CLI::Range(1, 1 << 20))
      ->capture_default_str();
  app.add_option("--memory", gibibytes, "GiB that the command may use")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  app.add_option("--isolation", options.isolation,
                 "the box: A, B or C; default: the best that works");
  app.add_option("--json", options.files.json, "also write the results to this file");
  app.add_option("--html", options.page, "also write a page with all pictures");
  app.add_option("--junit", options.files.junit, "also write JUnit's XML");
  app.add_option("-t,--threads", options.threads, "for the reference")->check(CLI::Range(1, 1024));
  app.add_option("--work", options.work)->group("");
  std::vector<std::string> own(words.begin(), split);
  std::reverse(own.begin(), own.end());
  return pt::run_program([&] {
    pt::parse(app, own);
    options.renderer.most = std::chrono::seconds(seconds);
    options.renderer.memory = static_cast<std::uint64_t>(gibibytes) << 30;
    for (std::string& path : options.renderer.visible) path = fs::canonical(path);
    return run(options, words);
  });
}
