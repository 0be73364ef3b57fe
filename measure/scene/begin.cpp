#include "measure/scene/begin.h"

#include "measure/renders/rows.h"
#include "measure/renders/spec.h"
#include "measure/scene/answer.h"
#include "measure/scene/converge.h"
#include "measure/scene/print.h"
#include "measure/scene/rung.h"
#include "pt/end_of_program.h"
#include "pt/error.h"
#include "pt/image/film.h"
#include "pt/image/image_io.h"
#include "pt/math/rgb.h"
#include "pt/render/darkness.h"
#include "pt/render/options.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace measure::scene {

namespace {

// The unwritten tasks among those that every picture needs.
std::vector<std::string> unwritten_and_needed(pt::Engine engine) {
  Spec spec;
  spec.engine = engine;
  spec.path.to = 1;
  std::vector<std::string> tasks = unwritten_tasks();
  std::erase_if(tasks, [needed = tasks_used(spec)](const std::string& task) {
    return !needed.contains(task);
  });
  return tasks;
}

// The measured pixels of a right picture: their luminances, and the standard errors where the file has variances.
struct Golden {
  std::vector<double> mean, error;
};

Golden golden_of(const std::string& file, const Options& options) {
  if (!pt::is_exr(file)) {
    throw pt::Error("--golden " + file + " is not an EXR: ./run render -f NAME.exr makes one");
  }
  const pt::Film film = pt::read_exr(file);
  if (film.width != options.width || film.height != options.height) {
    throw pt::Error(fmt::format("--golden {} has {} x {} pixels: give -r {} {} too", file,
                                film.width, film.height, film.width, film.height));
  }
  Golden golden;
  for (const PixelAt& at :
       spread_pixels(options.width, options.height, options.pixels, options.seed)) {
    // Files have the top row first.
    const int row = film.height - 1 - at.y;
    const pt::FilmPixel& pixel = film.pixels.at(static_cast<std::size_t>(row) * film.width + at.x);
    if (!is_finite(pixel.mean)) {
      throw pt::Error(fmt::format(
          "--golden {}: the pixel x {}, y {} from the top left is not finite", file, at.x, row));
    }
    golden.mean.push_back(luminance(pixel.mean));
    golden.error.push_back(pixel.samples > 1 ? std::sqrt(pixel.variance_y / pixel.samples) : 0);
  }
  return golden;
}

// Two independent right pictures. Of one with normal noise of a known size they are this one with another such noise e, and with
// -e: the product of their errors is 0 in the mean.
std::vector<std::vector<double>> two_goldens(const Options& options) {
  std::vector<std::vector<double>> both;
  for (const std::string& file : options.goldens) both.push_back(golden_of(file, options).mean);
  if (both.size() == 2) return both;
  const Golden one = golden_of(options.goldens[0], options);
  std::mt19937_64 random(options.seed);
  std::normal_distribution<double> noise;
  both.push_back(one.mean);
  for (std::size_t i = 0; i < one.mean.size(); ++i) {
    const double e = one.error[i] * noise(random);
    both[0][i] += e;
    both[1][i] -= e;
  }
  return both;
}

// Right pictures: of files, or by the reference in a program of its own.
Reference reference_beside(const std::string& program, const Options& options) {
  if (!options.goldens.empty()) {
    return [both = two_goldens(options), next = std::size_t{0}](
               const pt::PathSettings&, int, std::uint64_t) mutable { return both[next++ % 2]; };
  }
  if (!options.reference) return {};
  std::vector<std::string> words{program,
                                 options.scene.string(),
                                 "-r",
                                 std::to_string(options.width),
                                 std::to_string(options.height),
                                 "--pixels",
                                 std::to_string(options.pixels),
                                 "--seed",
                                 std::to_string(options.seed),
                                 "--camera"};
  words.push_back(std::ranges::find(pt::kFramingWords, options.framing, [](const auto& each) {
                    return each.second;
                  })->first);
  if (options.lambertian) words.emplace_back("--lambertian");
  const auto rung = std::make_shared<RungProgram>(words, "reference", pt::Engine::wide);
  return [rung](const pt::PathSettings& path, int samples, std::uint64_t seed) {
    RungRequest request;
    request.spec.path = path;
    request.spec.samples = samples;
    request.spec.seed = seed;
    return rung->render(request).mean;
  };
}

}  // namespace

