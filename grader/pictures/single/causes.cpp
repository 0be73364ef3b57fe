#include "grader/pictures/single/causes.h"

#include "pt/math/uncertain.h"
#include "pt/scene/scene.h"
#include "pt/tasks/camera_ray.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

#include <fmt/format.h>

namespace grader::pictures {
namespace {

using pt::kPi;

// Factors that people write, and their names.
struct Factor {
  double value;
  const char* name;
};
constexpr Factor kFactors[]{{0, "is missing"},
                            {0.5, "is half"},
                            {2, "is twice"},
                            {kPi, "is pi times"},
                            {1 / kPi, "is 1 / pi of"},
                            {2 * kPi, "is 2 pi times"},
                            {1 / (2 * kPi), "is 1 / (2 pi) of"}};

using Pictures = std::vector<pt::Image>;

// Applies change(pixel of a, pixel of b) to all pairs of pictures.
template <class Change>
Pictures changed(const Pictures& a, const Pictures& b, const Change& change) {
  Pictures all = a;
  for (std::size_t k = 0; k < a.size(); ++k) {
    for (std::size_t i = 0; i < a[k].pixels.size(); ++i) {
      pt::Rgb pixel = change(a[k].pixels[i], b[k].pixels[i]);
      for (int c = 0; c < 3; ++c) pixel[c] = std::max(pixel[c], 0.0);
      all[k].pixels[i] = pixel;
    }
  }
  return all;
}

class Suspects {
 public:
  Suspects(const SinglePicture& picture, const SingleQuestion& question, const Pictures& ours)
      : picture_(picture), question_(question), ours_(ours) {}

  // Each adds the words if the picture agrees with these of ours, once it is changed back, or with other exposures or curves.
  void try_ours(const std::string& words, const Pictures& ours) {
    add(words, judge_single(picture_, question_, ours));
  }
  void try_picture(const std::string& words, const SinglePicture& changed_back) {
    add(words, judge_single(changed_back, question_, ours_));
  }
  void try_question(const std::string& words, const SingleQuestion& other) {
    add(words, judge_single(picture_, other, ours_));
  }

  Pictures render(int from, int to) const {
    pt::View view = question_.view;
    view.settings.from = from;
    view.settings.to = to;
    return render_ours(view, question_.samples, kOwnPictures, question_.seed + 1000,
                       question_.threads);
  }

  // The nearest one, with the one that is nearly as near; empty if more are, or none is there.
  std::string named() {
    std::ranges::sort(found_);
    std::size_t near = 0;
    while (near < found_.size() && found_[near].first < found_[0].first + kClearly) ++near;
    if (near == 0 || near > 2) return "";
    return near == 1 ? found_[0].second : found_[0].second + ", or: " + found_[1].second;
  }

 private:
  // A suspect that is farther away than another by this sum of squares is none.
  static constexpr double kClearly = 20;

  void add(const std::string& words, const SingleVerdict& verdict) {
    if (verdict.outcome != SingleVerdict::Outcome::agrees) return;
    const auto known = std::ranges::find(found_, words, &std::pair<double, std::string>::second);
    if (known == found_.end()) {
      found_.emplace_back(verdict.agreement.distance, words);
    } else {
      known->first = std::min(known->first, verdict.agreement.distance);
    }
  }

