#include "writeup/compose.h"
#include "writeup/figure.h"
#include "writeup/files.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace writeup {

namespace fs = std::filesystem;

namespace {

constexpr const char* kNotMeasured = "not measured";  // begins a note that is not a problem

std::string short_number(double value) {
  if (value >= 100) return fmt::format("{:.0f}", value);
  if (value < 0.1) return fmt::format("{:.1g}", value);
  return fmt::format("{:.{}f}", value, value >= 10 ? 1 : 2);
}

std::string settings_text(const measure::Spec& spec, int from, int to) {
  if (spec.path.show_normals) return fmt::format("normals, s = {}", spec.samples);
  std::string text = spec.adaptive
                         ? fmt::format("s up to {}, batches of {}, tolerance {:g}", spec.samples,
                                       spec.adaptive->batch, spec.adaptive->tolerance)
                         : fmt::format("s = {}", spec.samples);
  text += fmt::format(", l = {}", spec.path.light_samples);
  text += from == 0    ? fmt::format(", m = {}", to)
          : from == to ? fmt::format(", bounce {}", to)
                       : fmt::format(", bounces {} to {}", from, to);
  if (spec.path.survival != pt::PathSettings{}.survival) {
    text += fmt::format(", survival {:g}", spec.path.survival);
  }
  return text;
}

// "7.45 ± 0.27 %".
std::string error_text(const pt::Uncertain& error) {
  const double digits = std::ceil(1 - std::log10(100 * error.error));  // two of the standard error
  const int places = static_cast<int>(std::clamp(digits, 0.0, 3.0));
  return fmt::format("{:.{}f} \u00b1 {:.{}f} %", 100 * error.value, places, 100 * error.error,
                     places);
}

// "3.3 % too dark"; empty if that may be noise.
std::string bias_text(const pt::Uncertain& bias) {
  if (!(std::abs(bias.value) > pt::kSignificant * bias.error)) return "";
  return fmt::format("{} % too {}", short_number(100 * std::abs(bias.value)),
                     bias.value < 0 ? "dark" : "bright");
}

// "error 7.45 ± 0.27 %", or "error 51.2 ± 0.3 %: 9.5 % noise, and 50 % too dark". Pixels that stop when they look good have
// variances that are too small, so the noise of an adaptive picture is not told.
std::string accuracy_text(const pt::Accuracy& accuracy, bool adaptive) {
  std::string text = "error " + error_text(accuracy.error);
  const std::string bias = bias_text(accuracy.bias);
  if (adaptive) return text + (bias.empty() ? "" : ", " + bias);
  if (!accuracy.is_wrong()) return text;
  const std::string off = fmt::format("{} % wrong in some places",
                                      short_number(100 * pt::root_of(accuracy.bias2).value));
  return fmt::format("{}: {} % noise, and {}", text, short_number(100 * accuracy.noise->value),
                     bias.empty() ? off : bias);
}

// The settings that a label does not say already: "m = 1" of "s = 16, l = 8, m = 1" beside "lights, s = 16, l = 8".
std::string beyond(const std::string& label, const std::string& settings) {
  const std::string said = ", " + label + ",";
  std::string rest;
  for (std::size_t at = 0; at < settings.size();) {
    const std::size_t end = std::min(settings.find(", ", at), settings.size());
    const std::string part = settings.substr(at, end - at);
    if (said.find(", " + part + ",") == said.npos) rest += (rest.empty() ? "" : ", ") + part;
    at = end + 2;
  }
  return rest.empty() ? "" : rest + "; ";
}

// Draws the pictures of one figure, one after the other.
class Artist {
 public:
  Artist(const Plan& plan, const Figure& figure, const fs::path& folder)
      : plan_(plan), figure_(figure), folder_(folder), goldens_(goldens_of(plan, figure)) {}

  Drawn draw() {
    std::vector<Composed> composed;
    for (const Picture& picture : figure_.pictures) {
      composed.push_back(of(picture));
      const bool lamps = picture.spec.path.to == 0 && picture.look == Look::radiance;
      if (lamps && composed.back().complete) lamps_ = composed.back();
    }
    find_scale(composed);
    for (std::size_t i = 0; i < composed.size(); ++i) draw(figure_.pictures[i], composed[i]);
    add_table();
    return drawn_;
  }

