// The settings that a scene needs and the worth of methods for it: the model of error and time, and
// its measurements.
#include "measure/charts/gnuplot.h"
#include "measure/scene/adaptive.h"
#include "measure/scene/converge.h"
#include "measure/scene/ladder.h"
#include "measure/scene/ladder_turns.h"
#include "measure/scene/print.h"
#include "pt/error.h"
#include "pt/file.h"
#include "pt/render/render_apart.h"
#include "pt/render/render_rows.h"
#include "tests/fixtures/temporary_folder.h"
#include "tests/proof/scenes.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numeric>
#include <random>
#include <regex>
#include <set>

#include <gtest/gtest.h>

namespace measure::scene {
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
    for (int k = 0; k <= 1000; ++k) {
      EXPECT_GE(product(std::pow(100, k / 1000.0)), product(best) * (1 - 1e-9)) << i;
    }
  }
  EXPECT_EQ(best_light_samples({{1, 0}, {1, 1}, 0}, 100), 1) << "point lights";
  EXPECT_EQ(best_light_samples({{0, 1}, {1, 1}, 0}, 100), 100) << "no other noise";
}

Tried tried_with(int l, double variance, double seconds) {
  return {l, {variance, .01 * variance}, {seconds, .01 * seconds}, {}, 1};
}

// As measured in a box with two spheres: one light sample takes less than the line through the
// others says, so that the line's best number is the dearest of those that were measured.
TEST(Cheapest, is_measured_where_the_times_are_not_on_a_line) {
  const std::vector<Tried> tried{tried_with(1, .144, 2.26e-6), tried_with(2, .1176, 2.89e-6),
                                 tried_with(4, .1038, 3.12e-6), tried_with(8, .097, 4.7e-6)};
  EXPECT_NE(cheapest_of(tried).light_samples, 2);
  EXPECT_EQ(cheapest_of(tried).light_samples, 4);
  EXPECT_EQ(cheapest_choice(tried, 0, .02)->light_samples, 4);
}

// Nothing that was measured reaches the error in less time, however far the times and variances are
// from the model.
TEST(Cheapest, is_never_dearer_than_what_was_measured) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> number(.1, 2);
  for (int i = 0; i < 200; ++i) {
    std::vector<Option> others;
    const double error = .12 + .1 * number(random);
    for (int way = 0; way < 3; ++way) {
      std::vector<Tried> tried;
      for (const int l : {1, 2, 4, 8})
        tried.push_back(tried_with(l, number(random), number(random)));
      others.push_back(option_of({}, tried, .004 * way, error));
    }
    const Option best = cheapest_of(others, {});
    ASSERT_TRUE(best.choice);
    EXPECT_LE(best.choice->error, error * (1 + 1e-12));
    for (const Option& other : others) {
      for (const Tried& tried : other.tried) {
        const double left = error * error - other.model.bias2;
        const double samples = std::max(2., std::ceil(tried.variance.value / left));
        EXPECT_LE(best.choice->seconds, samples * tried.seconds.value * (1 + 1e-12)) << i;
      }
    }
  }
}

// The model only says what is worth a measurement: between the numbers, or beyond them.
TEST(Cheapest, is_looked_for_where_the_model_promises_it) {
  const auto at = [](double l) { return tried_with(int(l), 1 + 9 / l, 9 + l); };
  const std::vector<Tried> ends{at(1), at(32)};
  EXPECT_EQ(worth_measuring(ends, model_of(ends, 0), .03), 9);
  const std::vector<Tried> found{at(1), at(9), at(32)};
  EXPECT_FALSE(worth_measuring(found, model_of(found, 0), .03));
  const std::vector<Tried> low{at(1), at(2)};
  EXPECT_GT(worth_measuring(low, model_of(low, 0), .03).value(), 4);
}

// The ladder decides by the same rule.
TEST(Cheapest, is_the_ladders_too) {
  const auto lights = [](double two, double four, double spread) {
    return with_cheapest_lights({}, {{LightIdea::none, 1, 1},
                                     {LightIdea::more_samples, 2, two},
                                     {LightIdea::more_samples, 4, four},
                                     {LightIdea::spread, 3, spread}});
  };
  EXPECT_FALSE(lights(1.05, 1.1, 1.2).more_pay);
  EXPECT_EQ(lights(1.05, 1.1, 1.2).lights, LightIdea::none);
  EXPECT_EQ(lights(.97, .96, 1.2).light_samples, 4);
  EXPECT_EQ(lights(.97, .96, 1.2).lights, LightIdea::more_samples);
  // Samples that are spread pay, but more of the plain ones do not: their rung is left out.
  const std::vector<Rung> rungs = rungs_of(lights(1.05, 1.1, .8));
  const auto more = std::ranges::find(rungs, "2 light samples", &Rung::idea);
  ASSERT_NE(more, rungs.end());
  EXPECT_FALSE(more->kept);
  EXPECT_EQ(std::ranges::find(rungs, "rectangles by solid angle", &Rung::idea)->light_samples, 1);
}

