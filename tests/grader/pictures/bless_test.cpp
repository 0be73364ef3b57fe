#include "grader/pictures/goldens/check_golden.h"
#include "grader/pictures/goldens/contact_sheet.h"
#include "grader/pictures/goldens/make_golden.h"
#include "grader/pictures/goldens/provenance.h"
#include "grader/pictures/recipes/seeds.h"
#include "pt/error.h"
#include "pt/file.h"
#include "pt/image/image_io.h"

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

namespace grader::pictures {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

const fs::path kRoot = FIRSTLIGHT_ROOT;

pt::Rgb random_color(pt::Sampler& sampler) {
  return {sampler.next_1d(), 100 + sampler.next_1d(), 3 * sampler.next_1d()};
}

TEST(Moments, of_parts_are_those_of_all_samples) {
  pt::Sampler sampler(1);
  pt::RunningMoments all;
  PixelMoments merged;
  for (const int samples : {1, 2, 50, 7}) {
    pt::RunningMoments part;
    for (int i = 0; i < samples; ++i) {
      const pt::Rgb color = random_color(sampler);
      all.add(color);
      part.add(color);
    }
    merged = merge(merged, moments_of(part.pixel()));
  }
  const pt::FilmPixel pixel = film_pixel(merged);
  EXPECT_EQ(pixel.samples, 60);
  for (int c = 0; c < 3; ++c) {
    EXPECT_NEAR(pixel.mean[c], all.mean()[c], 1e-12);
    EXPECT_NEAR(pixel.variance[c], all.variance()[c], 1e-12);
  }
  EXPECT_NEAR(pixel.variance_y, all.variance_y(), 1e-12);
}

TEST(Moments, of_equal_samples_have_no_variance_at_all) {
  PixelMoments merged;
  for (int i = 0; i < 10; ++i) {
    merged = merge(merged, moments_of({{.1, .7, 1 / 3.}, {}, 0, 256}));
  }
  const pt::FilmPixel pixel = film_pixel(merged);
  EXPECT_EQ(pixel.mean, (pt::Rgb{.1, .7, 1 / 3.}));
  EXPECT_EQ(pixel.variance, pt::Rgb{});
  EXPECT_EQ(pixel.variance_y, 0);
}

TEST(Moments, take_the_mean_of_a_run_as_a_sample) {
  const pt::FilmPixel one{{1, 1, 1}, {9, 9, 9}, 9, 32}, other{{3, 3, 3}, {5, 5, 5}, 5, 64};
  const pt::FilmPixel pixel = film_pixel(merge(one_sample(one), one_sample(other)));
  EXPECT_EQ(pixel.samples, 2);
  EXPECT_NEAR(pixel.mean.g, 2, 1e-15);
  EXPECT_NEAR(pixel.variance.g, 2, 1e-14);
  EXPECT_NEAR(pixel.variance_y, 2, 1e-14);
}

TEST(GoldenSeeds, are_never_those_of_a_judged_render) {
  Recipe last;
  last.seed = (std::uint64_t{1} << 31) - 1;
  Recipe first;
  first.seed = 1;
  EXPECT_NE(golden_seed(first, 0xffffffff), golden_seed(last, 0));
  EXPECT_NE(golden_seed(first, 0), golden_seed(first, 1));
  for (const std::uint64_t number : {golden_seed(last, 3), ~std::uint64_t{0}, std::uint64_t{0}}) {
    EXPECT_LT(judged_seed(number), golden_seed(first, 0));
  }
}

// Pixels whose means are normal around `radiance`, from 4096 samples of deviation .5 each.
pt::Film noisy_film(pt::Rgb radiance) {
  constexpr int kSamples = 4096;
  pt::Film film(96, 72);
  pt::Sampler sampler(2);
  for (pt::FilmPixel& pixel : film.pixels) {
    // The sum of twelve uniform numbers is nearly normal.
    double normal = -6;
    for (int i = 0; i < 12; ++i) normal += sampler.next_1d();
    pixel = {radiance + pt::gray(normal * .5 / std::sqrt(kSamples)), pt::gray(.25), .25, kSamples};
  }
  return film;
}

TEST(ClosedForm, holds_of_a_right_film_and_finds_small_errors) {
  pt::Film film = noisy_film({1, 2, 3});
  EXPECT_THAT(against_closed_form(film, {1, 2, 3}), testing::IsEmpty());
  const auto of_green = against_closed_form(film, {1, 2.001, 3});
  ASSERT_EQ(of_green.size(), 1u);
  EXPECT_THAT(of_green[0],
              HasSubstr("every pixel's g should be 2.001, but their mean is 1.99993, -11.4"));
  film.pixels[100].mean.b += .06;
  EXPECT_THAT(against_closed_form(film, {1, 2, 3}),
              testing::ElementsAre(HasSubstr("every pixel's b should be 3, but one is")));
  film.pixels[100].mean.b = std::nan("");
  EXPECT_FALSE(against_closed_form(film, {1, 2, 3}).empty());
}

TEST(ClosedForm, holds_without_noise_up_to_single_precision) {
  pt::Film film(4, 3);
  for (pt::FilmPixel& pixel : film.pixels) pixel = {pt::gray(static_cast<float>(.1)), {}, 0, 64};
  EXPECT_THAT(against_closed_form(film, pt::gray(.1)), testing::IsEmpty());
  EXPECT_FALSE(against_closed_form(film, pt::gray(.1001)).empty());
}

// Small pictures of small scenes, in the test's own folder.
class Bless : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string name = fs::temp_directory_path() / "bless_test.XXXXXX";
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    folder_ = name;
    for (const char* scene : {"box_empty.dae", "furnace.dae"}) {
      fs::copy_file(kRoot / "scenes" / scene, folder_ / scene);
    }
    fs::create_directory(folder_ / "golden");
    write_recipe("box", "box_empty.dae", R"("bounces": [0, 1])");
  }
  void TearDown() override { fs::remove_all(folder_); }

  void write_recipe(const std::string& name, const std::string& scene, const std::string& fields) {
    pt::write_file(folder_ / "recipes.json", R"({"recipes": [{"name": ")" + name +
                                                 R"(", "title": "t", "scene": ")" + scene +
                                                 R"(", "size": [12, 9], "seed": 5,
        "tasks": ["trace_path"], )" + fields + "}]}");
  }

  Recipe recipe() const { return load_recipes(folder_ / "recipes.json").at(0); }

  // Runs the program in the folder, returns its exit status and stores its output in said_.
  int bless(const std::string& arguments) {
    const bool has_commit = arguments.find("--commit") != std::string::npos;
    const std::string command = "cd '" + folder_.string() + "' && " + BLESS_PROGRAM +
                                " --recipes recipes.json --work work -t 2 --samples 64 " +
                                arguments + (has_commit ? "" : " --commit abc") + " >said 2>&1";
    const int status = std::system(command.c_str());
    said_ = without_progress(text("said"));
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

  // "50 % after 6 s, about 6 s left" appears on a slow machine.
  static std::string without_progress(const std::string& said) {
    std::istringstream lines(said);
    std::string rest;
    for (std::string line; std::getline(lines, line);) {
      if (line.find(" % after ") == line.npos) rest += line + '\n';
    }
    return rest;
  }

  std::string text(const std::string& file) const { return pt::read_file(folder_ / file, 1 << 20); }
  bool exists(const std::string& file) const { return fs::exists(folder_ / file); }

  fs::path folder_;
  std::string said_;
};