 private:
  std::vector<Unit> units(const Picture& picture) const {
    if (picture.look == Look::predicted) return {plan_.uniform(picture)};
    return plan_.units(figure_, picture);
  }

  Composed of(const Picture& picture) const {
    if (!plan_.unavailable(picture).empty()) return {};
    Composed composed = compose(plan_.store(), units(picture));
    if (picture.crop && composed.rows > 0) composed.sum = cropped(composed.sum, *picture.crop);
    return composed;
  }

  // The goldens of the pixels that the picture shows; nothing if they are of another size.
  std::optional<pt::Goldens> goldens_for(const Picture& picture, const Rendered& sum) const {
    std::optional<pt::Goldens> goldens =
        picture.crop ? goldens_of(plan_, figure_, picture.crop) : goldens_;
    if (goldens && goldens->size() != sum.film.pixels.size()) goldens.reset();
    return goldens;
  }

  std::vector<float> values(const Picture& picture, const Rendered& sum) const {
    if (picture.look == Look::boxes) return sum.boxes;
    std::vector<float> values;
    if (picture.look == Look::error) {
      const std::optional<pt::Goldens> goldens = goldens_for(picture, sum);
      const std::vector<double> light = pt::luminances(sum.film);
      for (std::size_t i = 0; i < (goldens ? light.size() : 0); ++i) {
        const double error = std::abs(goldens->signed_error(i, light[i]));
        values.push_back(static_cast<float>(100 * std::min(error, 1.0)));
      }
      return values;
    }
    if (picture.look == Look::predicted) {
      const pt::AdaptiveSettings settings = *plan_.units(figure_, picture)[0].spec.adaptive;
      const std::vector<int> counts = predicted_samples(sum.film, settings);
      values.assign(counts.begin(), counts.end());
    } else {
      for (const pt::FilmPixel& pixel : sum.film.pixels) {
        values.push_back(static_cast<float>(pixel.samples));
      }
    }
    return values;
  }

  // All maps of a figure have the same colours.
  void find_scale(const std::vector<Composed>& composed) {
    low_ = INFINITY;
    for (std::size_t i = 0; i < composed.size(); ++i) {
      if (figure_.pictures[i].look == Look::radiance) continue;
      for (const float value : values(figure_.pictures[i], composed[i].sum)) {
        low_ = std::min(low_, value);
        high_ = std::max(high_, value);
      }
    }
  }

  void draw(const Picture& picture, const Composed& composed) {
    Shown shown;
    shown.id = picture.id;
    shown.label = label(picture);
    shown.note = problem(picture, composed);
    if (plan_.unavailable(picture).empty()) describe(picture, composed, shown);
    const bool anything = composed.rows > 0 && composed.sum.missing.empty();
    if (anything) draw_file(picture, composed, shown);
    if (!shown.note.empty() && !shown.note.starts_with(kNotMeasured)) {
      drawn_.problems.push_back(fmt::format("{}: {}", shown.label, shown.note));
    }
    drawn_.pictures.push_back(shown);
  }

  // A picture that is named after its scene gets the name of the scene that replaces it, if there is
  // one; and the number of samples is that of the render, which is smaller in a draft.
  std::string label(const Picture& picture) const {
    if (picture.label == picture.scene) return plan_.scenes().short_name(picture.scene);
    const std::string written = fmt::format("s = {}", picture.spec.samples);
    std::string label = picture.label;
    const std::size_t at = label.find(written);
    if (at != label.npos && plan_.unavailable(picture).empty()) {
      const int samples = units(picture)[0].spec.samples;
      label.replace(at, written.size(), fmt::format("s = {}", samples));
    }
    return label;
  }

