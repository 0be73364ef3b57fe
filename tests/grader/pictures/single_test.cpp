// The verdicts on one picture and on one map of samples of a scene, with pictures that the reference renders and that are spoiled here.
#include "grader/pictures/single/rates.h"
#include "grader/pictures/single/verdict.h"
#include "pt/error.h"
#include "pt/file.h"
#include "pt/image/image_io.h"
#include "pt/image/tone_map.h"
#include "pt/render/choose_engine.h"
#include "pt/render/render_film.h"
#include "pt/scene/frame_camera.h"
#include "pt/scene/load_collada.h"

#include <algorithm>
#include <filesystem>
#include <string>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

namespace grader::pictures {
namespace {

using Outcome = SingleVerdict::Outcome;
using testing::HasSubstr;

constexpr int kWidth = 48, kHeight = 36, kSamples = 16;

const pt::LoadedScene& scene() {
  static const pt::LoadedScene loaded = [] {
    pt::LoadedScene one = pt::load_collada(FIRSTLIGHT_ROOT "/scenes/box_spheres.dae");
    pt::choose_engine(one.scene, pt::Engine::wide, 4);
    return one;
  }();
  return loaded;
}

pt::View view(int from, int to) {
  pt::PathSettings settings;
  settings.from = from;
  settings.to = to;
  return {scene().scene, pt::frame_camera(scene(), pt::Framing::file, kWidth, kHeight), settings,
          kWidth, kHeight};
}

pt::Image rendered(int to, std::uint64_t seed, int samples = kSamples) {
  return render_ours(view(0, to), samples, 1, seed, 1)[0];
}

SinglePicture as_png(const pt::Image& image, double exposure = 1) {
  SinglePicture picture{true, image};
  for (pt::Rgb& pixel : picture.linear.pixels) {
    for (int c = 0; c < 3; ++c) pixel[c] = pt::decode(pt::encode(pixel[c], exposure));
  }
  return picture;
}

SingleVerdict judge(const SinglePicture& picture, int samples = kSamples) {
  return judge_single(picture, {view(0, 3), samples, 2});
}

TEST(single, right_pictures_agree) {
  for (std::uint64_t seed = 100; seed < 103; ++seed) {
    const SingleVerdict png = judge(as_png(rendered(3, seed)));
    EXPECT_EQ(png.outcome, Outcome::agrees) << png.sentence;
    EXPECT_THAT(png.sentence, HasSubstr("would have been called wrong"));
    const SingleVerdict floats = judge({false, rendered(3, seed + 10)});
    EXPECT_EQ(floats.outcome, Outcome::agrees) << floats.sentence;
  }
  const SingleVerdict course = judge(as_png(rendered(3, 120), 1.4142135623730951));
  EXPECT_EQ(course.outcome, Outcome::agrees) << course.sentence;
  EXPECT_THAT(course.sentence, HasSubstr("exposure 1.41"));
}

TEST(single, names_what_explains_the_picture) {
  const auto expect = [](const SinglePicture& picture, const std::string& cause) {
    const SingleVerdict verdict = judge(picture);
    EXPECT_EQ(verdict.outcome, Outcome::wrong) << cause;
    EXPECT_THAT(verdict.cause, HasSubstr(cause)) << verdict.sentence;
  };
  expect(as_png(rendered(1, 200)), "indirect light is missing");
  expect({false, rendered(1, 201)}, "indirect light is missing");
  expect(as_png(rendered(3, 202), 3), "another exposure");
  pt::Image flipped = rendered(3, 203);
  for (int y = 0; y < kHeight / 2; ++y) {
    for (int x = 0; x < kWidth; ++x) std::swap(flipped.at(x, y), flipped.at(x, kHeight - 1 - y));
  }
  expect(as_png(flipped), "upside down");
  expect({false, pt::Image(kWidth, kHeight)}, "black");
}

pt::Image rendered(const pt::View& view, std::uint64_t seed) {
  return render_ours(view, kSamples, 1, seed, 1)[0];
}

TEST(single, names_an_object_that_is_missing_or_black) {
  pt::Scene without = scene().scene;
  without.primitives.spheres.pop_back();
  without.material_of.pop_back();
  pt::choose_engine(without, pt::Engine::wide, 4);
  pt::Scene black = scene().scene;
  black.materials.push_back({"none", {}, {}, ""});
  for (std::size_t i = black.primitives.triangles.size(); i < black.material_of.size(); ++i) {
    black.material_of[i] = static_cast<int>(black.materials.size()) - 1;
  }
  const pt::View right = view(0, 3);
  const auto cause = [&](const pt::Scene& other, std::uint64_t seed) {
    return judge(as_png(rendered({other, right.camera, right.settings, kWidth, kHeight}, seed)))
        .cause;
  };
  const pt::Vec3 p = scene().scene.primitives.spheres.back().center;
  EXPECT_THAT(
      cause(without, 600),
      HasSubstr(fmt::format("the sphere around {:.3g} {:.3g} {:.3g} is missing", p.x, p.y, p.z)));
  EXPECT_THAT(cause(black, 601), HasSubstr("every sphere is black"));
}

TEST(single, names_another_field_of_view) {
  for (const auto& [x, y] : {std::pair{1.2, 1.2}, {0.8, 0.8}, {0.75, 1.0}}) {
    pt::View other = view(0, 3);
    other.camera.hfov_deg *= x;
    other.camera.vfov_deg *= y;
    EXPECT_THAT(judge(as_png(rendered(other, 700))).cause, HasSubstr("its field of view is about"))
        << x << " " << y;
  }
}

TEST(single, names_single_pixels_and_repeated_samples) {
  pt::Image spoiled = rendered(3, 800, 64);
  for (int k = 0; k < 16; ++k) spoiled.at(16 + 2 * (k % 4), 24 + 2 * (k / 4)) = pt::Rgb{};
  EXPECT_THAT(judge(as_png(spoiled), 64).cause, HasSubstr("16 single pixels are black"));
  spoiled = rendered(3, 801);
  for (int k = 0; k < 4; ++k) spoiled.at(5 + 9 * k, 20 + k) = {400, 400, 400};
  EXPECT_THAT(judge({false, spoiled}).cause, HasSubstr("4 single pixels are far too bright"));
  // One tile of noise, 6 x 4 pixels, over the whole picture, and too much light.
  spoiled = rendered(3, 802, 256);
  pt::Sampler sampler(803);
  std::vector<double> noise;
  for (int k = 0; k < 24; ++k) noise.push_back(1.2 + 0.5 * sampler.next_1d());
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) spoiled.at(x, y) *= noise[x % 6 + 6 * (y % 4)];
  }
  EXPECT_THAT(judge({false, spoiled}, 64).cause, HasSubstr("0 to the right and 4 below"));
}

