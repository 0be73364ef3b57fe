// The sentence on a wrong picture and its failing cells; the comparison of two goldens.
#include "grader/pictures/statistics/evidence.h"
#include "grader/pictures/statistics/image_verdict.h"
#include "grader/pictures/statistics/sentences.h"
#include "pt/error.h"
#include "tests/grader/pictures/judged_picture.h"

#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace grader::pictures {
namespace {

using Outcome = ImageVerdict::Outcome;

TEST_F(Judged, a_dark_block_is_named_and_outlined) {
  SyntheticScene wrong = scene_;
  for (int y = 16; y < 24; ++y) {
    for (int x = 8; x < 16; ++x) {
      SyntheticPixel& pixel = wrong.pixels[y * kWidth + x];
      pixel.direct *= 0.8;
      pixel.indirect *= 0.8;
    }
  }
  const auto verdict = judge(submission(wrong, 5));
  ASSERT_EQ(verdict.outcome, Outcome::wrong);
  ASSERT_FALSE(verdict.cells.empty());
  for (const results::FailingCell& cell : verdict.cells) {
    EXPECT_GE(cell.x, 8);
    EXPECT_LE(cell.x + cell.width, 16);
    EXPECT_GE(cell.y, 16);
    EXPECT_LE(cell.y + cell.height, 24);
    EXPECT_NEAR(cell.off_by, -0.2, 0.1);
    EXPECT_GT(cell.evidence, 1);
  }
  EXPECT_NE(verdict.sentence.find("% too dark in three independent renders"), std::string::npos)
      << verdict.sentence;
  EXPECT_GT(verdict.evidence.at(12, 20).r, 1);
  EXPECT_LT(verdict.evidence.at(40, 30).r, 1);
  ASSERT_EQ(verdict.render.width, kWidth);
  EXPECT_EQ(verdict.render.at(0, 0).samples, 448);
}

TEST_F(Judged, a_colour_that_is_off_is_named) {
  const auto verdict = judge(changed([](pt::Image& image, int, int) {
    for (pt::Rgb& color : image.pixels) {
      if (color.r > 0 && color.r < 4) color.b *= 1.12;
    }
  }));
  ASSERT_EQ(verdict.outcome, Outcome::wrong);
  EXPECT_THAT(verdict.sentence, testing::MatchesRegex("the blue of the whole picture was 1[0-9] % "
                                                      "too bright in three independent renders"));
}

TEST_F(Judged, a_cell_that_fails_once_is_dropped) {
  const auto brighter_in = [&](int which) {
    return changed([which](pt::Image& image, int, int round) {
      if (round != which) return;
      for (pt::Rgb& color : image.pixels) color = color.r < 4 ? color * 1.05 : color;
    });
  };
  EXPECT_EQ(judge(brighter_in(1)).outcome, Outcome::pass);
  EXPECT_EQ(judge(brighter_in(1)).rounds, 2);
  EXPECT_EQ(judge(brighter_in(2)).rounds, 1);
  const auto one = judge(brighter_in(1), 1);
  EXPECT_EQ(one.outcome, Outcome::wrong);
  EXPECT_THAT(one.sentence, testing::MatchesRegex("the whole picture was [45][.]. % too bright"));
}

TEST_F(Judged, a_cell_that_changes_its_sign_is_dropped) {
  const auto verdict = judge(changed([](pt::Image& image, int, int round) {
    for (pt::Rgb& color : image.pixels)
      color = color.r < 4 ? color * (round == 2 ? 0.95 : 1.05) : color;
  }));
  EXPECT_EQ(verdict.outcome, Outcome::pass);
  EXPECT_EQ(verdict.rounds, 2);
}

// Each run of an adaptive render is one sample, and so is each of the golden's 64 runs.
TEST_F(Judged, adaptive_pictures_are_judged_run_by_run) {
  const auto golden_of = [](const SyntheticScene& scene) {
    Draw draw(12);
    std::vector<pt::RunningMoments> sums(scene.pixels.size());
    for (int run = 0; run < 64; ++run) {
      const pt::Image image = draw.image(scene, 100);
      for (std::size_t i = 0; i < sums.size(); ++i) sums[i].add(image.pixels[i]);
    }
    pt::Film film(scene.width, scene.height);
    for (std::size_t i = 0; i < sums.size(); ++i) film.pixels[i] = sums[i].pixel();
    return film;
  };
  golden_ = golden_of(scene_);
  const auto judged = [&](const SyntheticScene& scene, std::uint64_t seed) {
    const RenderRound runs = submission(scene, seed);
    return judge_image(
        golden_, NoiseClass::ordinary,
        [&](int round, int batches, int samples) {
          EXPECT_EQ(samples, 1);
          Batches result = runs(round, batches, 100);
          result.samples = 1;
          return result;
        },
        3, kAdaptiveRounds);
  };
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    EXPECT_EQ(judged(scene_, seed).outcome, Outcome::pass);
  }
  for (const SyntheticError& error : synthetic_errors()) {
    EXPECT_EQ(judged(with(scene_, error), 7).outcome, Outcome::wrong) << error.name;
  }
}

