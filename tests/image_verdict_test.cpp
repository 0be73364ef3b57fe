// The verdict on a picture, on pictures drawn from known distributions: how often right ones fail,
// whether wrong ones do, and the guards.
#include "grader/images/image_verdict.h"

#include "grader/images/cells.h"
#include "grader/images/name_mistake.h"
#include "grader/images/normal.h"
#include "pt/error.h"
#include "tests/synthetic_pictures.h"

#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace grader {
namespace {

using Outcome = ImageVerdict::Outcome;

constexpr int kWidth = 48, kHeight = 36;
constexpr Spread kSpreads[] = {Spread::diffuse, Spread::fireflies, Spread::mostly_zero};

NoiseClass noise_of(Spread spread) {
  return spread == Spread::diffuse ? NoiseClass::ordinary : NoiseClass::noisy;
}

int golden_samples(Spread spread) { return spread == Spread::diffuse ? 4096 : 16384; }

// The least count that a binomial number exceeds less than once in a million.
int binomial_bound(int n, double p) {
  double term = std::exp(n * std::log1p(-p)), sum = term;
  int k = 0;
  while (1 - sum > 1e-6) {
    term *= (n - k) * p / (1 - p) / (k + 1);
    sum += term;
    ++k;
  }
  return k;
}

TEST(normal, quantiles_are_those_of_the_tables) {
  EXPECT_NEAR(normal_quantile_above(0.5), 0, 1e-9);
  EXPECT_NEAR(normal_quantile_above(0.025), 1.959964, 1e-6);
  EXPECT_NEAR(normal_quantile_above(1e-9), 5.997807, 1e-6);
}

// A picture of 96 x 72 in luminance alone: 6912 pixels, 432, 108 and 12 blocks, two sums.
TEST(image_verdict, thresholds_are_those_of_the_design) {
  const std::pair<int, double> scales[] = {
      {6912, 5.13}, {432, 4.58}, {108, 4.28}, {12, 3.77}, {2, 3.29}};
  for (const auto& [count, threshold] : scales) {
    EXPECT_NEAR(normal_quantile_above(1e-2 / 5 / count / 2), threshold, 0.006);
  }
  const Golden golden =
      prepare(Draw(1).golden(synthetic_scene(Spread::diffuse, kWidth, kHeight), 64));
  const Moments same{16, 4, golden.mean, golden.variance};
  const Comparison pictures = compare(golden, same);
  const std::vector<Complaint> kept(16, Complaint{cells_of(golden)[0], 9, 1, 0});
  // Equal pictures repeat nothing; the threshold shows where they differ a lot.
  EXPECT_TRUE(repeated(pictures, kept, 2e-3).empty());
  Comparison off = pictures;
  for (double& difference : off.difference[kLuminance]) difference = 1e3;
  ASSERT_EQ(repeated(off, kept, 2e-3).size(), 16u);
  EXPECT_NEAR(repeated(off, kept, 2e-3)[0].threshold, 3.66, 0.005);
}

// Else a golden's error would choose how much it counts, and the sum would be off for every picture.
TEST(image_verdict, a_pixel_does_not_choose_its_own_weight) {
  pt::Film film = Draw(1).golden(synthetic_scene(Spread::diffuse, kWidth, kHeight), 1024);
  const Golden before = prepare(film);
  const std::size_t i = 20 * kWidth + 30;
  film.pixels[i].mean *= 1.1;
  const Golden after = prepare(film);
  EXPECT_EQ(after.weighted[i], before.weighted[i]);
  EXPECT_GT(after.weighted[i + 1], before.weighted[i + 1]);
}

TEST(image_verdict, cells_cover_the_picture_with_ragged_borders) {
  SyntheticScene scene = synthetic_scene(Spread::diffuse, 50, 30);
  for (SyntheticPixel& pixel : scene.pixels) pixel = scene.pixels.back();
  int area[kScales] = {}, count[kScales] = {};
  for (const Cell& cell : cells_of(prepare(Draw(1).golden(scene, 64)))) {
    if (cell.plane != kLuminance || cell.weighted) continue;
    area[static_cast<int>(cell.scale)] += cell.width * cell.height;
    ++count[static_cast<int>(cell.scale)];
  }
  const int counts[kScales] = {1500, 13 * 8, 7 * 4, 3 * 2, 1};
  for (int scale = 0; scale < kScales; ++scale) {
    EXPECT_EQ(area[scale], 1500);
    EXPECT_EQ(count[scale], counts[scale]);
  }
}

// A right picture: the first stage complains at most as often as its level, and never do all three.
TEST(image_verdict, right_pictures_pass) {
  constexpr int kGoldens = 6, kPictures = 75;
  for (const Spread spread : kSpreads) {
    const SyntheticScene scene = synthetic_scene(spread, kWidth, kHeight);
    int complaints = 0;
    for (std::uint64_t i = 0; i < kGoldens; ++i) {
      const pt::Film golden = Draw(1000 + i).golden(scene, golden_samples(spread));
      for (std::uint64_t j = 0; j < kPictures; ++j) {
        const auto verdict =
            judge_image(golden, noise_of(spread), submission(scene, 10000 + i * kPictures + j));
        EXPECT_EQ(verdict.outcome, Outcome::pass) << verdict.sentence;
        EXPECT_EQ(verdict.sentence, "");
        EXPECT_TRUE(verdict.cells.empty());
        if (verdict.stages > 1) ++complaints;
      }
    }
    std::printf("stage 1 complains of %d in %d right pictures\n", complaints, kGoldens * kPictures);
    EXPECT_LE(complaints, binomial_bound(kGoldens * kPictures, 1e-2)) << static_cast<int>(spread);
  }
}

// The later stages see 16 cells that somebody complained of: here, of any cells at random.
TEST(image_verdict, later_stages_repeat_no_false_complaint) {
  constexpr int kGoldens = 5, kPictures = 60;
  for (const Spread spread : kSpreads) {
    const SyntheticScene scene = synthetic_scene(spread, kWidth, kHeight);
    const int samples = stages_of(noise_of(spread))[1].samples;
    int complaints = 0;
    for (std::uint64_t i = 0; i < kGoldens; ++i) {
      const Golden golden = prepare(Draw(2000 + i).golden(scene, golden_samples(spread)));
      const std::vector<Cell> cells = cells_of(golden);
      Draw draw(3000 + i);
      for (int j = 0; j < kPictures; ++j) {
        std::vector<Complaint> kept;
        while (kept.size() < 16) {
          kept.push_back(
              {cells[draw.random()() % cells.size()], draw.random()() % 2 == 0 ? 9.0 : -9.0, 1, 0});
        }
        const Moments stage = moments(draw.batches(scene, 16, samples).images, samples);
        if (!repeated(compare(golden, stage), kept, 2e-3).empty()) ++complaints;
      }
    }
    EXPECT_LE(complaints, binomial_bound(kGoldens * kPictures, 2e-3)) << static_cast<int>(spread);
  }
}

// Each error is found in every one of several pictures of the size and the samples that are graded.
TEST(image_verdict, errors_are_found) {
  for (const SyntheticError& error : synthetic_errors()) {
    const SyntheticScene right = synthetic_scene(Spread::diffuse, 96, 72);
    const SyntheticScene wrong = with(right, error);
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
      const pt::Film golden = Draw(500 + seed).golden(right, 16384);
      const auto verdict = judge_image(golden, NoiseClass::ordinary, submission(wrong, 600 + seed));
      EXPECT_EQ(verdict.outcome, Outcome::wrong) << error.name;
      EXPECT_EQ(verdict.stages, 3);
      EXPECT_EQ(verdict.samples, 64 + 128 + 256);
      EXPECT_FALSE(verdict.cells.empty());
      std::printf("%s: %s\n", error.name.c_str(), verdict.sentence.c_str());
    }
  }
}

