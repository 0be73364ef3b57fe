#include "grader/report/pictures.h"

#include "pt/image/compare.h"

#include <algorithm>
#include <cmath>

namespace grader::report {

namespace {

constexpr int kBlock = 8;
constexpr double kBright = 0.99;  // the quantile of brightness that sets the exposure

// From light to dark, so that it can be read in grey, too: the ends and the middle of the purples
// of ColorBrewer (Harrower and Brewer 2003).
constexpr std::array<pt::Color8, 5> kEvidence{
    {{252, 251, 253}, {203, 201, 226}, {128, 100, 180}, {84, 39, 143}, {30, 0, 60}}};

}  // namespace

double exposure_for(const pt::Image& golden) {
  std::vector<double> values;
  for (const pt::Rgb& pixel : golden.pixels) {
    if (pt::is_finite(pixel)) values.push_back(pt::luminance(pixel));
  }
  if (values.empty()) return 1;
  const auto place = static_cast<std::ptrdiff_t>(kBright * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + place, values.end());
  const double bright = values[place];
  if (!(bright > 0) || (bright > 0.1 && bright < 8)) return 1;
  return std::exp2(-std::round(std::log2(bright)));
}

pt::Image block_means(const pt::Image& image) {
  pt::Image means(image.width, image.height);
  for (int top = 0; top < image.height; top += kBlock) {
    for (int left = 0; left < image.width; left += kBlock) {
      const int bottom = std::min(top + kBlock, image.height);
      const int right = std::min(left + kBlock, image.width);
      pt::Rgb sum;
      for (int y = top; y < bottom; ++y) {
        for (int x = left; x < right; ++x) sum += image.at(x, y);
      }
      sum /= (bottom - top) * (right - left);
      for (int y = top; y < bottom; ++y) {
        for (int x = left; x < right; ++x) means.at(x, y) = sum;
      }
    }
  }
  return means;
}

pt::Picture block_difference_map(const pt::Image& render, const pt::Image& golden) {
  const pt::Image a = block_means(render), b = block_means(golden);
  const double dark = pt::compare(a, b).dark;
  pt::Picture map(a.width, a.height);
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    const double relative =
        pt::relative_difference(pt::luminance(a.pixels[i]), pt::luminance(b.pixels[i]), dark);
    map.pixels[i] = pt::difference_color(relative, kBlockScale);
  }
  return map;
}

pt::Color8 evidence_color(double evidence) { return pt::ramp(kEvidence, evidence / 2); }

pt::Picture evidence_map(const pt::Image& evidence) {
  pt::Picture map(evidence.width, evidence.height);
  for (std::size_t i = 0; i < evidence.pixels.size(); ++i) {
    map.pixels[i] = evidence_color(evidence.pixels[i].r);
  }
  return map;
}

pt::Picture count_map(const pt::SampleMap& map, int min, int max) {
  pt::Picture picture(map.width, map.height);
  for (std::size_t i = 0; i < map.counts.size(); ++i) {
    picture.pixels[i] = pt::sample_color(map.counts[i], min, max);
  }
  return picture;
}

pt::Picture count_difference_map(const pt::SampleMap& map, const pt::SampleMap& golden) {
  pt::Picture picture(map.width, map.height);
  for (std::size_t i = 0; i < map.counts.size(); ++i) {
    const double expected = golden.counts[i];
    picture.pixels[i] = pt::difference_color((map.counts[i] - expected) / expected);
  }
  return picture;
}

pt::Picture legend_bar(const std::function<pt::Color8(double)>& color) {
  constexpr int kWidth = 256;
  pt::Picture bar(kWidth, 1);
  for (int x = 0; x < kWidth; ++x) bar.at(x, 0) = color(x / (kWidth - 1.0));
  return bar;
}

}  // namespace grader::report