Measuring::Measuring(pt::LoadedScene scene, const Options& options, int bounces, double share,
                     const std::string& program)
    : loaded(std::move(scene)),
      view{loaded.scene,
           frame_camera(loaded, options.framing, options.width, options.height),
           {},
           options.width,
           options.height},
      study(
          view, options.threads, options.seed, {share * options.seconds, 0, options.pixels},
          [this, share](double part) {
            if (share < 1) progress.show(share * part);
          },
          bounces,
          [this, share](double seconds) {
            if (share == 1) clock.expect(seconds);
          },
          reference_beside(program, options)) {
  if (share < 1) clock.clear();
  const std::vector<std::string> unwritten = unwritten_and_needed(options.engine);
  print_notes(loaded);
  if (unwritten.empty() && !study.is_black()) return;
  progress.clear();
  clock.clear();
  if (unwritten.empty()) {
    throw pt::Error(note_on_darkness(view, 0, 1));
  }
  throw pt::Error(fmt::format("not written yet: {}; nothing can be measured without",
                              fmt::join(unwritten, ", ")));
}

namespace {

constexpr double kSurelyReached = 1e-3;  // an error that needs no look before

// A look of a second tells of an error that is out of reach, before the minute of measuring.
void look_whether_reachable(const Options& options) {
  if (options.error >= kSurelyReached) return;
  Options quick = options;
  quick.reference = false;  // only the noise is looked at
  quick.goldens.clear();
  quick.seconds = std::min(options.seconds, 1.0);
  quick.pixels = std::min(options.pixels, 300);
  quick.out.clear();
  Measuring scene(load_scene(quick), quick, kAllBounces);
  const Tried tried =
      scene.study.try_out({pt::PathSettings::Direct::lights, kAllBounces, .7}, {1})[0];
  scene.clock.clear();
  expect_reachable(tried, options.error, static_cast<double>(options.width) * options.height);
}

void run_cheapest(const Call& call) {
  const Options& options = call.options;
  look_whether_reachable(options);
  Measuring scene(load_scene(options), options, kAllBounces, 1, call.program);
  const Answer answer = find_cheapest(scene.study, scene.view, options);
  scene.clock.clear();
  fmt::print("{}", to_text(answer, options, scene.loaded.scene));
  if (!options.out.empty()) write_charts(answer, options, scene.loaded.scene);
}

}  // namespace

Converged run_converge(const Call& call) {
  const Options& options = call.options;
  pt::LoadedScene loaded = load_scene(options);
  const std::vector<Method> methods = methods_in(loaded.scene, options.bounces, options.engine);
  expect_method(methods, options.beside);
  Measuring scene(std::move(loaded), options, options.bounces, 1, call.program);
  std::vector<MethodCurve> curves = find_curves(scene.study, scene.view, methods);
  scene.clock.clear();
  fmt::print("{}", to_text(curves, options));
  const double cpu_seconds = scene.study.cpu_seconds();
  if (!options.out.empty()) write_curves(curves, options, cpu_seconds);
  return {std::move(curves), cpu_seconds};
}

int run_call(const Call& call, const std::vector<Subject>& several) {
  try {
    if (!several.empty()) return run_several(call, several);
    if (call.command == Command::cheapest) {
      run_cheapest(call);
    } else {
      run_converge(call);
    }
  } catch (const WrongBesideReference& error) {
    fmt::print(stderr, "WRONG: {}\n", pt::sentence_of(error));
    return 1;
  }
  return 0;
}

}  // namespace measure::scene