// Pixel 6 of a picture of 4 x 3 is in column 2 and row 1.
TEST(sentences, name_the_constant_pixel_that_is_furthest_off) {
  Golden golden;
  golden.width = 4;
  golden.height = 3;
  for (Plane& plane : golden.mean) plane.assign(12, 1);
  const WrongConstant small{11, 0, 0.125, 0.125, 2}, large{6, 1, -0.25, -0.25, 5};
  EXPECT_EQ(sentence({large}, golden, 2),
            "the green of pixel (2, 1), in which nothing is random, should always be 1, and was "
            "0.75 in two independent renders");
  for (const auto& both : {std::vector{small, large}, std::vector{large, small}}) {
    EXPECT_EQ(sentence(both, golden, 1),
              "2 pixels in which nothing is random were wrong: the green of pixel (2, 1) should "
              "always be 1, and was 0.75");
  }
}

// Three batches of 4 samples, and five of 8. The mean of 4 samples has a quarter of a sample's
// variance. Three batches give half as much information about it as five.
TEST(pooled_film, has_the_mean_and_the_variance_of_a_sample) {
  const auto round = [](int batches, int samples, double mean, double variance) {
    Moments made{batches, samples, {}, {}};
    for (Plane& plane : made.mean) plane = {mean};
    for (Plane& plane : made.variance) plane = {variance};
    return made;
  };
  PooledFilm pooled(1, 1);
  pooled.add(round(3, 4, 1, 2));
  pooled.add(round(5, 8, 2, 4));
  const pt::FilmPixel& pixel = pooled.film().at(0, 0);
  EXPECT_EQ(pixel.samples, 12 + 40);
  EXPECT_NEAR(pixel.mean.g, (12 * 1 + 40 * 2) / 52., 1e-14);
  EXPECT_NEAR(pixel.variance.g, (2 * (4 * 2.) + 4 * (8 * 4.)) / 6, 1e-12);
  EXPECT_NEAR(pixel.variance_y, (2 * (4 * 2.) + 4 * (8 * 4.)) / 6, 1e-12);
}

TEST(contradictions, right_goldens_agree) {
  for (const Spread spread : {Spread::diffuse, Spread::fireflies, Spread::mostly_zero}) {
    const SyntheticScene scene = synthetic_scene(spread, 48, 36);
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
      const pt::Film older = Draw(seed).golden(scene, 4096);
      const pt::Film newer = Draw(seed + 100).golden(scene, seed % 2 == 0 ? 4096 : 65536);
      EXPECT_TRUE(contradictions(older, newer).empty()) << seed;
      EXPECT_TRUE(contradictions(newer, older).empty()) << seed;
    }
  }
}

// The shorter of two goldens never sees the light in one pixel of eight.
TEST(contradictions, a_rare_light_is_none) {
  SyntheticScene scene = synthetic_scene(Spread::mostly_zero, 48, 36);
  for (SyntheticPixel& pixel : scene.pixels) {
    pixel.hit = 5e-4;
    pixel.indirect = {};
  }
  const pt::Film older = Draw(1).golden(scene, 4096), newer = Draw(2).golden(scene, 1 << 18);
  EXPECT_TRUE(contradictions(older, newer).empty());
  EXPECT_TRUE(contradictions(newer, older).empty());
}

TEST(contradictions, wrong_goldens_are_told_apart) {
  const SyntheticScene scene = synthetic_scene(Spread::diffuse, 48, 36);
  const pt::Film older = Draw(1).golden(scene, 16384);
  for (const SyntheticError& error : synthetic_errors()) {
    const auto cells = contradictions(older, Draw(2).golden(with(scene, error), 16384));
    EXPECT_FALSE(cells.empty()) << error.name;
  }
  pt::Film light = older;
  for (pt::FilmPixel& pixel : light.pixels) {
    if (pixel.mean.r == 5) pixel.mean *= 1.01;
  }
  ASSERT_FALSE(contradictions(older, light).empty());
  EXPECT_NEAR(contradictions(older, light)[0].off_by, 0.01, 1e-9);
  EXPECT_THROW(contradictions(older, pt::Film(3, 3)), pt::Error);
}

}  // namespace
}  // namespace grader::pictures