class Judged : public testing::Test {
 protected:
  ImageVerdict judge(const RenderStage& render, int max_stages = 3) const {
    return judge_image(golden_, NoiseClass::ordinary, render, max_stages);
  }
  // A right submission whose images are changed before they are handed in.
  template <class Change>
  RenderStage changed(Change change) const {
    return [this, change](int stage, int batches, int samples) {
      Batches result = submission(scene_, 77)(stage, batches, samples);
      for (std::size_t b = 0; b < result.images.size(); ++b) {
        change(result.images[b], static_cast<int>(b), stage);
      }
      return result;
    };
  }

  SyntheticScene scene_ = synthetic_scene(Spread::diffuse, kWidth, kHeight);
  pt::Film golden_ = Draw(42).golden(scene_, 16384);
};

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
  for (const FailingCell& cell : verdict.cells) {
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

TEST_F(Judged, a_complaint_that_is_not_repeated_is_dropped) {
  const auto brighter_in = [&](int which) {
    return changed([which](pt::Image& image, int, int stage) {
      if (stage != which) return;
      for (pt::Rgb& color : image.pixels) color = color.r < 4 ? color * 1.05 : color;
    });
  };
  EXPECT_EQ(judge(brighter_in(1)).outcome, Outcome::pass);
  EXPECT_EQ(judge(brighter_in(1)).stages, 2);
  EXPECT_EQ(judge(brighter_in(2)).stages, 1);
  const auto one = judge(brighter_in(1), 1);
  EXPECT_EQ(one.outcome, Outcome::wrong);
  EXPECT_THAT(one.sentence, testing::MatchesRegex("the whole picture was [45][.]. % too bright"));
}

TEST_F(Judged, a_complaint_that_turns_round_is_dropped) {
  const auto verdict = judge(changed([](pt::Image& image, int, int stage) {
    for (pt::Rgb& color : image.pixels)
      color = color.r < 4 ? color * (stage == 2 ? 0.95 : 1.05) : color;
  }));
  EXPECT_EQ(verdict.outcome, Outcome::pass);
  EXPECT_EQ(verdict.stages, 2);
}

TEST_F(Judged, what_is_no_radiance_is_refused_at_once) {
  for (const double value :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), -1e-3}) {
    const auto verdict = judge(changed([value](pt::Image& image, int b, int) {
      if (b == 7) image.at(5, 20).g = value;
    }));
    EXPECT_EQ(verdict.outcome, Outcome::unusable);
    EXPECT_EQ(verdict.stages, 1);
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
  EXPECT_EQ(small.sentence, "the picture is 48 x 35 where 48 x 36 was asked for");
  EXPECT_EQ(small.render.width, 0);
  const auto few = judge([](int, int, int samples) { return Batches{samples, {}}; });
  EXPECT_EQ(few.outcome, Outcome::unusable);
}

