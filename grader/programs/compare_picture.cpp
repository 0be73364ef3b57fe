// compare_picture PICTURE SCENE: the verdict on one picture of a scene, or, with -a, on a map of samples. The exit status is 0 if it agrees with the reference, 1 if it is wrong, 2 if
// the arguments cannot be used or nothing can be said.
#include "grader/pictures/single/rates.h"
#include "grader/pictures/single/verdict.h"
#include "grader/report/side_by_side.h"
#include "pt/command_line.h"
#include "pt/error.h"
#include "pt/file.h"
#include "pt/image/compare.h"
#include "pt/render/choose_engine.h"
#include "pt/render/options.h"
#include "pt/render/progress.h"
#include "pt/scene/load_collada.h"

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace {

namespace fs = std::filesystem;
using namespace grader;
using pictures::SingleVerdict;

// The options of this program, which those of `render` follow.
struct Words {
  std::string picture, page;
  std::vector<const char*> render{"./run compare PICTURE"};
  bool has_size = false, has_exposure = false;
};

Words split(int argc, const char* const* argv) {
  Words words;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--html" && i + 1 < argc) {
      words.page = argv[++i];
    } else if (word.starts_with("--html=")) {
      words.page = word.substr(7);
    } else if (words.picture.empty() && !word.starts_with("-")) {
      words.picture = word;
    } else {
      words.has_size = words.has_size || word.starts_with("-r") || word.starts_with("--size");
      words.has_exposure = words.has_exposure || word.starts_with("--exposure");
      words.render.push_back(argv[i]);
    }
  }
  return words;
}

const char* name(SingleVerdict::Outcome outcome) {
  switch (outcome) {
    case SingleVerdict::Outcome::agrees:
      return "agrees";
    case SingleVerdict::Outcome::wrong:
      return "wrong";
    default:
      return "cannot say";
  }
}

void write_page(const Words& words, const SingleVerdict& verdict, const std::string& text) {
  report::SideBySide pair;
  pair.verdict = name(verdict.outcome);
  pair.text = text;
  pair.left = verdict.theirs;
  pair.right = verdict.ours;
  pair.left_name = words.picture;
  pair.right_name = fmt::format("the mean of {} by the reference", pictures::kOwnPictures);
  pair.map = pt::difference_map(verdict.theirs, verdict.ours);
  pair.map_text =
      "The difference in luminance: blue where the first is darker, orange where it is brighter, "
      "full at 20 %";
  pt::write_file(words.page,
                 report::side_by_side_page("A picture and the reference", {pair},
                                           fmt::format("{}", fmt::join(words.render, " "))));
  fmt::print("{}\n", words.page);
}

int compare_picture(const Words& words, const pt::RenderOptions& options) {
  const pictures::SinglePicture picture = pictures::read_single(words.picture);
  pt::LoadedScene loaded = pt::load_collada(options.scene, options.load);
  if (options.show != pt::Show::normals) pt::require_supported(loaded, options.scene);
  pt::choose_engine(loaded.scene, pt::Engine::wide, options.max_leaf);
  const int width = words.has_size ? options.width : picture.linear.width;
  const int height = words.has_size ? options.height : picture.linear.height;
  const pt::Camera camera = pt::frame_camera(loaded, options.framing, width, height);
  add_camera_light(loaded, camera);
  pictures::SingleQuestion question{{loaded.scene, camera, path_settings(options), width, height},
                                    options.samples,
                                    options.threads};
  if (words.has_exposure) question.exposures = {options.exposure};
  question.seed = 1 + options.seed;
  const SingleVerdict verdict = pictures::judge_single(picture, question);
  std::string text = fmt::format("{}: {}\n", name(verdict.outcome), verdict.sentence);
  if (!verdict.cause.empty()) text += fmt::format("cause: {}\n", verdict.cause);
  fmt::print("{}", text);
  if (!words.page.empty() && verdict.ours.width > 0) write_page(words, verdict, text);
  return verdict.outcome == SingleVerdict::Outcome::agrees  ? 0
         : verdict.outcome == SingleVerdict::Outcome::wrong ? 1
                                                            : 2;
}

// The map of samples of an adaptive picture.
int compare_rates(const Words& words, const pt::RenderOptions& options) {
  if (!words.picture.ends_with("_rate.png") && !words.picture.ends_with(".csv")) {
    throw pt::Error(
        "the picture of -a has another number of samples in each pixel; compare its map, "
        "PICTURE_rate.png or PICTURE_rate.csv, or a picture without -a");
  }
  if (!words.page.empty())
    throw pt::Error("--html shows pictures; leave it out for a map of samples");
  const pt::SampleMap map = pictures::read_rates(words.picture, *options.adaptive);
  pictures::Recipe recipe;
  recipe.name = "rates";
  recipe.scene = options.scene;
  recipe.framing = options.framing;
  recipe.width = map.width;
  recipe.height = map.height;
  recipe.settings = path_settings(options);
  recipe.adaptive = options.adaptive;
  recipe.seed = 1 + options.seed;
  recipe.load = options.load;
  pt::Progress progress;
  const auto [outcome, verdict] = pictures::judge_rates(map, recipe, options.threads,
                                                        [&](double part) { progress.show(part); });
  progress.clear();
  using Outcome = pictures::RatesVerdict::Outcome;
  const std::string numbers =
      fmt::format("{:.2f} times the reference's samples; their logarithms correlate by {:.2f}",
                  verdict.ratio, verdict.correlation);
  if (outcome == Outcome::cannot_say) {
    fmt::print(
        "cannot say: it is like the reference's own maps, but with these settings one map says "
        "little; take a lower tolerance or more samples ({})\n",
        numbers);
    return 2;
  }
  fmt::print("{}: {}{}{}\n", outcome == Outcome::agrees ? "agrees" : "wrong", verdict.sentence,
             verdict.sentence.empty() ? "" : "; ", numbers);
  return outcome == Outcome::agrees ? 0 : 1;
}

int run(int argc, const char* const* argv) {
  const Words words = split(argc, argv);
  const pt::RenderOptions options =
      pt::parse_options(static_cast<int>(words.render.size()), words.render.data());
  return options.adaptive ? compare_rates(words, options) : compare_picture(words, options);
}

}  // namespace

int main(int argc, char** argv) {
  return pt::run_program([&] { return run(argc, argv); });
}
