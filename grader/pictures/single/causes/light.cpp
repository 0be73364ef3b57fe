#include "grader/pictures/single/causes/suspects.h"

#include <algorithm>

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

}  // namespace

void suspect_light(Suspects& suspects) {
  const SingleQuestion& question = suspects.question();
  const Pictures& ours = suspects.ours();
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
  const auto render = [&](int from, int to) {
    pt::View view = question.view;
    view.settings.from = from;
    view.settings.to = to;
    return suspects.render(view);
  };
  Pictures direct, indirect;
  if (settings.from <= 1 && settings.to >= 1) direct = render(1, 1);
  if (settings.to >= 2) indirect = render(std::max(2, settings.from), settings.to);
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
    suspects.try_ours("the last bounce is missing", render(settings.from, settings.to - 1));
  }
}

}  // namespace grader::pictures
