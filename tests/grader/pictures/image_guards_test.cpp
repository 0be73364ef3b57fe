// The guards of the verdict on a picture: each sees its own kind of error and no other.
#include "grader/pictures/statistics/guards.h"
#include "tests/grader/pictures/judged_picture.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace grader::pictures {
namespace {

using Outcome = ImageVerdict::Outcome;

TEST_F(Judged, what_is_no_radiance_is_refused_at_once) {
  for (const double value :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), -1e-3}) {
    const auto verdict = judge(changed([value](pt::Image& image, int b, int) {
      if (b == 7) image.at(5, 20).g = value;
    }));
    EXPECT_EQ(verdict.outcome, Outcome::unusable);
    EXPECT_EQ(verdict.rounds, 1);
    EXPECT_NE(verdict.sentence.find("pixel (5, 20)"), std::string::npos) << verdict.sentence;
    ASSERT_EQ(verdict.cells.size(), 1u);
    EXPECT_EQ(verdict.cells[0].x, 5);
    ASSERT_EQ(verdict.render.width, kWidth);
    for (const pt::FilmPixel& pixel : verdict.render.pixels) EXPECT_TRUE(is_finite(pixel.mean));
  }
}

TEST_F(Judged, another_size_or_number_of_images_is_refused) {
  const auto small = judge([](int, int batches, int samples) {
    return Batches{samples, std::vector<pt::Image>(batches, pt::Image(kWidth, kHeight - 1))};
  });
  EXPECT_EQ(small.outcome, Outcome::unusable);
  EXPECT_EQ(small.sentence, "the picture is 48 x 35, and not 48 x 36");
  EXPECT_EQ(small.render.width, 0);
  const auto few = judge([](int, int, int samples) { return Batches{samples, {}}; });
  EXPECT_EQ(few.outcome, Outcome::unusable);
}

TEST_F(Judged, repeated_random_numbers_are_refused) {
  const auto verdict = judge([&](int round, int batches, int samples) {
    Batches result = submission(scene_, 9)(round, batches, samples);
    result.images[11] = result.images[3];
    return result;
  });
  EXPECT_EQ(verdict.outcome, Outcome::unusable);
  EXPECT_NE(verdict.sentence.find("identical"), std::string::npos);
}

TEST_F(Judged, a_picture_of_one_color_is_called_so) {
  for (const auto& [level, sentence] : {std::pair{0.0, "the whole picture is black"},
                                        std::pair{0.5, "every pixel has the same color"}}) {
    const auto verdict = judge(changed([level = level](pt::Image& image, int, int) {
      for (pt::Rgb& color : image.pixels) color = pt::gray(level);
    }));
    EXPECT_NE(verdict.outcome, Outcome::pass);
    EXPECT_EQ(verdict.sentence, sentence);
  }
}

// Nothing in this picture is random, so all batches are equal, as they should be.
TEST_F(Judged, a_picture_without_chance_may_repeat_itself) {
  for (SyntheticPixel& pixel : scene_.pixels) pixel.constant = true;
  golden_ = Draw(1).golden(scene_, 64);
  EXPECT_EQ(judge(submission(scene_, 1)).outcome, Outcome::pass);
  const auto wrong = judge(changed([](pt::Image& image, int, int) { image.at(3, 9) *= 1.01; }));
  EXPECT_EQ(wrong.outcome, Outcome::wrong);
  ASSERT_EQ(wrong.cells.size(), 1u);
  EXPECT_EQ(wrong.cells[0].x, 3);
  EXPECT_EQ(wrong.cells[0].y, 9);
  // A thousandth is allowed, so half of that is not a mistake.
  EXPECT_EQ(judge(changed([](pt::Image& image, int, int) {
              for (pt::Rgb& color : image.pixels) color *= 1.0005;
            })).outcome,
            Outcome::pass);
}

TEST_F(Judged, a_missing_light_is_a_wrong_constant) {
  const auto verdict = judge(changed([](pt::Image& image, int, int) {
    for (pt::Rgb& color : image.pixels) color = color.r == 5 ? pt::Rgb{} : color;
  }));
  ASSERT_EQ(verdict.outcome, Outcome::wrong);
  EXPECT_NE(verdict.sentence.find("should always be 5"), std::string::npos) << verdict.sentence;
}

// Only one sample in a thousand meets this corner, so the golden may have missed it.
TEST_F(Judged, a_constant_that_changes_once_may_be_luck) {
  EXPECT_EQ(judge(changed([](pt::Image& image, int b, int) {
              if (b == 3) image.at(2, 1) = pt::gray(0.5);
            })).outcome,
            Outcome::pass);
  EXPECT_EQ(judge(changed([](pt::Image& image, int b, int) {
              if (b % 4 == 3) image.at(2, 1) = pt::gray(0.5);
            })).outcome,
            Outcome::wrong);
}

