#include "measure/scene/print.h"

#include "measure/charts/numbers.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace measure::scene {

namespace {

using Direct = pt::PathSettings::Direct;

constexpr double kUnknown = 0.05;  // of the error: a larger uncertainty is reported

std::string word(pt::Engine engine) { return std::string(name(engine)); }

// "0.94 ± 0.02 of the time" or "1.3 ± 0.1 times the time".
std::string times(const Uncertain& factor) {
  if (factor.error == 0) return fmt::format("{:.3g} times the time", factor.value);
  return factor.value < 1
             ? fmt::format("{:.2f} \u00b1 {:.2f} of the time", factor.value, factor.error)
             : fmt::format("{:.3g} \u00b1 {:.2g} times the time", factor.value, factor.error);
}

std::string times(const Option& option, const Option& best) {
  if (!option.choice) return "cannot reach this error";
  return times(times_as_long(option, best));
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
  const Uncertain& variance = cheapest_of(answer.best.tried).variance;
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

// Above everything that only says how the same picture would be cheaper.
std::string wrong_text(const Answer& answer) {
  std::string text;
  for (const std::string& sentence : answer.wrong) text += "WRONG: " + sentence + ".\n";
  return text;
}

std::string light_samples_text(const Answer& answer) {
  if (answer.delta_lights) {
    return "Light samples: all lights are points or directions: one sample is enough.\n";
  }
  const SampleModel& model = answer.survivals[0].model;
  const std::vector<Tried>& all = answer.survivals[0].tried;
  const Tried& best = cheapest_of(all);
  std::string text = fmt::format(
      "Light samples: of those measured, l = {} has the least time x variance, m {} and survival "
      "{:g}.\n"
      "  A camera sample has the relative variance {:.4g} + {:.4g} / l, and takes about\n"
      "  {:.3g} + {:.3g} l microseconds. These lines only say which other l to measure.\n"
      "      l   variance  the line    microseconds  the line    time x variance\n",
      best.light_samples, answer.survivals[0].way.bounces, answer.survivals[0].way.survival,
      model.noise.at_zero, model.noise.slope, 1e6 * model.seconds.at_zero,
      1e6 * model.seconds.slope);
  const double least = price(best).value;
  for (const Tried& tried : all) {
    text += fmt::format(
        "    {:>3}   {:<8.4g}  {:<8.4g}    {:<12.3g}  {:<8.3g}    {:.3f} \u00b1 {:.3f}\n",
        tried.light_samples, tried.variance.value, model.variance(tried.light_samples),
        1e6 * tried.seconds.value, 1e6 * model.seconds.at(tried.light_samples),
        price(tried).value / least, price(tried).error / least);
  }
  return text;
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

// A word on the part of an error that more samples would not reduce, where it can be seen.
std::string bias_text(const Checked& checked) {
  const std::optional<double> bias = seen_bias(checked.bias2);
  return bias ? fmt::format(" (bias {})", percent(*bias)) : "";
}

std::string adaptive_text(const Answer& answer) {
  if (is_unwritten(answer, "adaptive_pixel")) {
    return "Adaptive sampling: adaptive_pixel is not written yet.\n";
  }
  if (!answer.adaptive) {
    return "Adaptive sampling: so few samples are enough that there is nothing to save.\n";
  }
  const AdaptiveOption& option = *answer.adaptive;
  const Checked& checked = option.checked;
  std::string text = fmt::format(
      "Adaptive sampling: -s {} -a {} {:.3g} has an error of {}{} with {:.3g} samples per pixel;\n"
      "  at the same error {}\n"
      "  noise of single pixels    the median   99 % below   largest\n",
      option.settings.max_samples, option.settings.batch, option.settings.tolerance,
      percent(checked.error.value), bias_text(checked), checked.samples, times(option.times));
  for (const auto& [name, pixels] :
       {std::pair{"adaptive", checked.pixel_errors}, {"as many everywhere", option.uniform}}) {
    text += fmt::format("    {:<22}  {:<12} {:<12} {}\n", name, percent(pixels.median),
                        percent(pixels.most), percent(pixels.largest));
  }
  text += fmt::format(
      "  The best numbers of samples, in proportion to sigma / g, would take {:.2f} of uniform "
      "sampling's;\n  those of the rule, (sigma / g)^2, can only draw, but for the worst pixels.\n",
      option.best_possible);
  if (checked.black_pixels > 0) {
    text += fmt::format("  {} of the samples are in the {} of the pixels that see no light.\n",
                        percent(checked.black_samples), percent(checked.black_pixels));
  }
  return text;
}

// A sentence if the number of bounces is why the course's settings take so long.
std::string left_out(const Answer& answer) {
  const double bias2 = answer.course.model.bias2;
  if (bias2 < answer.error * answer.error / 4 || !answer.wrong.empty()) return "";
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
                            times(*answer.without_tree))
              : fmt::format("A tree is needed: there are {} surfaces.\n", scene.primitives.size());
  text +=
      answer.smooth > 0
          ? fmt::format("Smooth normals are turned by more than a degree in {} of the pixels.\n",
                        percent(answer.smooth))
          : "Smooth normals change no pixel.\n";
  return text;
}

}  // namespace

std::string to_text(const Answer& answer, const Options& options, const pt::Scene& scene) {
  return fmt::format("The cheapest settings for an error of {}, {} x {} pixels:\n{}\n{}{}{}{}{}{}",
                     percent(answer.error), options.width, options.height,
                     settings_text(answer, options), wrong_text(answer), light_samples_text(answer),
                     bounces_text(answer), roulette_text(answer), adaptive_text(answer),
                     rest_text(answer, scene));
}

}  // namespace measure::scene
