#include "measure/scene/print.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace measure::scene {

namespace {

using Direct = pt::PathSettings::Direct;

constexpr double kUnknown = 0.05;  // of the error: a larger uncertainty is reported

std::string word(pt::Engine engine) { return std::string(name(engine)); }

// "0.94 of the time" or "1.3 times the time".
std::string times(double factor) {
  return factor < 1 ? fmt::format("{:.2f} of the time", factor)
                    : fmt::format("{:.3g} times the time", factor);
}

std::string times(const Option& option, const Option& best) {
  if (!option.choice) return "cannot reach this error";
  return times(option.choice->seconds / best.choice->seconds);
}

std::string command(const Option& option, const Choice& choice, const Options& options) {
  std::string text = fmt::format("./run render {} -s {} -l {} -m {} --survival {:g} --engine {}",
                                 options.scene.string(), choice.samples, choice.light_samples,
                                 option.way.bounces, option.way.survival, word(options.engine));
  if (option.way.direct == Direct::hemisphere) text += " -H";
  if (options.width != 480 || options.height != 360) {
    text += fmt::format(" -r {} {}", options.width, options.height);
  }
  if (options.framing != pt::Framing::course) {
    text += options.framing == pt::Framing::fit ? " --camera fit" : " --camera file";
  }
  if (options.lambertian) text += " --lambertian";
  return text;
}

std::string settings_text(const Answer& answer, const Options& options) {
  const Choice& choice = *answer.best.choice;
  const double pixels = static_cast<double>(options.width) * options.height;
  const Checked& checked = answer.checked;
  std::string text = fmt::format(
      "  {}\n\n"
      "                error             time\n"
      "  predicted     {:<17} {:.3g} s of one processor\n"
      "  measured      {:<17} {:.3g} s   (on {} of {:.0f} pixels)\n",
      command(answer.best, choice, options), percent(choice.error), choice.seconds * pixels,
      fmt::format("{} \u00b1 {:.2g}", percent(checked.error.value), 100 * checked.error.error),
      checked.seconds * pixels, checked.pixels, pixels);
  const Uncertain& variance = answer.best.tried.back().variance;
  const double unknown = variance.error / (2 * variance.value);
  if (unknown > kUnknown) {
    text += fmt::format(
        "  A few bright samples make most of the noise: the error is not known better than {:.0f} "
        "%\n"
        "  of itself. More --seconds would tell.\n",
        100 * unknown);
  }
  return text;
}

std::string light_samples_text(const Answer& answer) {
  if (answer.delta_lights) {
    return "Light samples: all lights are points or directions: one sample is enough.\n";
  }
  const SampleModel& model = answer.survivals[0].model;
  const double best = best_light_samples(model, kMaxLightSamples);
  std::string text = fmt::format(
      "Light samples: a camera sample has the relative variance {:.4g} + {:.4g} / l, and takes\n"
      "  {:.3g} + {:.3g} l microseconds: time x variance is least at l = {:.2g}.\n"
      "      l   variance  the line    microseconds  the line\n",
      model.noise.at_zero, model.noise.slope, 1e6 * model.seconds.at_zero,
      1e6 * model.seconds.slope, best);
  for (const Tried& tried : answer.survivals[0].tried) {
    text +=
        fmt::format("    {:>3}   {:<8.4g}  {:<8.4g}    {:<12.3g}  {:.3g}\n", tried.light_samples,
                    tried.variance.value, model.variance(tried.light_samples),
                    1e6 * tried.seconds.value, 1e6 * model.seconds.at(tried.light_samples));
  }
  const auto product = [&](int l) { return model.variance(l) * model.seconds.at(l); };
  const double least = product(static_cast<int>(std::lround(best)));
  for (const int l : {1, 4, 8, 32}) {
    text += fmt::format("{}l = {}: {:.3g}", l == 1 ? "  Time x variance beside the best: " : ", ",
                        l, product(l) / least);
  }
  return text + "\n";
}

std::string bounces_text(const Answer& answer) {
  std::string text =
      "Bounces: what is missing with at most m of them, as a part of the radiance\n ";
  for (std::size_t m = 0; m < answer.bias2.size(); ++m) {
    const double bias = std::sqrt(answer.bias2[m].value);
    text += fmt::format("  m {}: {}", m, percent(bias));
    if (bias < 0.1 * answer.error) break;
    if (m % 6 == 5) text += "\n ";
  }
  text += "\n";
  for (const Option& option : answer.bounces) {
    text += fmt::format("  m {}: {}\n", option.way.bounces, times(option, answer.best));
  }
  return text;
}

std::string roulette_text(const Answer& answer) {
  if (answer.survivals.size() < 2) return "Roulette: not used, for there are too few bounces.\n";
  std::string text = "Roulette:\n";
  std::vector<const Option*> sorted;
  for (const Option& option : answer.survivals) sorted.push_back(&option);
  std::sort(sorted.begin(), sorted.end(),
            [](const Option* a, const Option* b) { return a->way.survival < b->way.survival; });
  for (const Option* option : sorted) {
    text +=
        fmt::format("  survival {:<4g} {}\n", option->way.survival, times(*option, answer.best));
  }
  return text;
}

std::string adaptive_text(const Answer& answer) {
  if (is_unwritten(answer, "adaptive_pixel")) {
    return "Adaptive sampling: adaptive_pixel is not written yet.\n";
  }
  if (!answer.adaptive) {
    return "Adaptive sampling: so few samples are enough that there is nothing to save.\n";
  }
  const AdaptiveOption& option = *answer.adaptive;
  return fmt::format(
      "Adaptive sampling: -s {} -a {} {:.3g} has an error of {} with {:.3g} samples per pixel;\n"
      "  at the same error {}\n",
      option.settings.max_samples, option.settings.batch, option.settings.tolerance,
      percent(option.checked.error.value), option.checked.samples, times(option.times));
}

// A sentence if the number of bounces is why the course's settings take so long.
std::string left_out(const Answer& answer) {
  const double bias2 = answer.course.model.bias2;
  if (bias2 < answer.error * answer.error / 4) return "";
  return fmt::format(", as 5 bounces leave out {}", percent(std::sqrt(bias2)));
}

std::string rest_text(const Answer& answer, const pt::Scene& scene) {
  std::string text =
      fmt::format("Hemisphere sampling: {}\n", is_unwritten(answer, "direct_hemisphere")
                                                   ? "direct_hemisphere is not written yet"
                                                   : times(answer.hemisphere, answer.best));
  text += fmt::format("The course's settings (-l 4 -m 5 --survival .7): {}\n",
                      times(answer.course, answer.best) + left_out(answer));
  text += answer.without_tree
              ? fmt::format("Without a tree, {} surfaces one by one: {}\n", scene.primitives.size(),
                            times(answer.without_tree->value))
              : fmt::format("A tree is needed: there are {} surfaces.\n", scene.primitives.size());
  text += answer.smooth > 0 ? fmt::format("Smooth normals turn the surface in {} of the pixels.\n",
                                          percent(answer.smooth))
                            : "Smooth normals change no pixel.\n";
  return text;
}

}  // namespace

std::string percent(double part) { return fmt::format("{:.3g} %", 100 * part); }

std::string to_text(const Answer& answer, const Options& options, const pt::Scene& scene) {
  return fmt::format("The cheapest settings for an error of {}, {} x {} pixels:\n{}\n{}{}{}{}{}",
                     percent(answer.error), options.width, options.height,
                     settings_text(answer, options), light_samples_text(answer),
                     bounces_text(answer), roulette_text(answer), adaptive_text(answer),
                     rest_text(answer, scene));
}

}  // namespace measure::scene