TEST_F(Bless, makes_a_golden_and_says_where_it_comes_from) {
  ASSERT_EQ(bless("box"), 0) << said_;
  EXPECT_EQ(said_, "box: 64 samples per pixel in 0 CPU seconds\n");
  const pt::Film film = pt::read_exr(folder_ / "golden/box.exr");
  EXPECT_EQ(film.width, 12);
  EXPECT_EQ(film.height, 9);
  EXPECT_EQ(film.pixels[50].samples, 64);
  EXPECT_GT(film.pixels[50].variance_y, 0);
  const Provenance from = read_provenance(folder_ / "golden/box.json");
  EXPECT_EQ(from.recipe, "box");
  EXPECT_EQ(from.command, "./run bless box --samples 64");
  EXPECT_EQ(from.commit, "abc");
  EXPECT_EQ(from.first_seed, golden_seed(recipe(), 0));
  EXPECT_EQ(from.parts, 2);
  EXPECT_EQ(from.samples, 64);
  EXPECT_EQ(from.because, "");
  EXPECT_EQ(from.sha256, picture_hash(recipe()));
  EXPECT_THAT(from.settings, HasSubstr(R"("bounces":[0,1])"));
  EXPECT_TRUE(exists("golden/contact_sheet.png"));
  EXPECT_FALSE(exists("work/box.partial"));
}