TEST(Model, a_bias_above_the_error_cannot_be_mended) {
  const std::vector<Tried> tried{tried_with(1, 2, 1), tried_with(2, 1.5, 2)};
  EXPECT_FALSE(cheapest_choice(tried, .0101, .1));
  EXPECT_TRUE(cheapest_choice(tried, .0099, .1));
  EXPECT_FALSE(cheapest_choice(tried, 0, 1e-5)) << "more samples than there are";
}

// Two samples of variance 1 per millionth of an error: a trillion samples of a microsecond.
TEST(Model, an_error_out_of_reach_is_told_with_what_it_would_take) {
  std::string said;
  try {
    expect_reachable(tried_with(1, 1, 1e-6), 1e-6, 1000);
  } catch (const pt::Error& error) {
    said = error.what();
  }
  EXPECT_EQ(
      said,
      "an error of 0.0001 % would take 1e+12 samples per pixel, 32 years of one processor; the "
      "most that can be rendered is 16777216, for an error of about 0.024 %: ask for a larger "
      "error with --error");
  EXPECT_NO_THROW(expect_reachable(tried_with(1, 1, 1e-9), 1e-3, 1000));
}

// A picture in which few paths find light: a million samples of a microsecond.
TEST(Model, an_error_that_takes_too_long_to_check_is_told_with_what_it_would_take) {
  std::string said;
  try {
    expect_reachable(tried_with(1, 1, 1e-6), 1e-3, 1000);
  } catch (const pt::Error& error) {
    said = error.what();
  }
  EXPECT_EQ(said,
            "an error of 0.1 % would take 1e+06 samples per pixel, 17 minutes of one processor; "
            "the check on 300 pixels alone would take 10 minutes of one processor: ask for a "
            "larger error with --error");
}

// Uneven noise: pixels of all brightnesses, whose samples deviate by a tenth or by ten times that.
std::vector<Study::PixelNoise> uneven_noise() {
  std::mt19937 random(8);
  std::lognormal_distribution<double> deviation(0, 1), brightness(0, 2);
  std::vector<Study::PixelNoise> noise;
  for (int i = 0; i < 1000; ++i) {
    const double g = brightness(random), v = std::pow(g * deviation(random), 2);
    noise.push_back({v / (g * g), v / (g * g)});
  }
  return noise;
}

double mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.) / static_cast<double>(values.size());
}

// With n in proportion to v / g^2, the rule of adaptive_pixel, all pixels have the same relative
// error e, and take the mean of v / g^2 / e^2 samples; so do as many everywhere. By this error the
// rule can only draw, however uneven the noise is. It wins the worst pixels.
TEST(Adaptive, draws_with_uniform_sampling_and_wins_the_worst_pixels) {
  const std::vector<Study::PixelNoise> noise = uneven_noise();
  std::vector<double> by_rule, best;
  for (const Study::PixelNoise& pixel : noise) {
    by_rule.push_back(100 * pixel.over_square);
    best.push_back(100 * std::sqrt(pixel.relative));
  }
  const auto product = [&](const std::vector<double>& samples) {
    return relmse_with(noise, samples) * mean(samples);
  };
  const double uniform = product(std::vector<double>(noise.size(), 50));
  EXPECT_NEAR(product(by_rule) / uniform, 1, 1e-9);
  EXPECT_LT(best_possible(noise), .5);
  EXPECT_NEAR(product(best) / uniform, best_possible(noise), 1e-9);
  std::vector<double> even, of_rule;
  for (std::size_t i = 0; i < noise.size(); ++i) {
    even.push_back(noise[i].relative / mean(by_rule));
    of_rule.push_back(noise[i].relative / by_rule[i]);
  }
  EXPECT_LT(pt::pixel_errors(of_rule).most, .5 * pt::pixel_errors(even).most);
}

TEST(Adaptive, takes_whole_batches_by_the_rule_of_the_contract) {
  // (1.96 / .1)^2 = 384.2 samples for a variance of the squared mean.
  EXPECT_EQ(adaptive_samples({{1, 1}, {1, .25}, {1, 0}, {1, 9}}, {1024, 32, .1}),
            (std::vector<double>{416, 128, 32, 1024}));
}

Options cheapest(std::vector<const char*> words) {
  words.insert(words.begin(), {"cheapest", "a.dae"});
  return parse_cheapest(static_cast<int>(words.size()), words.data());
}