  std::string problem(const Picture& picture, const Composed& composed) const {
    std::string missing_here = plan_.unavailable(picture);
    if (!missing_here.empty()) return missing_here;
    const Rendered& sum = composed.sum;
    if (!sum.failed.empty()) {
      return fmt::format("{}{}", composed.rows > 0 ? "only in part: " : "", sum.failed);
    }
    if (!sum.missing.empty()) {
      std::vector<std::string> missing = sum.missing;
      std::sort(missing.begin(), missing.end());
      missing.erase(std::unique(missing.begin(), missing.end()), missing.end());
      return fmt::format("not written yet: {}", fmt::join(missing, ", "));
    }
    const bool unknown = (picture.look == Look::predicted && !sum.has_variance) ||
                         (picture.look == Look::boxes && (sum.boxes.empty() || sum.boxes[0] < 0)) ||
                         (picture.look == Look::error && !goldens_for(picture, sum));
    return unknown ? kNotMeasured : "";
  }

  void describe(const Picture& picture, const Composed& composed, Shown& shown) {
    const measure::Spec spec = units(picture)[0].spec;
    const int from = picture.spec.path.from, to = picture.spec.path.to;
    shown.facts = fmt::format("{}{} s{}", beyond(shown.label, settings_text(spec, from, to)),
                              short_number(composed.sum.seconds),
                              spec.ranges.size() > 1 ? " for all bounces together" : "");
    measure::Spec whole = spec;
    whole.path.from = from;
    whole.path.to = to;
    shown.command = measure::render_command(whole, picture.id + ".png");
    if (!composed.complete || !composed.sum.missing.empty()) return;
    const auto enter = [&](const char* name, const std::string& value) {
      drawn_.numbers[picture.id + "." + name] = value;
    };
    enter("seconds", short_number(composed.sum.seconds));
    enter("samples", std::to_string(spec.samples));
    enter("rays", short_number(1e-6 * static_cast<double>(composed.sum.total.rays)));
    enter("mean", fmt::format("{:.4f}", mean_luminance(composed.sum.film)));
    enter("triangles", std::to_string(composed.sum.primitives));
    enter("name", plan_.scenes().short_name(picture.scene));
    if (spec.adaptive) {
      enter("batch", std::to_string(spec.adaptive->batch));
      enter("tolerance", fmt::format("{:g}", 100 * spec.adaptive->tolerance));
    }
    if (picture.look != Look::radiance) {
      std::vector<float> all = values(picture, composed.sum);
      if (all.empty()) return;
      enter_ratio(picture, all);
      double sum = 0;
      for (const float value : all) sum += value;
      enter("average", short_number(sum / static_cast<double>(all.size())));
      std::ranges::sort(all);
      enter("median", short_number(all[all.size() / 2]));
      enter("most", short_number(all.back()));
    } else if (lamps_ && lamps_->sum.film.pixels.size() == composed.sum.film.pixels.size()) {
      enter("lamp", fmt::format("{:.4f}", mean_on_lamps(composed.sum.film, lamps_->sum.film)));
    }
    const std::optional<pt::Goldens> goldens = goldens_for(picture, composed.sum);
    if (goldens && picture.look == Look::radiance) {
      enter_accuracy(picture, composed, *goldens, shown);
    }
  }

  // Enters the error and its parts, and the noise of single pixels.
  void enter_accuracy(const Picture& picture, const Composed& composed, const pt::Goldens& goldens,
                      Shown& shown) {
    const auto enter = [&](const char* name, double part) {
      drawn_.numbers[picture.id + "." + name] = short_number(100 * part);
    };
    const pt::Accuracy accuracy = writeup::accuracy(composed.sum, goldens);
    shown.facts += "; " + accuracy_text(accuracy, picture.spec.adaptive.has_value());
    enter("error", accuracy.error.value);
    enter("error_pm", accuracy.error.error);
    drawn_.numbers[picture.id + ".bias"] = fmt::format("{:.2g}", 100 * accuracy.bias.value);
    enter("bias_pm", accuracy.bias.error);
    // A smaller tolerance makes the bias of adaptive sampling smaller.
    if (!picture.crop) {
      errors_.push_back({label(picture), composed.sum.seconds, accuracy.error,
                         accuracy.is_wrong() && !picture.spec.adaptive});
    }
    const Black black = on_black(composed.sum, goldens);
    enter("black_pixels", black.pixels);
    enter("black_samples", black.samples);
    if (!accuracy.noise) return;
    if (!picture.spec.adaptive) {
      enter("noise", accuracy.noise->value);
      drawn_.numbers[picture.id + ".wrong"] = accuracy.is_wrong() ? "1" : "0";
    }
    const pt::PixelErrors pixels = pixel_noise(composed.sum, goldens);
    enter("pixel_median", pixels.median);
    enter("pixel_most", pixels.most);
    enter("pixel_largest", pixels.largest);
  }