// Half of the pixels are 2 with deviation 3, the others black. The median of the varying pixels is
// 1.5. The root of the mean variance is 4.5, for a mean of 1. 256 samples took 8 seconds; a judge
// renders 64 of them at first, all if the picture is noisy, and six runs of an adaptive picture.
TEST_F(Bless, has_a_table_of_noise_and_time) {
  pt::Film film(12, 9);
  for (std::size_t i = 0; i < film.pixels.size(); i += 2) {
    film.pixels[i] = {pt::gray(2), pt::gray(9), 9, 256};
  }
  const fs::path folder = folder_ / "golden";
  pt::write_exr(golden_files(folder, "box").film, film);
  Provenance from;
  from.recipe = "box";
  from.samples = 256;
  from.cpu_seconds = 8;
  from.settings = recipe_settings(recipe());
  write_provenance(golden_files(folder, "box").provenance, from);
  Recipe each = recipe();
  EXPECT_THAT(golden_table({each}, folder),
              HasSubstr("| box | t | trace_path | 1.50, 2.12 | 2.00 |\n"));
  each.noisy = true;
  EXPECT_THAT(golden_table({each}, folder),
              HasSubstr("| box (noisy) | t | trace_path | 1.50, 2.12 | 8.00 |\n"));
  each.adaptive = pt::AdaptiveSettings{};
  EXPECT_THAT(golden_table({each}, folder), HasSubstr("1.50, 2.12 | 0.19 |\n"));
}

TEST_F(Bless, leaves_a_golden_that_is_up_to_date) {
  ASSERT_EQ(bless(""), 0) << said_;
  const auto time = fs::last_write_time(folder_ / "golden/box.exr");
  ASSERT_EQ(bless(""), 0) << said_;
  EXPECT_EQ(said_, "box: is up to date\n");
  EXPECT_EQ(fs::last_write_time(folder_ / "golden/box.exr"), time);
}

TEST_F(Bless, makes_a_golden_again_when_told_to) {
  ASSERT_EQ(bless("box"), 0) << said_;
  const std::string film = text("golden/box.exr");
  pt::write_file(folder_ / "golden/box.json", "{}");
  ASSERT_EQ(bless("box"), 0) << said_;  // nobody knows where the film came from
  EXPECT_EQ(read_provenance(folder_ / "golden/box.json").commit, "abc");
  ASSERT_EQ(bless("box --again --commit def"), 0) << said_;
  EXPECT_EQ(read_provenance(folder_ / "golden/box.json").commit, "def");
  EXPECT_TRUE(text("golden/box.exr") == film);
}