TEST(Words, say_the_error_as_a_part_or_in_percent) {
  for (const char* error : {"3%", "3 %", ".03", "0.03"}) {
    EXPECT_NEAR(cheapest({"--error", error}).error, .03, 1e-15) << error;
  }
  EXPECT_EQ(cheapest({"--error", "100%"}).error, 1);
  EXPECT_EQ(cheapest({}).error, .02);
}

TEST(Words, say_the_width_before_the_height) {
  EXPECT_EQ(cheapest({"-r", "64", "48"}).width, 64);
  EXPECT_EQ(cheapest({"-r", "64", "48"}).height, 48);
}

// The command, option by option, that renders with the best settings.
TEST(Words, of_the_answer_are_the_command_that_renders) {
  const pt::Scene scene;
  Answer answer;
  answer.delta_lights = true;
  answer.best.way = {pt::PathSettings::Direct::hemisphere, 6, .5};
  answer.best.tried = {{3, {1, .001}, {}, {}, 1}};
  answer.best.choice = Choice{3, 50, .02, 1e-6, .02};
  Options options = cheapest({"-r", "64", "48", "--camera", "fit", "--lambertian"});
  EXPECT_NE(to_text(answer, options, scene)
                .find("./run render a.dae -s 50 -l 3 -m 6 --survival 0.5 --engine wide -H -r 64 48 "
                      "--camera fit --lambertian\n"),
            std::string::npos);
  answer.best.way.direct = pt::PathSettings::Direct::lights;
  options = cheapest({"--camera", "file", "--engine", "task"});
  EXPECT_NE(to_text(answer, options, scene)
                .find("./run render a.dae -s 50 -l 3 -m 6 --survival 0.5 --engine task "
                      "--camera file\n"),
            std::string::npos);
  EXPECT_NE(to_text(answer, cheapest({}), scene).find("--engine wide\n"), std::string::npos);
}

// 64 x 48 pixels, with a microsecond and two rays per pixel.
TEST(Tables, have_the_seconds_and_rays_of_a_picture) {
  const TemporaryFolder folder;
  Options options = cheapest({"-r", "64", "48"});
  options.out = folder.path();
  MethodCurve curve;
  curve.method.title = "lights, l = 4";
  curve.method.light_samples = 4;
  curve.points = {{{.5, .01}, 1e-6, 16, 2, 1, {}, {}}};
  curve.error2_second = curve.error2_ray = {1, .1};
  write_curves({curve}, options, 1);
  EXPECT_EQ(pt::read_file(options.out / "converge.csv", 1 << 20),
            "method,light_samples,samples,seconds,rays,error,error_of_it\n"
            "\"lights, l = 4\",4,16,0.003072,6144,0.5,0.01\n");
}

TEST(Tables, have_microseconds_of_a_sample_and_the_root_of_a_bias) {
  const TemporaryFolder folder;
  const pt::Scene scene;
  Options options = cheapest({});
  options.out = folder.path();
  Answer answer;
  answer.error = .02;
  answer.bias2 = {{.25, .01}, {.04, .01}};
  answer.survivals.resize(1);
  answer.survivals[0].tried = {{2, {.5, .01}, {3e-6, 1e-7}, {}, 7}};
  answer.survivals[0].choice = Choice{2, 16, .02, 1e-6, .0064};
  answer.best = answer.survivals[0];
  write_charts(answer, options, scene);
  EXPECT_EQ(pt::read_file(options.out / "bounces.csv", 1 << 20),
            "most_bounces,bias\n0,0.5\n1,0.2\n");
  EXPECT_EQ(pt::read_file(options.out / "noise.csv", 1 << 20),
            "light_samples,variance,variance_error,microseconds,microseconds_error,rays\n"
            "2,0.5,0.01,3,0.1,7\n");
  // The course's settings do not reach the error, and have no line.
  EXPECT_EQ(std::filesystem::exists(options.out / "options.svg"),
            std::filesystem::exists("/usr/bin/gnuplot"));
}

std::vector<Checked> power_law(double factor, double slope) {
  std::vector<Checked> points;
  for (const double samples : {4., 16., 64.}) {
    const double error = factor * std::pow(samples, slope);
    points.push_back({{error, .02 * error}, 1, samples, 1, 1, {}, {}});
  }
  return points;
}

TEST(Slope, is_that_of_a_power_law) {
  EXPECT_NEAR(slope_of(power_law(3, -.5)).value, -.5, 1e-12);
  EXPECT_NEAR(slope_of(power_law(.1, -.3)).value, -.3, 1e-12);
}

TEST(Slope, trusts_what_is_certain) {
  std::vector<Checked> points = power_law(1, -.5);
  points.push_back({{10, 10}, 1, 256, 1, 1, {}, {}});
  EXPECT_NEAR(slope_of(points).value, -.5, .02);
}

