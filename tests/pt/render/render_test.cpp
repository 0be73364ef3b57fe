#include "pt/image/exr.h"
#include "pt/render/pixel_record.h"
#include "pt/render/progress.h"
#include "pt/render/render_film.h"
#include "pt/render/render_rows.h"
#include "pt/render/rounds.h"

#include <atomic>
#include <chrono>
#include <cmath>
#include <limits>
#include <optional>
#include <regex>
#include <string>
#include <thread>
#include <utility>

#include <gtest/gtest.h>

namespace pt {
namespace {

// A floor under a rectangular light, a sphere on it, and a wall that glows with `glow`.
Scene make_scene(Rgb glow) {
  Scene scene;
  scene.primitives.triangles = {
      flat_triangle({-4, 0, -4}, {-4, 0, 4}, {4, 0, 4}),
      flat_triangle({-4, 0, -4}, {4, 0, 4}, {4, 0, -4}),
      flat_triangle({-4, 0, -4}, {4, 0, -4}, {0, 4, -4}),
  };
  scene.primitives.spheres = {{{0, 1, 0}, 1}};
  scene.materials = {{"diffuse", {.7, .5, .3}, {}, ""}, {"glowing", {.2, .2, .2}, glow, ""}};
  scene.material_of = {0, 0, 1, 0};
  scene.lights = {RectangleLight{{0, 5, 1}, {2, 0, 0}, {0, 0, 2}, {0, -1, 0}, {8, 8, 8}}};
  scene.tracer = Tracer(Engine::task, scene.primitives);
  return scene;
}

View make_view(const Scene& scene) {
  Camera camera;
  camera.position = {0, 2, 8};
  PathSettings settings;
  settings.to = 3;
  return {scene, camera, settings, 37, 29};
}

bool same_bits(const Film& a, const Film& b) {
  for (int y = 0; y < a.height; ++y) {
    for (int x = 0; x < a.width; ++x) {
      const FilmPixel &p = a.at(x, y), &q = b.at(x, y);
      if (p.mean != q.mean || p.variance != q.variance || p.variance_y != q.variance_y ||
          p.samples != q.samples) {
        return false;
      }
    }
  }
  return true;
}

TEST(RenderFilm, gives_the_same_bits_for_any_number_of_threads) {
  const Scene scene = make_scene({1, 2, 3});
  const View view = make_view(scene);
  RenderSettings settings{4, {}, 5, 1};
  for (const bool adaptive : {false, true}) {
    if (adaptive) settings.adaptive = AdaptiveSettings{64, 8, .1};
    settings.threads = 1;
    const RenderResult one = render_film(view, settings);
    for (const int threads : {2, 7}) {
      settings.threads = threads;
      const RenderResult many = render_film(view, settings);
      EXPECT_TRUE(same_bits(one.film, many.film)) << threads << " threads";
      EXPECT_EQ(one.rays.closest, many.rays.closest);
      EXPECT_EQ(one.rays.occluded, many.rays.occluded);
      EXPECT_EQ(one.tests.boxes, many.tests.boxes);
    }
  }
  settings.seed = 6;
  EXPECT_FALSE(same_bits(render_film(view, settings).film, render_film(view, {4, {}, 5, 2}).film));
}

// Up to a round it is the picture of render_film. Two rounds have the mean of two such pictures, and the variance
// around it, as single precision keeps the first.
TEST(Rounds, add_up) {
  const Scene scene = make_scene({1, 2, 3});
  const View view = make_view(scene);
  const RenderSettings one{kRound, {}, 5, 2}, two{2 * kRound, {}, 5, 2};
  const Film first = render_film(view, one).film;
  EXPECT_TRUE(same_bits(render_rounds(view, one, {}, {}).film, first));
  const RenderResult both = render_rounds(view, two, {}, {});
  EXPECT_TRUE(both.complete);
  EXPECT_EQ(both.rays.closest,
            render_rounds(view, two, first, {}).rays.closest + render_film(view, one).rays.closest);
  const Film second = render_film(view, {kRound, {}, 5 + 0x9e3779b97f4a7c15 * kRound, 2}).film;
  for (std::size_t i = 0; i < first.pixels.size(); ++i) {
    const FilmPixel &a = first.pixels[i], &b = second.pixels[i], &sum = both.film.pixels[i];
    const double mean = (a.mean.g + b.mean.g) / 2;
    const auto squares = [&](const FilmPixel& p) {
      const double step = p.mean.g - mean;
      return p.variance.g * (kRound - 1) + kRound * step * step;
    };
    EXPECT_EQ(sum.samples, 2 * kRound);
    EXPECT_NEAR(sum.mean.g, mean, 1e-7 * (1 + mean));
    const double variance = (squares(a) + squares(b)) / (2 * kRound - 1);
    EXPECT_NEAR(sum.variance.g, variance, 1e-6 * (1 + variance));
  }
}

// Stopped in the third round, at any pixel, and gone on with.
TEST(Rounds, give_the_same_bits_wherever_they_are_stopped) {
  const Scene scene = make_scene({1, 2, 3});
  const View view = make_view(scene);
  const RenderSettings settings{3 * kRound + 1, {}, 5, 2};
  const Film whole = render_rounds(view, settings, {}, {}).film;
  for (const double end : {.1, .4, .5, .9}) {
    std::atomic<bool> stop = false;
    RenderResult part = render_rounds(
        view, settings, {}, {}, [&](double done) { stop = done > end; }, &stop);
    EXPECT_FALSE(part.complete);
    Film kept = decode_exr(encode_exr(part.film), "part");
    const RenderResult all = render_rounds(view, settings, std::move(kept), {});
    EXPECT_TRUE(all.complete);
    int others = 0;
    const Film a = decode_exr(encode_exr(all.film), "a"), b = decode_exr(encode_exr(whole), "b");
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
      others += a.pixels[i].mean != b.pixels[i].mean ||
                a.pixels[i].variance_y != b.pixels[i].variance_y ||
                a.pixels[i].samples != b.pixels[i].samples;
    }
    EXPECT_EQ(others, 0) << end << " " << samples_of(part.film).least << " "
                         << samples_of(part.film).most;
  }
}

// A worker renders rows of means; the render program renders a film, from the top.
TEST(RenderRows, are_the_rows_of_the_film) {
  const Scene scene = make_scene({1, 2, 3});
  const View view = make_view(scene);
  for (const bool adaptive : {false, true}) {
    RenderSettings settings{4, {}, 5, 1};
    if (adaptive) settings.adaptive = AdaptiveSettings{64, 8, .1};
    const Film film = render_film(view, settings).film;
    const int first = 3, count = 20;
    const PictureRows rows = render_rows(view, {first, count, 4, settings.adaptive, 5});
    ASSERT_EQ(rows.mean.size(), static_cast<std::size_t>(count * view.width));
    ASSERT_EQ(rows.counts.size(), adaptive ? rows.mean.size() : 0);
    for (int i = 0; i < count * view.width; ++i) {
      const FilmPixel& pixel = film.at(i % view.width, view.height - 1 - first - i / view.width);
      EXPECT_EQ(rows.mean[i], pixel.mean);
      if (adaptive) {
        EXPECT_EQ(rows.counts[i], pixel.samples);
      }
    }
  }
}

// Sky above the wall is black and constant, with no variance at all. The floor is noisy.
TEST(RenderFilm, records_the_variance_of_the_samples) {
  const Scene scene = make_scene({1, 2, 3});
  const RenderResult result = render_film(make_view(scene), {16, {}, 5, 2});
  const FilmPixel corner = result.film.at(0, 0);
  EXPECT_EQ(corner.mean, Rgb{});
  EXPECT_EQ(corner.variance_y, 0);
  const FilmPixel floor = result.film.at(18, 26);
  EXPECT_GT(floor.mean.r, 0);
  EXPECT_GT(floor.variance.r, 0);
  EXPECT_EQ(floor.samples, 16);
}

// Every sample of a wall whose radiance does not fit a float is dropped, and its pixels are named.
TEST(RenderFilm, leaves_out_samples_that_are_not_finite) {
  for (const double glow : {std::numeric_limits<double>::infinity(), 1e60, 3.5e38}) {
    const Scene scene = make_scene({glow, 1, 1});
    const RenderResult result = render_film(make_view(scene), {4, {}, 5, 2});
    EXPECT_TRUE(result.complete);
    EXPECT_GT(result.not_finite, 0);
    ASSERT_TRUE(result.first_bad.has_value());
    const Film film = decode_exr(encode_exr(result.film), "film");
    for (const FilmPixel& pixel : film.pixels) {
      EXPECT_TRUE(is_finite(pixel.mean) && is_finite(pixel.variance));
    }
  }
  // This one fits a float, and the square of its distance from the mean does not.
  const RenderResult result = render_film(make_view(make_scene({1e38, 1, 1})), {4, {}, 5, 2});
  EXPECT_EQ(result.not_finite, 0);
  for (const FilmPixel& pixel : decode_exr(encode_exr(result.film), "film").pixels) {
    EXPECT_TRUE(is_finite(pixel.variance));
  }
}

// A wall that reflects nothing and glows adds its radiance to each sample that hits it and to no
// other. So a finite glow, far above everything else, shows how many samples per pixel an infinite
// glow spoils, and the sum of the others.
TEST(RenderFilm, counts_and_averages_around_samples_that_are_not_finite) {
  constexpr double kGlow = 1e9;
  constexpr int kSamples = 4;
  const auto render = [](double glow, int threads) {
    Scene scene = make_scene(gray(glow));
    scene.materials[1].albedo = {};
    // Its lowest corner is on the right, so the named pixel is not among the first ones rendered.
    scene.primitives.triangles[2] = flat_triangle({-4, 2, -4}, {4, 0, -4}, {0, 4, -4});
    scene.tracer = Tracer(Engine::task, scene.primitives);
    return render_film(make_view(scene), {kSamples, {}, 5, threads});
  };
  const RenderResult finite = render(kGlow, 2);
  const RenderResult infinite = render(std::numeric_limits<double>::infinity(), 2);
  ASSERT_EQ(finite.not_finite, 0);

  long long spoiled_in_all = 0;
  int some_are_left = 0;
  std::optional<BadPixel> first;
  for (int y = finite.film.height - 1; y >= 0; --y) {  // from the bottom row up
    for (int x = 0; x < finite.film.width; ++x) {
      const double sum = kSamples * finite.film.at(x, y).mean.r;
      const int spoiled = static_cast<int>(std::floor(sum / kGlow));
      const int left = kSamples - spoiled;
      spoiled_in_all += spoiled;
      if (spoiled > 0 && !first) first = BadPixel{x, finite.film.height - 1 - y};
      const double others = sum - spoiled * kGlow;
      const double mean = left > 0 ? others / left : 0;
      EXPECT_NEAR(infinite.film.at(x, y).mean.r, mean, 1e-5) << x << " " << y;
      some_are_left += spoiled > 0 && left > 0 && mean > 0.01 ? 1 : 0;
    }
  }
  EXPECT_GT(some_are_left, 0) << "no pixel shows what the mean is taken over";
  EXPECT_EQ(infinite.not_finite, spoiled_in_all);
  ASSERT_TRUE(first);
  for (const int threads : {1, 2, 3, 4, 5, 6, 7}) {
    const auto named = render(std::numeric_limits<double>::infinity(), threads).first_bad;
    ASSERT_TRUE(named);
    EXPECT_EQ(named->x, first->x);
    EXPECT_EQ(named->y, first->y);
  }
}

TEST(RenderFilm, stops_when_asked_and_says_so) {
  const Scene scene = make_scene({});
  const std::atomic<bool> stop = true;
  EXPECT_FALSE(render_film(make_view(scene), {4, {}, 5, 2}, {}, &stop).complete);
}

TEST(RenderFilm, tells_its_progress_up_to_the_end) {
  const Scene scene = make_scene({});
  double last = 0;
  render_film(make_view(scene), {1, {}, 5, 1}, [&](double part) {
    EXPECT_GE(part, last);
    last = part;
  });
  EXPECT_EQ(last, 1);
}

// A quarter of the work is done, so the rest takes three times as long.
TEST(Progress, tells_each_tenth_once_and_the_time_that_is_left_and_is_never_silent_for_long) {
  Progress progress;
  const auto said = [&](double part) {
    testing::internal::CaptureStderr();
    progress.show(part);
    return testing::internal::GetCapturedStderr();
  };
  EXPECT_EQ(said(0.2), "") << "what is over at once says nothing";
  std::this_thread::sleep_for(std::chrono::milliseconds(1100));
  const std::string text = said(0.25);
  std::smatch found;
  ASSERT_TRUE(
      std::regex_match(text, found, std::regex(R"(25 % after (\d+) s, about (\d+) s left\n)")))
      << text;
  EXPECT_GE(std::stoi(found[2]), 2 * std::stoi(found[1]));
  EXPECT_EQ(said(0.29), "");
  EXPECT_EQ(said(0.3).substr(0, 5), "30 % ");
  EXPECT_EQ(said(0.31), "");
  std::this_thread::sleep_for(std::chrono::milliseconds(2100));
  EXPECT_EQ(said(0.31).substr(0, 5), "31 % ");
  EXPECT_EQ(said(1), "");
}

TEST(TimedProgress, says_what_is_done_until_there_is_an_estimate_and_then_goes_on_by_the_clock) {
  const auto wait = [] { std::this_thread::sleep_for(std::chrono::milliseconds(2300)); };
  testing::internal::CaptureStderr();
  TimedProgress progress("a look");
  wait();
  EXPECT_EQ(testing::internal::GetCapturedStderr().substr(0, 9), "a look (2");
  testing::internal::CaptureStderr();
  progress.expect(60);
  wait();
  progress.clear();
  const std::string text = testing::internal::GetCapturedStderr();
  EXPECT_TRUE(std::regex_search(
      text, std::regex(R"(^measuring takes about 60 s\n\d+ % after \d+ s, about \d+ s left\n)")))
      << text;
  testing::internal::CaptureStderr();
  TimedProgress quick("a look");
  quick.expect(1);
  quick.clear();
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace pt
