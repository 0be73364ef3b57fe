// What a scene needs and what methods are worth in it: the model of error and time, and what is measured.
#include "tests/proof/scenes.h"
#include "writeup/accuracy/converge.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <set>

#include <gtest/gtest.h>

namespace writeup::accuracy {
namespace {

double squares(const Line& line, const std::vector<LinePoint>& points) {
  double sum = 0;
  for (const LinePoint& point : points) {
    sum += std::pow((line.at(point.x) - point.y) / point.error, 2);
  }
  return sum;
}

TEST(Model, a_line_through_exact_points_is_found) {
  const std::vector<LinePoint> points{{1, 5, .1}, {.5, 3.5, .3}, {.25, 2.75, .2}};
  const Line line = fit_line(points);
  EXPECT_NEAR(line.at_zero, 2, 1e-12);
  EXPECT_NEAR(line.slope, 3, 1e-12);
}

TEST(Model, no_line_beside_has_smaller_squares) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> number(-1, 3);
  for (int i = 0; i < 200; ++i) {
    std::vector<LinePoint> points;
    for (const double x : {1., .5, .25, .125}) points.push_back({x, number(random), .1 * (2 + x)});
    const Line line = fit_line(points);
    EXPECT_GE(line.slope, 0);
    EXPECT_GE(line.at_zero, 0);
    for (const double a : {-.01, 0., .01}) {
      for (const double b : {-.01, 0., .01}) {
        const Line other{line.at_zero + a, line.slope + b};
        if (other.slope < 0 || other.at_zero < 0) continue;
        EXPECT_GE(squares(other, points), squares(line, points) * (1 - 1e-9)) << i;
      }
    }
  }
}

TEST(Model, light_samples_are_best_where_time_times_variance_is_least) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> number(0, 4);
  for (int i = 0; i < 100; ++i) {
    const SampleModel model{{number(random), number(random)}, {number(random), number(random)}, 0};
    const double best = best_light_samples(model, 100);
    const auto product = [&](double l) { return model.noise.at(1 / l) * model.seconds.at(l); };
    for (double l = 1; l <= 100; l *= 1.01) EXPECT_GE(product(l), product(best) * (1 - 1e-9)) << i;
  }
  EXPECT_EQ(best_light_samples({{1, 0}, {1, 1}, 0}, 100), 1) << "point lights";
  EXPECT_EQ(best_light_samples({{0, 1}, {1, 1}, 0}, 100), 100) << "no other noise";
}

TEST(Model, nothing_that_reaches_the_error_is_cheaper) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> number(.1, 2);
  for (int i = 0; i < 50; ++i) {
    const SampleModel model{
        {number(random), number(random)}, {number(random), number(random)}, .01};
    const double error = .12 + .1 * number(random);
    const std::optional<Choice> found = cheapest_choice(model, error);
    ASSERT_TRUE(found);
    EXPECT_LE(found->error, error * (1 + 1e-12));
    double least = std::numeric_limits<double>::infinity();
    for (int l = 1; l <= 100; ++l) {
      for (int s = 2; s <= 2000; ++s) {
        const double reached = std::sqrt((model.noise.at_zero + model.noise.slope / l) / s + .01);
        if (reached > error) continue;
        least = std::min(least, s * (model.seconds.at_zero + model.seconds.slope * l));
        break;
      }
    }
    EXPECT_NEAR(found->seconds, least, 1e-9 * least) << i;
  }
}

TEST(Model, a_bias_above_the_error_cannot_be_mended) {
  EXPECT_FALSE(cheapest_choice({{1, 1}, {1, 1}, .0101}, .1));
  EXPECT_TRUE(cheapest_choice({{1, 1}, {1, 1}, .0099}, .1));
  EXPECT_FALSE(cheapest_choice({{1, 1}, {1, 1}, 0}, 1e-5)) << "more samples than there are";
}

std::vector<Checked> power_law(double factor, double slope) {
  std::vector<Checked> points;
  for (const double samples : {4., 16., 64.}) {
    const double error = factor * std::pow(samples, slope);
    points.push_back({{error, .02 * error}, 1, samples, 1, 1});
  }
  return points;
}

TEST(Slope, is_that_of_a_power_law) {
  EXPECT_NEAR(slope_of(power_law(3, -.5)).value, -.5, 1e-12);
  EXPECT_NEAR(slope_of(power_law(.1, -.3)).value, -.3, 1e-12);
}

TEST(Slope, trusts_what_is_certain) {
  std::vector<Checked> points = power_law(1, -.5);
  points.push_back({{10, 10}, 1, 256, 1, 1});
  EXPECT_NEAR(slope_of(points).value, -.5, .02);
}

// The error of the slope is what the errors of the points make of it.
TEST(Slope, knows_its_error) {
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  double squares = 0, said = 0;
  constexpr int kTries = 2000;
  for (int i = 0; i < kTries; ++i) {
    std::vector<Checked> points = power_law(2, -.5);
    for (Checked& point : points) point.error.value *= std::exp(.02 * normal(random));
    const Uncertain slope = slope_of(points);
    squares += (slope.value + .5) * (slope.value + .5);
    said += slope.error * slope.error;
  }
  EXPECT_NEAR(std::sqrt(squares / said), 1, .08);
}