TEST_F(Judged, a_wrong_constant_must_be_the_same_pixel_each_time) {
  const auto verdict = judge(
      changed([](pt::Image& image, int, int round) { image.at(1 + round, 1) = pt::gray(0.5); }));
  EXPECT_EQ(verdict.outcome, Outcome::pass);
  EXPECT_EQ(verdict.rounds, 2);
}

TEST_F(Judged, pixels_that_vary_together_are_found) {
  const auto verdict = judge(changed([](pt::Image& image, int b, int round) {
    const double factor = 1 + 0.02 * std::sin(7.0 * b + round);
    for (pt::Rgb& color : image.pixels) color = color.r < 4 ? color * factor : color;
  }));
  EXPECT_EQ(verdict.outcome, Outcome::wrong);
  EXPECT_NE(verdict.sentence.find("vary together"), std::string::npos) << verdict.sentence;
}

// A picture that is made of the golden, with a little noise so that no two batches are alike. With half
// of the golden's error or more it could be a very good one.
TEST_F(Judged, a_picture_of_the_golden_is_found) {
  const auto copy = [&](double part) {
    return [&, part](int round, int batches, int samples) {
      Draw draw(100 * round);
      std::normal_distribution<double> normal;
      Batches result{samples, std::vector<pt::Image>(batches, pt::Image(kWidth, kHeight))};
      for (pt::Image& image : result.images) {
        for (std::size_t i = 0; i < image.pixels.size(); ++i) {
          const pt::FilmPixel& pixel = golden_.pixels[i];
          const double error = std::sqrt(batches * pixel.variance.g / pixel.samples);
          image.pixels[i] =
              pixel.mean +
              std::max(-pixel.mean.g, part * error * normal(draw.random())) * pt::gray(1);
        }
      }
      return result;
    };
  };
  for (const double part : {1e-12, 1e-3, 0.3}) {
    const ImageVerdict verdict = judge(copy(part));
    EXPECT_EQ(verdict.outcome, Outcome::wrong) << part;
    EXPECT_NE(verdict.sentence.find("nearer to the golden"), std::string::npos) << verdict.sentence;
  }
  EXPECT_EQ(judge(copy(1)).outcome, Outcome::pass);
}

// The other extreme: the truth itself, from which only the golden deviates.
TEST(image_guards, a_picture_without_noise_is_not_too_near) {
  for (const Spread spread : {Spread::diffuse, Spread::fireflies, Spread::mostly_zero}) {
    const SyntheticScene scene = synthetic_scene(spread, 48, 36);
    pt::Image truth(48, 36);
    for (std::size_t i = 0; i < truth.pixels.size(); ++i) {
      truth.pixels[i] = scene.pixels[i].direct + scene.pixels[i].indirect;
    }
    const Golden golden = prepare(Draw(100).golden(scene, 4096));
    EXPECT_FALSE(is_too_near(compare(golden, moments({truth, truth}, 1))));
  }
}

TEST_F(Judged, noise_is_a_verdict_of_its_own) {
  SyntheticScene noisy = scene_;
  for (SyntheticPixel& pixel : noisy.pixels) pixel.shape /= 5;
  const auto verdict = judge(submission(noisy, 3));
  EXPECT_EQ(verdict.outcome, Outcome::too_noisy) << verdict.sentence;
  EXPECT_NEAR(verdict.noise, 5, 1);
  EXPECT_EQ(judge_image(golden_, NoiseClass::noisy, submission(noisy, 3)).outcome, Outcome::pass);
  for (SyntheticPixel& pixel : noisy.pixels) {
    if (!pixel.constant) pixel.direct *= 0.9;
  }
  const auto dark = judge(submission(noisy, 4));
  EXPECT_EQ(dark.outcome, Outcome::wrong);
  EXPECT_NE(dark.sentence.find("too dark"), std::string::npos) << dark.sentence;
}

// If edges have moved, samples vary where the golden's samples hardly do. This is not noise.
TEST(image_guards, a_picture_of_something_else_is_wrong_not_noisy) {
  constexpr int kWidth = 48, kHeight = 36;
  SyntheticScene right{kWidth, kHeight, Spread::diffuse, {}};
  right.pixels.resize(kWidth * kHeight);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      SyntheticPixel& pixel = right.pixels[y * kWidth + x];
      const bool left = x < kWidth / 2;
      pixel.direct = pt::gray(left ? 1 : 0.5);
      pixel.shape = left ? 1e4 : 1;
    }
  }
  SyntheticScene mirrored = right;
  for (int y = 0; y < kHeight; ++y) {
    std::reverse(mirrored.pixels.begin() + y * kWidth, mirrored.pixels.begin() + (y + 1) * kWidth);
  }
  const ImageVerdict verdict =
      judge_image(Draw(41).golden(right, 4096), NoiseClass::ordinary, submission(mirrored, 42));
  EXPECT_GT(verdict.noise, 3);
  EXPECT_EQ(verdict.outcome, Outcome::wrong) << verdict.sentence;
  EXPECT_FALSE(verdict.cells.empty());
}

}  // namespace
}  // namespace grader::pictures
