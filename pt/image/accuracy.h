#pragma once

#include "pt/image/film.h"
#include "pt/math/uncertain.h"

#include <cstddef>
#include <optional>
#include <vector>

// The distance of a picture from the right picture g. Nobody has g, only renders of it that have noise of their own.
// Everything here is about luminances of the same pixels, and errors are relative: parts of the brightness, without a unit.
//
//   relMSE = mean over the pixels of (x - g)^2 / (g + d)^2        d: dark_of(mean of g)
//
// The error is the root of relMSE. It is measured with two goldens a and b, right pictures that are independent of each other
// and of x, as the mean of (x - a)(x - b) / ((a + b) / 2 + d)^2. The noise of a and that of b are in different factors, so that
// they vanish in the mean, however large they are (Rousselle, Knaus and Zwicker 2012, "Adaptive Rendering with Non-Local Means
// Filtering", have two such buffers). In the divisor their noise remains. Where q is the relative variance of one golden, and
// r = (x - g) / (g + d), r^2 becomes about r^2 + q (1.5 r^2 + 2 r). So a golden needs many more camera samples than the picture,
// not only more samples of the lights: a pixel that it sees as black by chance has far too large a weight.
//
// +- is one standard error, what other random numbers would change, by the spread of the pixels. Differences between pixels
// are in it too, so that it is rather too large.

namespace pt {

// The luminances of a film.
std::vector<double> luminances(const Film& film);

// Two independent goldens of as many pixels.
class Goldens {
 public:
  Goldens() = default;
  Goldens(std::vector<double> a, std::vector<double> b);

  std::size_t size() const { return a_.size(); }
  double mean(std::size_t i) const { return (a_[i] + b_[i]) / 2; }
  double dark() const { return dark_; }
  // (g + d) and 1 / (g + d)^2 of a pixel; a weight is 0 where all is black.
  double scale(std::size_t i) const { return mean(i) + dark_; }
  double weight(std::size_t i) const { return dark_ > 0 ? 1 / (scale(i) * scale(i)) : 0; }

  // (x - a)(y - b) / (g + d)^2 at pixel i. Its mean over the pixels is relMSE if x and y are one picture, and the square of the
  // bias if they are two independent pictures by one method.
  double product(std::size_t i, double x, double y) const {
    return weight(i) * (x - a_[i]) * (y - b_[i]);
  }
  // (x - g) / (g + d) at pixel i. No noise of a golden meets itself.
  double signed_error(std::size_t i, double x) const {
    return ((x - a_[i]) / (b_[i] + dark_) + (x - b_[i]) / (a_[i] + dark_)) / 2;
  }

 private:
  std::vector<double> a_, b_;
  double dark_ = 0;
};

// The root of a measured square. Where noise hides the square, it is the root of the standard error.
Uncertain root_of(const Uncertain& square);

// A difference of more standard errors is not noise.
inline constexpr double kSignificant = 4;

struct Accuracy {
  Uncertain error;  // root of relMSE: noise and bias together
  // The part that more samples reduce: the root of the mean of v / (g + d)^2, where v is the variance of the pixel's mean.
  // Where the number of samples depends on them, as in adaptive sampling, that variance is too small.
  std::optional<Uncertain> noise;  // none where the variances are not known
  Uncertain bias2;                 // relMSE without the noise, 0 for a right method; may be below 0
  // The mean signed error over the mean of g / (g + d): -0.5 for half the light.
  Uncertain bias;

  // More samples would not help: what is left without noise is beyond its standard error.
  bool is_wrong() const;
};

// `variances` are those of the pixels' means; empty if they are not known.
Accuracy accuracy_of(const std::vector<double>& picture, const std::vector<double>& variances,
                     const Goldens& goldens);

}  // namespace pt