  // Enters its samples over those of the figure's first map, in pixels where the first map is
  // neither at one batch nor at the maximum.
  void enter_ratio(const Picture& picture, const std::vector<float>& counts) {
    if (picture.look != Look::rates) return;
    if (first_rates_.empty()) first_rates_ = counts;
    if (first_rates_.size() != counts.size()) return;
    const pt::AdaptiveSettings settings = *units(picture)[0].spec.adaptive;
    double first = 0, now = 0;
    for (std::size_t i = 0; i < counts.size(); ++i) {
      const bool active =
          first_rates_[i] > 1.5 * settings.batch && first_rates_[i] < 0.9 * settings.max_samples;
      first += active ? first_rates_[i] : 0;
      now += active ? counts[i] : 0;
    }
    if (first > 0) drawn_.numbers[picture.id + ".ratio"] = fmt::format("{:.2f}", now / first);
  }

  void draw_file(const Picture& picture, const Composed& composed, Shown& shown) {
    const Rendered& sum = composed.sum;
    if (shown.note.starts_with(kNotMeasured)) return;
    shown.file = figure_.id + "." + picture.id;
    shown.width = sum.film.width;
    shown.height = sum.film.height;
    if (picture.look == Look::radiance) {
      shown.kind = "film";
      write_film(folder_ / shown.file, sum.film, picture.exposure);
      return;
    }
    shown.kind = "map";
    shown.low = fmt::format("{:g}", low_);
    shown.high = fmt::format("{:g}", high_);
    write_map(folder_ / shown.file, values(picture, sum), shown.width, low_, high_);
  }

  // Time times the square of the error is what a method costs for a given accuracy. A picture that is wrong has
  // no such cost: more time does not help.
  void add_table() {
    if (errors_.empty()) return;
    drawn_.columns = {"", "seconds", "error", "time for the same error"};
    const PictureCost* best = nullptr;
    for (const PictureCost& each : errors_) {
      if (!each.wrong && (best == nullptr || each.cost() < best->cost())) best = &each;
    }
    for (const PictureCost& each : errors_) {
      const std::string error = error_text(each.error);
      if (each.wrong || best == nullptr) {
        drawn_.rows.push_back({each.label, short_number(each.seconds), error, "never"});
        continue;
      }
      const double factor = each.cost() / best->cost();
      const double of_it = &each == best ? 0 : std::hypot(each.part(), best->part());
      drawn_.rows.push_back(
          {each.label, short_number(each.seconds), error, factor_text(factor, factor * of_it)});
      for (const Shown& shown : drawn_.pictures) {
        if (shown.label != each.label) continue;
        drawn_.numbers[shown.id + ".factor"] = short_number(factor);
        drawn_.numbers[shown.id + ".factor_pm"] = short_number(factor * of_it);
      }
    }
  }

  struct PictureCost {
    std::string label;
    double seconds;
    pt::Uncertain error;
    bool wrong;

    double cost() const { return seconds * error.value * error.value; }
    // The standard error of the cost, as a part of it.
    double part() const { return 2 * error.error / error.value; }
  };

  const Plan& plan_;
  const Figure& figure_;
  const fs::path& folder_;
  std::optional<pt::Goldens> goldens_;
  std::optional<Composed> lamps_;  // the figure's picture without a bounce
  float low_ = 0, high_ = 0;
  std::vector<float> first_rates_;
  std::vector<PictureCost> errors_;
  Drawn drawn_;
};

}  // namespace

Drawn draw_pictures(const Plan& plan, const Figure& figure, const fs::path& folder) {
  return Artist(plan, figure, folder).draw();
}

}  // namespace writeup