// Another picture in its place would be judged by without a word.
TEST_F(Bless, knows_whether_a_golden_has_been_exchanged) {
  ASSERT_EQ(bless("box"), 0) << said_;
  const GoldenFiles files = golden_files(folder_ / "golden", "box");
  EXPECT_NO_THROW(expect_as_made(files));
  pt::Film film = pt::read_exr(files.film);
  film.pixels[0].mean.r += 1;
  pt::write_exr(files.film, film);
  try {
    expect_as_made(files);
    ADD_FAILURE() << "nobody sees it";
  } catch (const pt::Error& error) {
    EXPECT_STREQ(error.what(),
                 "golden/box.exr is not the golden that was made: get it back (git checkout "
                 "golden), or make it again (./run bless box)");
  }
  EXPECT_THAT(check_golden(recipe(), folder_ / "golden"),
              testing::Contains(HasSubstr("is not the golden that was made")));
  ASSERT_EQ(bless("box --because 'it was exchanged'"), 0) << said_;
  EXPECT_NO_THROW(expect_as_made(files));
  pt::write_file(files.rates, "{}");  // of the sample map, too
  EXPECT_THROW(expect_as_made(files), pt::Error);
  fs::remove(files.film);
  EXPECT_NO_THROW(expect_as_made(files));  // who needs it says that it is missing
}

TEST_F(Bless, goes_on_where_it_was_stopped) {
  struct Stopped {};
  const fs::path partial = folder_ / "box.partial";
  const Effort effort{4, 8};
  const GoldenState whole = render_golden(recipe(), effort, 1, folder_ / "whole", [](double) {});
  EXPECT_THROW(render_golden(recipe(), effort, 1, partial,
                             [](double part) {
                               if (part >= .5) throw Stopped();
                             }),
               Stopped);
  int parts = 0;
  const GoldenState resumed = render_golden(recipe(), effort, 1, partial, [&](double) { ++parts; });
  EXPECT_EQ(parts, 2);
  ASSERT_EQ(resumed.pixels.size(), whole.pixels.size());
  for (std::size_t i = 0; i < whole.pixels.size(); ++i) {
    EXPECT_EQ(resumed.pixels[i].samples, 32);
    EXPECT_EQ(resumed.pixels[i].mean, whole.pixels[i].mean);
    EXPECT_EQ(resumed.pixels[i].squares, whole.pixels[i].squares);
  }
  // The state of another picture is not continued, nor is an unreadable state.
  write_recipe("box", "box_empty.dae", R"("bounces": [0, 2])");
  render_golden(recipe(), effort, 1, partial, [&](double) { ++parts; });
  EXPECT_EQ(parts, 6);
  pt::write_file(partial, "nonsense");
  render_golden(recipe(), effort, 1, partial, [&](double) { ++parts; });
  EXPECT_EQ(parts, 10);
}

TEST_F(Bless, keeps_a_golden_that_the_new_one_contradicts) {
  ASSERT_EQ(bless("box"), 0) << said_;
  const std::string before = text("golden/box.exr") + text("golden/box.json");
  write_recipe("box", "box_empty.dae", R"("bounces": [0, 3])");
  ASSERT_EQ(bless("box"), 1) << said_;
  EXPECT_THAT(said_, HasSubstr("box: the new golden contradicts the old one, which stays: the "));
  EXPECT_THAT(said_, HasSubstr("brighter"));
  EXPECT_THAT(said_, HasSubstr("./run bless box --because"));
  EXPECT_TRUE(text("golden/box.exr") + text("golden/box.json") == before);

  ASSERT_EQ(bless("box --because 'three bounces now'"), 0) << said_;
  EXPECT_EQ(read_provenance(folder_ / "golden/box.json").because, "three bounces now");
  EXPECT_FALSE(text("golden/box.exr") + text("golden/box.json") == before);
}