TEST(single, gives_no_cause_where_none_explains_the_picture) {
  pt::Image spoiled = rendered(3, 300);
  for (int y = 8; y < 32; ++y) {
    for (int x = 8; x < 32; ++x) spoiled.at(x, y) *= 0.6;
  }
  const SingleVerdict verdict = judge(as_png(spoiled));
  EXPECT_EQ(verdict.outcome, Outcome::wrong);
  EXPECT_EQ(verdict.cause, "");
  EXPECT_THAT(verdict.sentence, HasSubstr("too dark"));
}

TEST(single, cannot_say_of_far_fewer_samples_than_said) {
  EXPECT_EQ(judge({false, rendered(3, 400, 2)}).outcome, Outcome::cannot_say);
}

TEST(single, tells_another_size_and_what_is_no_radiance) {
  EXPECT_THAT(judge({false, pt::Image(kWidth, kHeight + 1)}).sentence,
              HasSubstr("48 x 37 pixels, and not 48 x 36"));
  pt::Image bad = rendered(3, 500);
  bad.at(3, 5).g = -1;
  EXPECT_THAT(judge({false, bad}).sentence, HasSubstr("the pixel x 3, y 5"));
}

// A map of ours in the colours of the course comes back, and is judged: right, and with half the samples.
TEST(single, judges_a_map_of_samples) {
  const pt::AdaptiveSettings settings{512, 16, 0.1};
  Recipe recipe;
  recipe.name = "rates";
  recipe.scene = FIRSTLIGHT_ROOT "/scenes/box_spheres.dae";
  recipe.width = kWidth;
  recipe.height = kHeight;
  recipe.settings.to = 1;
  recipe.adaptive = settings;
  recipe.seed = 7;
  const pt::SampleMap ours =
      sample_map(pt::render_film(view(0, 1), {1, settings, 900, 2}).film, settings.max_samples);
  pt::Picture picture(kWidth, kHeight);
  for (std::size_t i = 0; i < ours.counts.size(); ++i) {
    picture.pixels[i] = course_color(ours.counts[i], settings.max_samples);
  }
  const std::filesystem::path file = std::filesystem::path(testing::TempDir()) /
                                     ("firstlight_" + std::to_string(getpid()) + "_rate.png");
  pt::write_png(file, picture);
  pt::SampleMap read = read_rates(file, settings);
  EXPECT_EQ(read.counts, ours.counts);
  using Judged = RatesVerdict::Outcome;
  const RatesVerdict right = judge_rates(read, recipe, 2, [](double) {});
  EXPECT_EQ(right.outcome, Judged::agrees) << right.map.sentence;
  for (int& count : read.counts) count = std::max(16, count / 32 * 16);
  EXPECT_EQ(judge_rates(read, recipe, 2, [](double) {}).outcome, Judged::wrong);
  pt::write_png(file, pt::sample_picture(ours));
  EXPECT_THROW(read_rates(file, settings), pt::Error);
  std::filesystem::remove(file);
}

TEST(single, refuses_a_jpeg) {
  const std::filesystem::path file = std::filesystem::path(testing::TempDir()) /
                                     ("firstlight_" + std::to_string(getpid()) + ".jpg");
  pt::write_file(file, "\xff\xd8\xff\xe0 JFIF");
  EXPECT_THROW(read_single(file), pt::Error);
  std::filesystem::remove(file);
}

}  // namespace
}  // namespace grader::pictures