// The error of the slope follows from the errors of the points.
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

// The curve of a method with this error and this time per sample.
MethodCurve curve_of(double error, double seconds) {
  MethodCurve curve;
  curve.error2_second = {error * error * seconds, .01 * error * error * seconds};
  curve.error2_ray = {error * error, .01 * error * error};
  return curve;
}

// Half the error per sample in equal time: a quarter of the time, or half the error at equal time.
TEST(Factors, are_of_time_at_equal_error_and_of_error_at_equal_time) {
  const Factors f = factors(curve_of(.5, 3), curve_of(1, 3));
  EXPECT_NEAR(f.time.value, .25, 1e-12);
  EXPECT_NEAR(f.error.value, .5, 1e-12);
  EXPECT_NEAR(f.rays.value, .25, 1e-12);
  EXPECT_NEAR(f.time.error, .25 * .01 * std::sqrt(2), 1e-6);
  const Factors back = factors(curve_of(1, 3), curve_of(.5, 3));
  EXPECT_NEAR(f.time.value * back.time.value, 1, 1e-12);
  const std::vector<MethodCurve> curves{curve_of(1, 3), curve_of(.5, 3), curve_of(.5, 4)};
  EXPECT_EQ(&fastest(curves), &curves[1]);
}

// Half the error of the first in equal time: four times its efficiency, at every time.
TEST(Factors, efficiency_is_flat_where_the_power_law_holds) {
  MethodCurve first = curve_of(1, 1), half = curve_of(.5, 1);
  first.method.id = "first";
  for (MethodCurve* curve : {&first, &half}) {
    for (const double samples : {4., 64.}) {
      const double error = std::sqrt(curve->error2_second.value / samples);
      curve->points.push_back({{error, .01 * error}, samples, samples, samples, 1, {}, {}});
    }
  }
  for (const Efficiency& at : efficiencies(half, first)) {
    EXPECT_NEAR(at.value.value, 4, 1e-12);
    EXPECT_NEAR(at.value.error, 4 * std::hypot(.01, .02), 1e-9);
  }
  half.points.back().error.value *= 2;
  EXPECT_NEAR(efficiencies(half, first).back().value.value, 1, 1e-12) << "a bias bends it";
}