TEST_F(Bless, needs_no_reason_where_old_and_new_agree) {
  write_recipe("box", "box_empty.dae", R"("bounces": [0, 2], "survival": 0.5)");
  ASSERT_EQ(bless("box"), 0) << said_;
  write_recipe("box", "box_empty.dae", R"("bounces": [0, 2], "light_samples": 3)");
  ASSERT_EQ(bless("box --because 'for no reason'"), 0) << said_;
  const Provenance from = read_provenance(folder_ / "golden/box.json");
  EXPECT_EQ(from.because, "");
  EXPECT_EQ(from.sha256, picture_hash(recipe()));
}

TEST_F(Bless, refuses_another_size_without_a_reason) {
  ASSERT_EQ(bless("box"), 0) << said_;
  write_recipe("box", "box_empty.dae", R"("size": [8, 6], "bounces": [0, 1])");
  ASSERT_EQ(bless("box"), 1) << said_;
  EXPECT_THAT(said_, HasSubstr("it was 12 x 9 and is 8 x 6 now"));
}

TEST_F(Bless, holds_a_golden_against_theory) {
  const std::string furnace = R"("bounces": [0, 2], "direct": "hemisphere", "uniform": )";
  write_recipe("furnace", "furnace.dae", furnace + "[1.75, 1.75, 1.75]");
  EXPECT_EQ(bless("furnace"), 0) << said_;
  fs::remove_all(folder_ / "golden");
  write_recipe("furnace", "furnace.dae", furnace + "[1.75, 1.8, 1.75]");
  EXPECT_EQ(bless("furnace"), 1) << said_;
  EXPECT_THAT(said_, HasSubstr("furnace: every pixel's g should be 1.8"));
  EXPECT_FALSE(exists("golden/furnace.exr"));
}

TEST_F(Bless, makes_the_reference_of_a_sample_map) {
  write_recipe("rates", "box_empty.dae",
               R"("size": [24, 18], "bounces": [0, 1],
                  "adaptive": {"max_samples": 64, "batch": 8, "tolerance": 0.2})");
  ASSERT_EQ(bless("rates"), 0) << said_;
  EXPECT_EQ(pt::read_exr(folder_ / "golden/rates.exr").pixels[200].samples, 64);
  EXPECT_THAT(text("golden/rates_rates.json"), HasSubstr("\"runs\": 64"));
}

TEST_F(Bless, says_what_cannot_be_blessed) {
  EXPECT_EQ(bless("bax"), 2);
  EXPECT_EQ(said_, "there is no recipe 'bax'; choose one of box\n");
  EXPECT_EQ(bless("--recipes nowhere.json"), 2);
  EXPECT_EQ(bless("--samples 3"), 2);
}

TEST_F(Bless, checks_what_is_there) {
  EXPECT_EQ(bless("--check"), 1);
  EXPECT_THAT(said_, HasSubstr("recipe 'box': cannot read 'golden/box.json': there is no such"));
  EXPECT_THAT(said_, HasSubstr("run ./run bless box\n"));
  ASSERT_EQ(bless("box"), 0);
  EXPECT_EQ(bless("--check"), 1);
  EXPECT_EQ(said_,
            "recipe 'box': its golden has 64 samples per pixel where 4096 are needed; run ./run "
            "bless box\n");
  write_recipe("box", "box_empty.dae", R"("size": [8, 6], "bounces": [0, 1])");
  EXPECT_EQ(bless("--check"), 1);
  EXPECT_THAT(said_, HasSubstr("its recipe or its scene has changed"));
  EXPECT_THAT(said_, HasSubstr("its golden is 12 x 9 and not 8 x 6"));
  pt::write_file(folder_ / "golden/bix.exr", "");
  EXPECT_EQ(bless("--check"), 1);
  EXPECT_THAT(said_, HasSubstr("'golden/bix.exr' belongs to no recipe; remove it"));
}

TEST_F(Bless, notices_a_scene_that_changed) {
  const std::string before = picture_hash(recipe());
  pt::write_file(folder_ / "box_empty.dae", text("box_empty.dae") + "\n");
  EXPECT_NE(picture_hash(recipe()), before);
}

}  // namespace
}  // namespace grader::pictures