  const SinglePicture& picture_;
  const SingleQuestion& question_;
  const Pictures& ours_;
  std::vector<std::pair<double, std::string>> found_;
};

SinglePicture flipped(const SinglePicture& picture, bool across, bool down) {
  SinglePicture out = picture;
  const int w = picture.linear.width, h = picture.linear.height;
  for (int y = 0; y < h; ++y) {
    for (int x = 0; x < w; ++x) {
      out.linear.at(x, y) = picture.linear.at(across ? w - 1 - x : x, down ? h - 1 - y : y);
    }
  }
  return out;
}

// Direct light, or indirect, or both, times a factor.
void try_factors(Suspects& suspects, const SingleQuestion& question, const Pictures& ours) {
  const pt::PathSettings& settings = question.view.settings;
  const auto try_part = [&](const char* name, const Pictures& part, double factor,
                            const char* words) {
    suspects.try_ours(
        fmt::format("{} {} what it should be", name, words),
        changed(ours, part, [&](pt::Rgb all, pt::Rgb some) { return all + some * (factor - 1); }));
  };
  const auto try_all = [&](const char* name, const Pictures& part) {
    for (const Factor& factor : kFactors) {
      if (factor.value == 0) {
        suspects.try_ours(
            fmt::format("{} is missing", name),
            changed(ours, part, [](pt::Rgb all, pt::Rgb some) { return all - some; }));
      } else {
        try_part(name, part, factor.value, factor.name);
      }
    }
  };
  Pictures direct, indirect;
  if (settings.from <= 1 && settings.to >= 1) direct = suspects.render(1, 1);
  if (settings.to >= 2) indirect = suspects.render(std::max(2, settings.from), settings.to);
  if (!direct.empty()) try_all("direct light", direct);
  if (!indirect.empty()) {
    try_all("indirect light", indirect);
    if (settings.survival < 1) {
      const std::string words = fmt::format("is {:.2g} of", settings.survival);
      try_part("indirect light (roulette not divided?)", indirect, settings.survival,
               words.c_str());
    }
  }
  if (!direct.empty() && !indirect.empty()) {
    try_all("reflected light",
            changed(direct, indirect, [](pt::Rgb a, pt::Rgb b) { return a + b; }));
  }
  if (settings.to >= 3) {
    suspects.try_ours("the last bounce is missing",
                      suspects.render(settings.from, settings.to - 1));
  }
}

// The factor between a picture and ours, where neither is clipped or nearly black; 0 if too few pixels say it.
double brightness(const pt::Image& theirs, const pt::Image& ours) {
  std::vector<double> ratios;
  for (std::size_t i = 0; i < theirs.pixels.size(); ++i) {
    const double a = luminance(theirs.pixels[i]), b = luminance(ours.pixels[i]);
    if (a > 0.01 && max_channel(theirs.pixels[i]) < 0.8 && b > 0.01) ratios.push_back(a / b);
  }
  if (ratios.size() < 100) return 0;
  const double about = pt::median_of(ratios);
  double sum = 0, of_ours = 0;
  for (std::size_t i = 0; i < theirs.pixels.size(); ++i) {
    const double b = max_channel(ours.pixels[i]) * about;
    if (!(b > 0.01 && b < 0.4)) continue;
    sum += luminance(theirs.pixels[i]);
    of_ours += luminance(ours.pixels[i]);
  }
  return of_ours > 0 ? sum / of_ours : 0;
}

bool is_usual(double exposure) {
  return std::ranges::any_of(kUsualExposures,
                             [&](double usual) { return std::abs(exposure / usual - 1) < 0.04; });
}

// Exposures and curves. A picture of another exposure is brighter by one factor wherever it is not clipped.
void try_codecs(Suspects& suspects, const SinglePicture& picture, const SingleQuestion& question,
                const pt::Image& ours) {
  if (!picture.eight_bits) {
    const double factor = brightness(picture.linear, ours);
    SinglePicture scaled = picture;
    for (pt::Rgb& pixel : scaled.linear.pixels) pixel /= factor;
    if (factor > 0) suspects.try_picture("everything, lamps too, has another brightness", scaled);
    return;
  }
  for (const Curve curve : {Curve::gamma, Curve::srgb}) {
    SingleQuestion other = question;
    other.exposures = {brightness(picture.decoded({true, 1, curve}), ours)};
    other.curves = {curve};
    if (other.exposures[0] > 0 && !is_usual(other.exposures[0])) {
      suspects.try_question("another exposure", other);
    }
  }
  SingleQuestion linear = question;
  linear.curves = {Curve::linear};
  suspects.try_question("no gamma: linear radiance was written as 8 bits", linear);
}

// The first surface that each pixel's centre sees, by its material; -1 where there is none.
std::vector<int> materials_seen(const pt::View& view) {
  std::vector<int> seen;
  for (int row = 0; row < view.height; ++row) {
    const double y = (view.height - 1 - row + 0.5) / view.height;
    for (int x = 0; x < view.width; ++x) {
      const pt::Ray ray = camera_ray(view.camera, (x + 0.5) / view.width, y);
      const auto hit = view.scene.closest(ray);
      seen.push_back(hit ? view.scene.material_of[hit->primitive] : -1);
    }
  }
  return seen;
}

// One material is black in all its pixels, and all others look as they should, but for its light on them.
std::string black_material(const SingleQuestion& question, const SingleVerdict& verdict) {
  const std::vector<int> seen = materials_seen(question.view);
  std::map<int, std::vector<double>> ratios;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const double ours = luminance(verdict.ours.pixels[i]);
    if (ours > 0.02) ratios[seen[i]].push_back(luminance(verdict.theirs.pixels[i]) / ours);
  }
  std::vector<int> black;
  for (const auto& [material, all] : ratios) {
    if (material < 0 || all.size() < seen.size() / 200) continue;
    std::vector<double> sorted = all;
    std::ranges::sort(sorted);
    if (sorted[sorted.size() * 9 / 10] < 0.05) {
      black.push_back(material);
    } else if (std::abs(pt::median_of(all) - 1) > 0.25) {
      return "";
    }
  }
  if (black.size() != 1 || ratios.size() < 3) return "";
  return fmt::format("all that has the material {} is black",
                     question.view.scene.materials[black[0]].name);
}

}  // namespace

std::string cause_of(const SinglePicture& picture, const SingleQuestion& question,
                     const std::vector<pt::Image>& ours, const SingleVerdict& verdict) {
  if (std::ranges::all_of(picture.linear.pixels, [](const pt::Rgb& p) { return is_black(p); })) {
    return "it is black";
  }
  Suspects suspects(picture, question, ours);
  suspects.try_picture("it is upside down", flipped(picture, false, true));
  suspects.try_picture("it is mirrored", flipped(picture, true, false));
  suspects.try_picture("it is turned by 180 degrees", flipped(picture, true, true));
  try_codecs(suspects, picture, question, mean_of(ours));
  try_factors(suspects, question, ours);
  if (const std::string named = suspects.named(); !named.empty()) return named;
  return black_material(question, verdict);
}

}  // namespace grader::pictures
