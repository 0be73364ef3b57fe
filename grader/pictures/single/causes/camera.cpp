#include "grader/pictures/single/causes/suspects.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

namespace grader::pictures {
namespace {

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

// The window of the picture over that of ours, in x and y: more than 1 if it shows more of the scene.
struct Zoom {
  double x = 1, y = 1;
};

// The luminance between the centres of four pixels; px and py count pixels from the top left corner.
double between_pixels(const pt::Image& image, double px, double py) {
  const double fx = std::clamp(px - 0.5, 0.0, image.width - 1.001);
  const double fy = std::clamp(py - 0.5, 0.0, image.height - 1.001);
  const int x = static_cast<int>(fx), y = static_cast<int>(fy);
  const double a = fx - x, b = fy - y;
  return (1 - b) * ((1 - a) * luminance(image.at(x, y)) + a * luminance(image.at(x + 1, y))) +
         b * ((1 - a) * luminance(image.at(x, y + 1)) + a * luminance(image.at(x + 1, y + 1)));
}

// A picture and the mean of ours, through a codec and back, without their finest noise.
struct Pair {
  pt::Image theirs, ours;
};

// The mean difference of theirs from ours after a zoom, over what both show; infinite if that is less than a sixth of the picture.
double difference(const Pair& pair, Zoom zoom, int step) {
  const pt::Image& theirs = pair.theirs;
  double sum = 0;
  int seen = 0, all = 0;
  for (int y = step / 2; y < theirs.height; y += step) {
    for (int x = step / 2; x < theirs.width; x += step) {
      ++all;
      const double px = theirs.width * 0.5 + (x + 0.5 - theirs.width * 0.5) * zoom.x;
      const double py = theirs.height * 0.5 + (y + 0.5 - theirs.height * 0.5) * zoom.y;
      if (px < 0 || py < 0 || px > theirs.width || py > theirs.height) continue;
      ++seen;
      sum +=
          std::min(1.0, std::abs(luminance(theirs.at(x, y)) - between_pixels(pair.ours, px, py)));
    }
  }
  return seen * 6 >= all ? sum / seen : pt::kInfinity;
}

// The zoom with the least difference, and this over the difference without any.
struct Fit {
  Zoom zoom;
  double part = 1;
};

Fit fitted(const Pair& pair) {
  const double pixels = static_cast<double>(pair.theirs.width) * pair.theirs.height;
  const int step = std::max(1, static_cast<int>(std::sqrt(pixels / 4000)));
  constexpr int kSteps = 40;
  constexpr double kMost = 2.5;
  Zoom best;
  double least = difference(pair, best, step);
  const auto consider = [&](Zoom zoom, int at_step) {
    if (const double here = difference(pair, zoom, at_step); here < least) {
      least = here;
      best = zoom;
    }
  };
  for (int i = -kSteps; i <= kSteps; ++i) {
    for (int k = -kSteps; k <= kSteps; ++k) {
      consider({std::pow(kMost, 1.0 * i / kSteps), std::pow(kMost, 1.0 * k / kSteps)}, step);
    }
  }
  least = difference(pair, best, 1);
  double by = std::pow(kMost, 0.5 / kSteps) - 1;
  while (by > 2e-4) {
    const Zoom centre = best;
    for (const double x : {-by, 0.0, by}) {
      for (const double y : {-by, 0.0, by}) consider({centre.x * (1 + x), centre.y * (1 + y)}, 1);
    }
    by /= 2;
  }
  return {best, least / difference(pair, {}, 1)};
}

// The best fit by any usual codec: the codec that fits a picture of another window best need not be its own.
Fit best_fit(const Suspects& suspects) {
  const pt::Image mean = mean_of(suspects.ours());
  Fit best;
  for (const Codec& codec : codecs_of(suspects.picture(), suspects.question())) {
    if (codec.floor) continue;
    const Fit fit =
        fitted({softened(suspects.picture().decoded(codec)), softened(codec.through(mean))});
    if (fit.part < best.part) best = fit;
  }
  return best;
}

double half_window(double degrees) { return std::tan(degrees * std::numbers::pi / 360); }
double degrees_of(double half_window) { return std::atan(half_window) * 360 / std::numbers::pi; }

}  // namespace

void suspect_flips(Suspects& suspects) {
  const SinglePicture& picture = suspects.picture();
  suspects.try_picture("it is upside down", flipped(picture, false, true));
  suspects.try_picture("it is mirrored", flipped(picture, true, false));
  suspects.try_picture("it is turned by 180 degrees", flipped(picture, true, true));
}

void suspect_field_of_view(Suspects& suspects) {
  const pt::View& view = suspects.question().view;
  const auto [zoom, part] = best_fit(suspects);
  if (part > 0.9) return;
  pt::View other = view;
  other.camera.hfov_deg = degrees_of(half_window(view.camera.hfov_deg) * zoom.x);
  other.camera.vfov_deg = degrees_of(half_window(view.camera.vfov_deg) * zoom.y);
  suspects.try_ours(
      fmt::format("its field of view is about {:.1f} x {:.1f} degrees, and not {:.1f} x {:.1f}",
                  other.camera.hfov_deg, other.camera.vfov_deg, view.camera.hfov_deg,
                  view.camera.vfov_deg),
      suspects.render(other));
}

}  // namespace grader::pictures