TEST_F(Judged, repeated_random_numbers_are_refused) {
  const auto verdict = judge([&](int stage, int batches, int samples) {
    Batches result = submission(scene_, 9)(stage, batches, samples);
    result.images[11] = result.images[3];
    return result;
  });
  EXPECT_EQ(verdict.outcome, Outcome::unusable);
  EXPECT_NE(verdict.sentence.find("identical"), std::string::npos);
}

// Nothing in such a picture is random: all batches are alike, as they should be.
TEST_F(Judged, a_picture_without_chance_may_repeat_itself) {
  for (SyntheticPixel& pixel : scene_.pixels) pixel.constant = true;
  golden_ = Draw(1).golden(scene_, 64);
  EXPECT_EQ(judge(submission(scene_, 1)).outcome, Outcome::pass);
  const auto wrong = judge(changed([](pt::Image& image, int, int) { image.at(3, 9) *= 1.01; }));
  EXPECT_EQ(wrong.outcome, Outcome::wrong);
  ASSERT_EQ(wrong.cells.size(), 1u);
  EXPECT_EQ(wrong.cells[0].x, 3);
  EXPECT_EQ(wrong.cells[0].y, 9);
  // A thousandth is allowed; a half of that is no mistake.
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

// A corner that one sample in a thousand meets: the golden may have missed it.
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
      changed([](pt::Image& image, int, int stage) { image.at(1 + stage, 1) = pt::gray(0.5); }));
  EXPECT_EQ(verdict.outcome, Outcome::pass);
  EXPECT_EQ(verdict.stages, 2);
}

TEST_F(Judged, pixels_that_vary_together_are_found) {
  const auto verdict = judge(changed([](pt::Image& image, int b, int stage) {
    const double factor = 1 + 0.02 * std::sin(7.0 * b + stage);
    for (pt::Rgb& color : image.pixels) color = color.r < 4 ? color * factor : color;
  }));
  EXPECT_EQ(verdict.outcome, Outcome::wrong);
  EXPECT_NE(verdict.sentence.find("vary together"), std::string::npos) << verdict.sentence;
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

// A run of an adaptive render is a sample, and so is each of the golden's 64.
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
    const RenderStage runs = submission(scene, seed);
    return judge_image(
        golden_, NoiseClass::ordinary,
        [&](int stage, int batches, int samples) {
          EXPECT_EQ(samples, 1);
          Batches result = runs(stage, batches, 100);
          result.samples = 1;
          return result;
        },
        3, kAdaptiveStages);
  };
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    EXPECT_EQ(judged(scene_, seed).outcome, Outcome::pass);
  }
  for (const SyntheticError& error : synthetic_errors()) {
    EXPECT_EQ(judged(with(scene_, error), 7).outcome, Outcome::wrong) << error.name;
  }
}

TEST_F(Judged, a_known_mistake_is_named_and_no_other) {
  std::vector<KnownMistake> known;
  for (const SyntheticError& error : synthetic_errors()) {
    known.push_back({error.name, Draw(known.size()).golden(with(scene_, error), 8192)});
  }
  const auto named = [&](const SyntheticScene& scene, std::uint64_t seed) {
    return name_mistake(golden_, submission(scene, seed)(3, 16, 16), known);
  };
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    for (const SyntheticError& error : synthetic_errors()) {
      EXPECT_EQ(named(with(scene_, error), seed), error.name);
    }
    EXPECT_EQ(named(scene_, seed), std::nullopt);
    const SyntheticError other{"", [](SyntheticScene& scene) {
                                 for (SyntheticPixel& pixel : scene.pixels) pixel.direct *= 1.05;
                               }};
    EXPECT_EQ(named(with(scene_, other), seed), std::nullopt);
  }
}

TEST(contradictions, right_goldens_agree) {
  for (const Spread spread : kSpreads) {
    const SyntheticScene scene = synthetic_scene(spread, kWidth, kHeight);
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
  SyntheticScene scene = synthetic_scene(Spread::mostly_zero, kWidth, kHeight);
  for (SyntheticPixel& pixel : scene.pixels) {
    pixel.hit = 5e-4;
    pixel.indirect = {};
  }
  const pt::Film older = Draw(1).golden(scene, 4096), newer = Draw(2).golden(scene, 1 << 18);
  EXPECT_TRUE(contradictions(older, newer).empty());
  EXPECT_TRUE(contradictions(newer, older).empty());
}

TEST(contradictions, wrong_goldens_are_told_apart) {
  const SyntheticScene scene = synthetic_scene(Spread::diffuse, kWidth, kHeight);
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
}  // namespace grader
