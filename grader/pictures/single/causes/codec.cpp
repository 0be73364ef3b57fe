#include "grader/pictures/single/causes/suspects.h"
#include "pt/math/uncertain.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace grader::pictures {
namespace {

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

}  // namespace

void suspect_codec(Suspects& suspects) {
  const SinglePicture& picture = suspects.picture();
  const SingleQuestion& question = suspects.question();
  const pt::Image ours = mean_of(suspects.ours());
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

}  // namespace grader::pictures