// One line from 1 s to 100 s, a steeper one that crosses it at 10 s and goes on to 1000 s, and a method that
// fails. At 4 s and at 40 s, where nothing was measured, the front is on the lower of the two lines.
TEST(Factors, the_front_is_on_the_lowest_line) {
  const auto line = [](double from, double to, double slope) {
    MethodCurve curve;
    for (const double seconds : {from, to}) {
      curve.points.push_back(
          {{std::pow(seconds / 10, slope), 0}, seconds, seconds, seconds, 1, {}, {}});
    }
    return curve;
  };
  MethodCurve fails = line(1, 1000, 0);
  for (Checked& point : fails.points) point.error.value = 1e-9;
  fails.fails = true;
  const std::vector<FrontPlace> front = front_of({line(1, 100, -.5), line(2, 1000, -1), fails});
  EXPECT_NEAR(front.front().error, std::sqrt(10), 1e-12);
  EXPECT_NEAR(front.back().error, .01, 1e-12);
  for (const double seconds : {4., 40.}) {
    const auto after = std::ranges::lower_bound(front, seconds, {}, &FrontPlace::seconds);
    const auto before = std::prev(after);
    const double part =
        std::log(seconds / before->seconds) / std::log(after->seconds / before->seconds);
    EXPECT_NEAR(before->error * std::pow(after->error / before->error, part),
                std::pow(seconds / 10, seconds < 10 ? -.5 : -1), 1e-9);
  }
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

// A closed room whose walls emit 1 and reflect half of the light: with at most m bounces, the
// radiance is 2 - 2^-m everywhere.
pt::Scene furnace(double radiance = 1) {
  pt::proof::SceneBuilder builder;
  const pt::Rgb lamp = pt::gray(radiance);
  builder.room({-1, -1, -1}, {1, 1, 1}, builder.material({.5, .5, .5}, lamp));
  builder.light(pt::proof::mesh_light(builder.triangles(), lamp));
  return builder.finish(pt::Engine::linear);
}

pt::View view_of(const pt::Scene& scene) {
  pt::Camera camera;
  camera.hfov_deg = 60;
  camera.vfov_deg = 45;
  return {scene, camera, {}, 20, 15};
}

TEST(Factors, seven_unlike_methods_are_drawn) {
  const pt::Scene scene = furnace();
  std::vector<MethodCurve> curves;
  for (const Method& method : methods_in(scene, 5, pt::Engine::wide)) {
    curves.push_back(curve_of(1, 1. + method.light_samples));
    curves.back().method = method;
  }
  std::vector<std::string> ids;
  std::set<std::string> colors;
  for (const DrawnMethod& drawn : seven_of(curves)) {
    ids.push_back(drawn.curve->method.id);
    colors.insert(drawn.color);
  }
  EXPECT_EQ(colors.size(), ids.size());
  EXPECT_EQ(ids, (std::vector<std::string>{"l1", "l2", "l32", "h1", "p30", "adaptive", "task"}));
}

// The heights of the names in gnuplot's commands.
std::vector<double> heights(const std::vector<NamedEnd>& ends) {
  const std::string text = names_beside(ends, .01, 100);
  const std::regex form("first ([0-9.e+-]+) left");
  std::vector<double> found;
  for (std::sregex_iterator it(text.begin(), text.end(), form), last; it != last; ++it) {
    found.push_back(std::stod((*it)[1]));
  }
  return found;
}

TEST(Charts, names_beside_lines_keep_apart_and_inside) {
  EXPECT_NEAR(heights({{"alone", "", 3}})[0], 3, 1e-9);
  const std::vector<double> all = heights({{"a", "", 99},
                                           {"b", "", 100},
                                           {"c", "", 200},
                                           {"d", "", .01},
                                           {"e", "", .01},
                                           {"f", "", 1}});
  ASSERT_EQ(all.size(), 6u);
  EXPECT_TRUE(std::ranges::is_sorted(all));
  EXPECT_GE(all[0], .0099);
  EXPECT_LE(all[5], 101);
  for (std::size_t i = 1; i < all.size(); ++i) {
    EXPECT_GT(std::log10(all[i] / all[i - 1]), .04 * std::log10(100 / .01)) << i;
  }
}

constexpr StudyLimits kLimits{1, 256};
constexpr double kErrors = 5;
constexpr double kOfWeights = .05;  // for the noise of g, the divisor of errors

TEST(Study, what_few_bounces_leave_out_is_found) {
  const pt::Scene scene = furnace();
  const Study study(view_of(scene), 2, 6, kLimits, {});
  for (int m = 0; m <= 10; ++m) {
    const double missing = std::pow(2, -m) / 2.08;
    const Uncertain& found = study.bias2()[m];
    const double slack = kErrors * found.error + kOfWeights * missing * missing;
    EXPECT_NEAR(found.value, missing * missing, slack) << m;
    if (m <= 5) {
      EXPECT_LT(found.error, missing * missing) << m;
    }
  }
}

// Of many pixels the fewest samples take longer than a millisecond, and the first of them tell how long.
TEST(Study, announces_before_anything_is_shown_how_long_it_takes) {
  const pt::Scene scene = furnace();
  const pt::View view{scene, view_of(scene).camera, {}, 100, 100};
  const auto announced = [&](double seconds, int pixels) {
    std::vector<double> said;
    const Study study(
        view, 1, 6, {seconds, 0, pixels}, [&](double) { EXPECT_EQ(said.size(), 1u); }, kAllBounces,
        [&](double all) { said.push_back(all); });
    return said.at(0);
  };
  EXPECT_GE(announced(.2, 100), .2);
  double few = announced(.001, 100);
  for (int i = 0; i < 4; ++i) few = std::min(few, announced(.001, 100));
  EXPECT_GT(announced(.001, 10000), 3 * few);
}

// Hemisphere sampling sees walls of one radiance. For uniform directions its estimate of direct
// light is cos, with mean 1/2 and variance 1/12. All the light that one bounce misses is 1/2.
TEST(Study, noise_and_bias_of_a_picture_are_those_of_the_closed_form) {
  const pt::Scene scene = furnace();
  Study study(view_of(scene), 2, 7, kLimits, {});
  const Way way{pt::PathSettings::Direct::hemisphere, 1, 1};
  const double weight = 1 / (2.08 * 2.08);  // 4 % of the mean, 2, more than 2
  for (const Tried& tried : study.try_out(way, {1, 3})) {
    const double variance = weight / 12 / tried.light_samples;
    EXPECT_NEAR(tried.variance.value, variance,
                kErrors * tried.variance.error + kOfWeights * variance);
    EXPECT_LT(tried.variance.error, .1 * variance);
    EXPECT_NEAR(tried.bias2.value, weight / 4,
                kErrors * tried.bias2.error + kOfWeights * weight / 4);
    EXPECT_NEAR(tried.rays, 1 + tried.light_samples, 1e-9) << "camera, light, and no bounce";
  }
  const Checked checked =
      study.check(path_of(way, 1), {4, {}, 0, 2}, 1e-5, Uncertain{weight / 4, 0});
  const double error = std::sqrt(weight * (1 / 4. + 1 / 12. / 4));
  EXPECT_NEAR(checked.error.value, error, kErrors * checked.error.error + kOfWeights * error);
  EXPECT_LT(checked.error.error, .05 * error);
  EXPECT_EQ(checked.samples, 4);
}

// A picture has no bias relative to a picture with as many bounces.
TEST(Study, its_golden_may_have_fewer_bounces) {
  const pt::Scene scene = furnace();
  Study study(view_of(scene), 2, 9, kLimits, {}, 2);
  const auto bias2 = [&](int bounces) {
    return study.try_out({pt::PathSettings::Direct::hemisphere, bounces, 1}, {4})[0].bias2;
  };
  const Uncertain same = bias2(2), fewer = bias2(1);
  EXPECT_LT(std::abs(same.value), kErrors * same.error);
  const double missing = .25 / (1.75 * 1.04);
  EXPECT_NEAR(fewer.value, missing * missing,
              kErrors * fewer.error + kOfWeights * missing * missing);
}

// Lamps a thousandth as bright: the same numbers.
TEST(Study, a_dimmed_scene_needs_the_same) {
  const Way way{pt::PathSettings::Direct::lights, 3, .7};
  std::vector<Tried> tried;
  std::vector<double> bias2, error;
  for (const double radiance : {1., .001}) {
    const pt::Scene scene = furnace(radiance);
    Study study(view_of(scene), 2, 6, {1, 64}, {});
    tried.push_back(study.try_out(way, {1})[0]);
    bias2.push_back(study.bias2_at(3));
    error.push_back(study.check(path_of(way, 1), {4, {}, 0, 2}, 1e-5, {}).error.value);
  }
  EXPECT_NEAR(tried[1].variance.value / tried[0].variance.value, 1, 1e-9);
  EXPECT_NEAR(bias2[1] / bias2[0], 1, 1e-9);
  EXPECT_NEAR(error[1] / error[0], 1, 1e-9);
}

// A room with a point light, which no direction of the hemisphere meets: more samples help light sampling
// alone.
TEST(Study, a_method_that_never_finds_the_light_fails) {
  pt::proof::SceneBuilder builder;
  builder.room({-1, -1, -1}, {1, 1, 1}, builder.material({.5, .5, .5}));
  builder.light(pt::PointLight{{.2, .5, .3}, {1, 1, 1}});
  const pt::Scene scene = builder.finish(pt::Engine::linear);
  Study study(view_of(scene), 2, 3, {.2, 64}, {}, 2);
  std::vector<Method> methods = methods_in(scene, 2, pt::Engine::linear);
  std::erase_if(methods, [](const Method& each) { return each.id != "l1" && each.id != "h1"; });
  const std::vector<MethodCurve> curves = find_curves(study, view_of(scene), methods);
  ASSERT_EQ(curves.size(), 2u);
  EXPECT_FALSE(curves[0].fails);
  EXPECT_TRUE(curves[1].fails);
  EXPECT_GT(curves[1].points.back().error.value, .8);
  EXPECT_EQ(&fastest(curves), curves.data());
  for (const FrontPlace& place : front_of(curves)) EXPECT_LT(place.error, .5);
}

// Renders like a worker for a submission: the pixels of some rows are the picture's pixels.
TEST(Rows, of_some_pixels_are_those_of_the_picture) {
  const pt::Scene scene = furnace();
  pt::View view = view_of(scene);
  view.settings.from = 0;
  view.settings.to = 3;
  for (const bool apart : {false, true}) {
    pt::RowsRequest request{0, view.height, 4, {}, 5, {}, {}};
    if (apart) request.ranges = {{0, 0}, {1, 1}, {2, 3}};
    const pt::PictureRows whole = pt::render_rows(view, request);
    request.only = {3, 47, 299};
    const pt::PictureRows some = pt::render_rows(view, request);
    const std::size_t ranges = std::max<std::size_t>(1, request.ranges.size());
    ASSERT_EQ(some.mean.size(), 3 * ranges);
    for (std::size_t k = 0; k < ranges; ++k) {
      for (std::size_t i = 0; i < 3; ++i) {
        const int x = request.only[i] % view.width, y = request.only[i] / view.width;
        EXPECT_EQ(some.mean[k * 3 + i], whole.mean[(y * ranges + k) * view.width + x]);
        if (!apart) continue;
        const pt::PixelApart alone =
            pt::render_pixel_apart(view, x, y, {4, {}, 5, 1}, request.ranges);
        EXPECT_EQ(some.mean[k * 3 + i], alone.pixels[k].mean);
      }
    }
  }
}

// Four samples per pixel make much noise. It is not light that few bounces would miss, nor an error
// of another picture.
TEST(Study, its_own_noise_is_left_out) {
  const pt::Scene scene = furnace();
  Study study(view_of(scene), 2, 8, {1, 4}, {});
  for (int m = 2; m <= 4; ++m) {
    const double missing = std::pow(2, -m) / 2.08;
    EXPECT_LT(study.bias2()[m].value, 1.3 * missing * missing) << m;
  }
  const Way way{pt::PathSettings::Direct::hemisphere, kAllBounces, .7};
  for (const Tried& tried : study.try_out(way, {1, 4})) {
    EXPECT_LT(std::abs(tried.bias2.value), kErrors * tried.bias2.error) << tried.light_samples;
  }
}

// Two engines and three rungs above them. Each has its own turns; the machine is slower in some.
struct Steps {
  std::vector<Rung> rungs;
  std::vector<RungTurns> turns;
};

Steps steps() {
  Steps steps;
  const auto add = [&](bool same_picture, double times, double variance, double rays) {
    Rung rung;
    rung.same_picture = same_picture;
    steps.rungs.push_back(rung);
    RungTurns turns;
    for (const double wobble : {-.01, .02, -.01})
      turns.log_times.push_back(std::log(times) + wobble);
    turns.seconds = 1e-4 * times;
    turns.rays = rays;
    turns.variance = {variance, .01 * variance};
    turns.bias2 = {0, 1};
    steps.turns.push_back(turns);
  };
  add(true, 20, 0, 0);
  add(true, 5, 0, 0);
  add(false, 1, .5, 100);
  add(false, 2, .1, 80);
  add(false, .5, .2, 40);
  steps.turns[2].log_times = {0, 0, 0};
  return steps;
}

TEST(Ladder, an_idea_is_worth_the_factor_in_time_and_variance) {
  const auto [rungs, turns] = steps();
  const std::vector<Climbed> climbed = worth_of(rungs, turns);
  const double worth[] = {1, 4, 5, 2.5, 2}, in_all[] = {1, 4, 20, 50, 100};
  const double rays[] = {1, 1, 1, 6.25, 6.25};
  for (std::size_t k = 0; k < climbed.size(); ++k) {
    EXPECT_NEAR(climbed[k].worth.value, worth[k], 1e-9 * worth[k]) << k;
    EXPECT_NEAR(climbed[k].in_all.value, in_all[k], 1e-9 * in_all[k]) << k;
    EXPECT_NEAR(climbed[k].in_all_rays, rays[k], 1e-9) << k;
  }
  EXPECT_NEAR(climbed[0].seconds, 20e-4, 1e-12);
  EXPECT_NEAR(climbed[4].seconds, .5e-4, 1e-12);
}

// Engines share the picture of the base, so its noise adds no error to their comparison. If two
// share their turns, a change in the machine's speed affects both.
TEST(Ladder, errors_are_those_of_times_and_of_noise) {
  const auto [rungs, turns] = steps();
  const std::vector<Climbed> climbed = worth_of(rungs, turns);
  const double wobble = .01;  // the standard error of the mean of the three
  EXPECT_NEAR(climbed[1].worth.error, 0, 1e-12);
  EXPECT_NEAR(climbed[2].worth.error, 5 * wobble, 1e-9);
  EXPECT_NEAR(climbed[3].worth.error, 2.5 * std::hypot(wobble, .01, .01), 1e-9);
  EXPECT_NEAR(climbed[4].worth.error, 2 * std::hypot(.01, .01), 1e-9);
  EXPECT_NEAR(climbed[4].in_all.error, 100 * std::hypot(std::hypot(wobble, wobble), .01, .01),
              1e-9);
}

TEST(Ladder, what_is_not_kept_is_not_compared_with) {
  auto [rungs, turns] = steps();
  rungs[3].kept = false;
  const std::vector<Climbed> climbed = worth_of(rungs, turns);
  EXPECT_NEAR(climbed[3].worth.value, 2.5, 1e-9);
  EXPECT_NEAR(climbed[4].worth.value, 5, 1e-9);
  EXPECT_NEAR(climbed[4].in_all.value, 100, 1e-7);
}

TEST(Ladder, a_bias_is_an_error_where_it_can_be_seen) {
  auto [rungs, turns] = steps();
  turns[4].bias2 = {.2, .01};
  turns[3].bias2 = {.2, .1};
  const std::vector<Climbed> climbed = worth_of(rungs, turns);
  EXPECT_TRUE(climbed[4].biased);
  EXPECT_NEAR(climbed[4].error2.value, .4, 1e-12);
  EXPECT_FALSE(climbed[3].biased);
  EXPECT_NEAR(climbed[3].error2.value, .1, 1e-12);
}

// The rung in brackets would be the best, and is not kept.
TEST(Ladder, tells_microseconds_percent_and_the_best_that_is_kept) {
  Ladder ladder;
  const auto add = [&](const char* idea, double in_all, bool kept) {
    Climbed& rung = ladder.rungs.emplace_back();
    rung.rung.idea = idea;
    rung.rung.kept = kept;
    rung.seconds = 25e-6;
    rung.rays = 7;
    rung.error2 = {.09, .001};
    rung.worth = {2, .1};
    rung.in_all = {in_all, .1};
    rung.in_all_rays = 3;
  };
  add("plain", 1, true);
  add("better", 8, true);
  add("worse", 4, true);
  add("too much", 16, false);
  const std::string text = to_text(ladder, {});
  const auto has = [&](const std::string& words) { return text.find(words) != std::string::npos; };
  EXPECT_TRUE(has(
      "  better                                     25       7       30 %   2.000 \u00b1 0.100"))
      << text;
  EXPECT_TRUE(has("  (too much)  ")) << text;
  EXPECT_TRUE(has("The best, with \"better\": ")) << text;
  EXPECT_TRUE(has("\n8.000 \u00b1 0.100 times as cheap as the plainest.\n")) << text;
}

// Renders of the furnace, radiance 2, by an invented machine: normal noise, equal in all pixels,
// with the given time and rays.
Worker made_up(double deviation, double bias, double seconds) {
  const auto program = [=](const RungRequest& request) {
    std::mt19937_64 random(request.spec.seed);
    std::normal_distribution<double> noise(2 + bias, deviation);
    RungReply reply;
    for (std::size_t i = request.first; i < 300; i += request.step) {
      reply.mean.push_back(noise(random));
      reply.cpu_seconds += seconds;
      reply.rays += 7;
      reply.samples += 4;
    }
    return reply;
  };
  return {{}, program, {}};
}

TEST(Ladder, turns_measure_noise_bias_and_time) {
  const pt::Scene scene = furnace();
  Study study(view_of(scene), 2, 10, kLimits, {});
  const std::vector<Worker> workers{made_up(.3, 0, 2e-6), made_up(.1, .2, 1e-6)};
  const std::vector<RungTurns> turns =
      take_turns(workers, {study, 11, 1, [](double part) { EXPECT_LE(part, 1); }});
  const double weight = 1 / (2.08 * 2.08);  // 4 % of the mean, 2, more than 2
  for (std::size_t k = 0; k < 2; ++k) {
    const double variance = weight * (k == 0 ? .09 : .01), bias2 = weight * (k == 0 ? 0 : .04);
    EXPECT_NEAR(turns[k].variance.value, variance,
                kErrors * turns[k].variance.error + kOfWeights * variance);
    // The mean of 5 squares per pixel, over 300 pixels.
    EXPECT_NEAR(turns[k].variance.error, variance * std::sqrt(2 / 1500.), .2 * variance * .0365);
    EXPECT_NEAR(turns[k].bias2.value, bias2, kErrors * turns[k].bias2.error + kOfWeights * bias2);
    EXPECT_NEAR(turns[k].seconds, k == 0 ? 2e-6 : 1e-6, 1e-12);
    EXPECT_NEAR(turns[k].rays, 7, 1e-9);
    EXPECT_NEAR(turns[k].samples, 4, 1e-9);
    for (const double log : turns[k].log_times) EXPECT_NEAR(log, k == 0 ? 0 : std::log(.5), 1e-9);
  }
}

// A turn takes as many new pixels as fit into its time, and the same pixels for all engines.
TEST(Ladder, engines_are_timed_on_the_same_pixels) {
  const pt::Scene scene = furnace();
  Study study(view_of(scene), 2, 12, {1, 4}, {});
  std::vector<std::pair<std::size_t, std::uint64_t>> asked[2];
  std::vector<Worker> engines{made_up(0, 0, .02), made_up(0, 0, .01)};
  for (int k = 0; k < 2; ++k) {
    engines[k].program = [&, k, made = engines[k].program](const RungRequest& request) {
      asked[k].emplace_back(request.first, request.spec.seed);
      return made(request);
    };
  }
  const std::vector<RungTurns> turns = time_engines(engines, {study, 13, 4.5, [](double) {}});
  for (const double log : turns[0].log_times) EXPECT_NEAR(log, std::log(2), 1e-9);
  ASSERT_EQ(asked[0].size(), 1 + turns[0].log_times.size()) << "a first look, and the turns";
  EXPECT_EQ(std::vector(asked[0].begin() + 1, asked[0].end()),
            std::vector(asked[1].begin() + 1, asked[1].end()));
  EXPECT_EQ(std::set(asked[0].begin() + 1, asked[0].end()).size(), turns[0].log_times.size());
}

}  // namespace
}  // namespace measure::scene