TEST(Pixels, one_is_in_each_block) {
  const std::vector<PixelAt> pixels = spread_pixels(103, 57, 600, 4);
  std::set<std::pair<int, int>> blocks;
  for (const PixelAt& pixel : pixels) {
    EXPECT_TRUE(0 <= pixel.x && pixel.x < 103 && 0 <= pixel.y && pixel.y < 57);
    blocks.insert({pixel.x / 3, pixel.y / 3});
  }
  EXPECT_EQ(pixels.size(), 35u * 19u);
  EXPECT_EQ(blocks.size(), pixels.size());
  EXPECT_EQ(spread_pixels(9, 7, 1000, 5).size(), 63u) << "all there are";
}

// A closed room whose walls emit 1 and reflect half of what they get: with at most m bounces, the
// radiance is 2 - 2^-m everywhere.
pt::Scene furnace() {
  pt::proof::SceneBuilder builder;
  builder.room({-1, -1, -1}, {1, 1, 1}, builder.material({.5, .5, .5}, {1, 1, 1}));
  builder.light(pt::proof::mesh_light(builder.triangles(), {1, 1, 1}));
  return builder.finish(pt::Engine::linear);
}

pt::View view_of(const pt::Scene& scene) {
  pt::Camera camera;
  camera.hfov_deg = 60;
  camera.vfov_deg = 45;
  return {scene, camera, {}, 20, 15};
}

constexpr Effort kEffort{1, 256};
constexpr double kErrors = 5;
constexpr double kOfWeights = .05;  // for the noise of g, by which errors are divided

TEST(Study, what_few_bounces_leave_out_is_found) {
  const pt::Scene scene = furnace();
  const Study study(view_of(scene), 2, 6, kEffort, {});
  for (int m = 0; m <= 10; ++m) {
    const double missing = std::pow(2, -m) / (2 + .01);
    const Uncertain& found = study.bias2()[m];
    const double slack = kErrors * found.error + kOfWeights * missing * missing;
    EXPECT_NEAR(found.value, missing * missing, slack) << m;
    if (m <= 5) {
      EXPECT_LT(found.error, missing * missing) << m;
    }
  }
}

// Hemisphere sampling sees walls of one radiance: its estimate of the direct light is cos, for uniform
// directions, whose mean is 1/2 and whose variance is 1/12. All that is missing after one bounce is 1/2.
TEST(Study, noise_and_bias_of_a_picture_are_those_of_the_closed_form) {
  const pt::Scene scene = furnace();
  Study study(view_of(scene), 2, 7, kEffort, {});
  const Way way{pt::PathSettings::Direct::hemisphere, 1, 1};
  const double weight = 1 / (2.01 * 2.01);
  for (const Tried& tried : study.try_out(way, {1, 3})) {
    const double variance = weight / 12 / tried.light_samples;
    EXPECT_NEAR(tried.variance.value, variance,
                kErrors * tried.variance.error + kOfWeights * variance);
    EXPECT_LT(tried.variance.error, .1 * variance);
    EXPECT_NEAR(tried.bias2.value, weight / 4,
                kErrors * tried.bias2.error + kOfWeights * weight / 4);
    EXPECT_NEAR(tried.rays, 1 + tried.light_samples, 1e-9) << "camera, light, and no bounce";
  }
  const Checked checked = study.check(path_of(way, 1), {4, {}, 0, 2}, 1e-5, weight / 4);
  const double error = std::sqrt(weight * (1 / 4. + 1 / 12. / 4));
  EXPECT_NEAR(checked.error.value, error, kErrors * checked.error.error + kOfWeights * error);
  EXPECT_LT(checked.error.error, .05 * error);
  EXPECT_EQ(checked.samples, 4);
}

// Measured against a picture of as many bounces, a picture has no bias.
TEST(Study, its_golden_may_have_fewer_bounces) {
  const pt::Scene scene = furnace();
  Study study(view_of(scene), 2, 9, kEffort, {}, 2);
  const auto bias2 = [&](int bounces) {
    return study.try_out({pt::PathSettings::Direct::hemisphere, bounces, 1}, {4})[0].bias2;
  };
  const Uncertain same = bias2(2), fewer = bias2(1);
  EXPECT_LT(std::abs(same.value), kErrors * same.error);
  const double missing = .25 / 1.76;
  EXPECT_NEAR(fewer.value, missing * missing,
              kErrors * fewer.error + kOfWeights * missing * missing);
}

// With four samples per pixel there is much noise. It is no light that few bounces would miss, and
// no error of another picture.
TEST(Study, its_own_noise_is_left_out) {
  const pt::Scene scene = furnace();
  Study study(view_of(scene), 2, 8, {1, 4}, {});
  for (int m = 2; m <= 4; ++m) {
    const double missing = std::pow(2, -m) / 2.01;
    EXPECT_LT(study.bias2()[m].value, 1.3 * missing * missing) << m;
  }
  const Way way{pt::PathSettings::Direct::hemisphere, kAllBounces, .7};
  for (const Tried& tried : study.try_out(way, {1, 4})) {
    EXPECT_LT(std::abs(tried.bias2.value), kErrors * tried.bias2.error) << tried.light_samples;
  }
}

}  // namespace
}  // namespace writeup::accuracy
