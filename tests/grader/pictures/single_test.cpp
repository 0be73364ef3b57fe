// The verdict on one picture of a scene, with pictures that the reference renders and that are spoiled here.
#include "grader/pictures/single/verdict.h"
#include "pt/error.h"
#include "pt/file.h"
#include "pt/image/image_io.h"
#include "pt/image/tone_map.h"
#include "pt/render/choose_engine.h"
#include "pt/scene/frame_camera.h"
#include "pt/scene/load_collada.h"

#include <filesystem>
#include <string>

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

SingleVerdict judge(const SinglePicture& picture) {
  return judge_single(picture, {view(0, 3), kSamples, 1});
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

TEST(single, refuses_a_jpeg) {
  const std::filesystem::path file = std::filesystem::path(testing::TempDir()) /
                                     ("firstlight_" + std::to_string(getpid()) + ".jpg");
  pt::write_file(file, "\xff\xd8\xff\xe0 JFIF");
  EXPECT_THROW(read_single(file), pt::Error);
  std::filesystem::remove(file);
}

}  // namespace
}  // namespace grader::pictures
