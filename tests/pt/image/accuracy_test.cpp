// The error of a picture beside two goldens: noise that is drawn, around a right picture that is known.
#include "pt/image/accuracy.h"

#include "pt/image/compare.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace pt {
namespace {

// A right picture of uneven brightness, with one pixel in ten black, and renders of it whose noise is in proportion to it.
class Renders {
 public:
  Renders() {
    std::lognormal_distribution<double> brightness(0, 1);
    for (int i = 0; i < 1000; ++i) right_.push_back(i % 10 == 0 ? 0 : brightness(random_));
    double sum = 0;
    for (const double g : right_) sum += g / static_cast<double>(right_.size());
    dark_ = dark_of(sum);
  }

  // `factor` is 1 for a right method.
  std::vector<double> render(double noise, double factor = 1) {
    std::normal_distribution<double> normal;
    std::vector<double> picture;
    for (const double g : right_) picture.push_back(g * (factor + noise * normal(random_)));
    return picture;
  }

  std::vector<double> variances(double noise) const {
    std::vector<double> all;
    for (const double g : right_) all.push_back(g * g * noise * noise);
    return all;
  }

  // The mean of (part of g)^2 / (g + d)^2.
  double square_of(double part) const {
    double sum = 0;
    for (const double g : right_) sum += std::pow(part * g / (g + dark_), 2);
    return sum / static_cast<double>(right_.size());
  }

 private:
  std::mt19937 random_{3};
  std::vector<double> right_;
  double dark_ = 0;
};

constexpr int kTries = 400;

// The noise of the goldens is half of the picture's, and no part of its error; the standard errors are true. Here all pixels
// have the same relative noise, so that the spread of the pixels is that of other random numbers.
TEST(Accuracy, is_without_the_noise_of_the_goldens_and_knows_its_error) {
  constexpr double kNoise = .06, kOfGolden = .03;
  Renders renders;
  std::vector<double> squares, biases;
  double said = 0, said_of_bias = 0;
  for (int i = 0; i < kTries; ++i) {
    const Goldens goldens(renders.render(kOfGolden), renders.render(kOfGolden));
    const Accuracy got = accuracy_of(renders.render(kNoise), renders.variances(kNoise), goldens);
    squares.push_back(got.error.value * got.error.value);
    biases.push_back(got.bias.value);
    said += std::pow(2 * got.error.value * got.error.error, 2) / kTries;
    said_of_bias += got.bias.error * got.bias.error / kTries;
    EXPECT_NEAR(got.noise->value, kNoise * std::sqrt(renders.square_of(1)), .01 * kNoise);
    EXPECT_FALSE(got.is_wrong()) << i;
  }
  const Uncertain square = mean_of(squares), bias = mean_of(biases);
  const double right = renders.square_of(kNoise);
  EXPECT_NEAR(square.value, right, 5 * square.error + 1.5 * right * kOfGolden * kOfGolden);
  EXPECT_LT(square.error, .01 * right);
  EXPECT_NEAR(bias.value, 0, 5 * bias.error);
  // A spread of 400 numbers is known within 3.5 %.
  EXPECT_NEAR(square.error * std::sqrt(kTries) / std::sqrt(said), 1, .2);
  EXPECT_NEAR(bias.error * std::sqrt(kTries) / std::sqrt(said_of_bias), 1, .2);
}

// A fifth of the light is missing, or it is hidden in noise that is five times as large: the parts are the same.
TEST(Accuracy, tells_a_bias_from_noise) {
  Renders renders;
  const Goldens goldens(renders.render(.02), renders.render(.02));
  for (const double noise : {.01, .2, 1.}) {
    const Accuracy got = accuracy_of(renders.render(noise, .8), renders.variances(noise), goldens);
    EXPECT_NEAR(got.bias.value, -.2, 5 * got.bias.error) << noise;
    EXPECT_LT(got.bias.error, .04) << noise;
    EXPECT_NEAR(got.bias2.value, renders.square_of(.2), 5 * got.bias2.error) << noise;
    EXPECT_NEAR(got.noise->value, noise * std::sqrt(renders.square_of(1)), .02 * noise);
    EXPECT_NEAR(got.error.value, std::sqrt(renders.square_of(std::hypot(.2, noise))),
                5 * got.error.error)
        << noise;
    EXPECT_TRUE(got.is_wrong()) << noise;
  }
}

TEST(Accuracy, of_a_dimmed_picture_is_the_same_and_of_a_black_one_is_none) {
  const std::vector<double> a{1, 2, 0}, b{1.5, 2, 0}, x{2, 1, .5};
  const auto dimmed = [](std::vector<double> picture) {
    for (double& each : picture) each /= 1000;
    return picture;
  };
  const Accuracy bright = accuracy_of(x, {}, {a, b});
  const Accuracy dim = accuracy_of(dimmed(x), {}, {dimmed(a), dimmed(b)});
  EXPECT_NEAR(dim.error.value, bright.error.value, 1e-12);
  EXPECT_NEAR(dim.bias.value, bright.bias.value, 1e-12);
  EXPECT_FALSE(bright.noise);
  const double dark = .04 * 6.5 / 6;
  const double square =
      (1 * .5 / std::pow(1.25 + dark, 2) + 1 / std::pow(2 + dark, 2) + .25 / (dark * dark)) / 3;
  EXPECT_NEAR(bright.error.value, std::sqrt(square), 1e-12);
  const std::vector<double> black(3);
  EXPECT_EQ(accuracy_of(black, black, {black, black}).error.value, 0);
}

}  // namespace
}  // namespace pt
