// ./run compare A B, and the test by which it says whether two noisy pictures differ.
#include "grader/pictures/statistics/flip.h"
#include "grader/pictures/statistics/welch.h"
#include "pt/error.h"
#include "pt/file.h"
#include "pt/image/image_io.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

namespace grader::pictures {
namespace {

namespace fs = std::filesystem;
using pt::Film;
using pt::FilmPixel;
using pt::gray;
using pt::Image;

// Each sample is 0, or 4 with a chance of a quarter: the variance is three times the squared mean, as of pixels that find a lamp
// now and then. `at` changes the mean of a pixel.
template <class At>
Image noisy(int width, int height, int samples, std::mt19937& random, const At& at) {
  Image image(width, height);
  std::binomial_distribution<int> hits(samples, 0.25);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) image.at(x, y) = gray(at(x, y) * 4 * hits(random) / samples);
  }
  return image;
}
constexpr auto kEqual = [](int, int) { return 1.0; };

template <class At>
NoisyPicture noisy_of(int pictures, std::mt19937& random, const At& at) {
  std::vector<Image> all;
  for (int i = 0; i < pictures; ++i) all.push_back(noisy(48, 48, 16, random, at));
  return noisy_picture(all);
}

TEST(welch, finds_no_difference_between_equal_pictures) {
  std::mt19937 random(1);
  constexpr int kPairs = 1500;
  std::array<int, 10> of_whole{}, of_blocks{};
  int differing = 0, blocks = 0;
  for (int i = 0; i < kPairs; ++i) {
    const WelchTest test =
        welch_test(noisy_of(2 + i % 5, random, kEqual), noisy_of(2 + i % 3, random, kEqual));
    differing += test.differing.empty() ? 0 : 1;
    for (const BlockDifference& block : test.blocks) {
      if (block.side != 0 && block.side != 24) continue;
      auto& histogram = block.side == 0 ? of_whole : of_blocks;
      ++histogram[std::min(static_cast<int>(10 * block.p), 9)];
      blocks += block.side == 0 ? 0 : 1;
    }
  }
  // At most one in a thousand: of 1,500 five or more with a chance of 2 %, eight or more of 1 in 10,000.
  EXPECT_LE(differing, 7);
  // The chance of every tenth of p is a tenth. Five standard deviations of each count; blocks of one pair are independent.
  for (const int count : of_whole) EXPECT_NEAR(count, kPairs / 10., 5 * std::sqrt(kPairs * .09));
  for (const int count : of_blocks) EXPECT_NEAR(count, blocks / 10., 5 * std::sqrt(blocks * .09));
}

TEST(welch, finds_as_small_a_difference_as_it_says) {
  std::mt19937 random(2);
  const WelchTest equal = welch_test(noisy_of(8, random, kEqual), noisy_of(8, random, kEqual));
  const double whole = equal.blocks.back().would_be_found;
  int found = 0;
  for (int i = 0; i < 100; ++i) {
    const NoisyPicture a = noisy_of(8, random, [&](int, int) { return 1 + whole; });
    found += welch_test(a, noisy_of(8, random, kEqual)).differing.empty() ? 0 : 1;
  }
  EXPECT_GE(found, 80);
}

TEST(welch, names_the_block_that_differs) {
  std::mt19937 random(3);
  const NoisyPicture a = noisy_of(
      6, random, [](int x, int y) { return x >= 8 && x < 16 && y >= 24 && y < 32 ? 1.6 : 1; });
  const WelchTest test = welch_test(a, noisy_of(6, random, kEqual));
  ASSERT_FALSE(test.differing.empty());
  const BlockDifference& worst = test.differing[0];
  EXPECT_TRUE(worst.x >= 8 && worst.x < 16 && worst.y >= 24 && worst.y < 32)
      << worst.x << " " << worst.y;
  EXPECT_GT(worst.off_by, .3);
}

// A filter that mixes neighbours: the noise of a block is larger than its pixels say.
TEST(welch, knows_neighbours_that_share_their_noise) {
  std::mt19937 random(4);
  int differing = 0;
  const auto filtered = [&] {
    std::vector<Image> all;
    for (int i = 0; i < 6; ++i) {
      const Image sharp = noisy(50, 50, 16, random, kEqual);
      Image soft(48, 48);
      for (int y = 0; y < 48; ++y) {
        for (int x = 0; x < 48; ++x) {
          for (int k = 0; k < 9; ++k) soft.at(x, y) += sharp.at(x + k % 3, y + k / 3) / 9;
        }
      }
      all.push_back(soft);
    }
    return noisy_picture(all);
  };
  for (int i = 0; i < 100; ++i)
    differing += welch_test(filtered(), filtered()).differing.empty() ? 0 : 1;
  EXPECT_LE(differing, 2);
}

TEST(welch, refuses_pictures_whose_noise_is_not_known) {
  EXPECT_THROW(noisy_picture({Image(2, 2)}), pt::Error);
  EXPECT_THROW(noisy_picture({Image(2, 2), Image(2, 3)}), pt::Error);
  EXPECT_THROW(noisy_picture(Film(2, 2), "a.exr"), pt::Error);
}

// The values of Student's distribution that every table has.
TEST(welch, has_students_distribution) {
  EXPECT_NEAR(student_p(2.0860, 20), .05, .0005);
  EXPECT_NEAR(student_p(4.5869, 10), .001, .00003);
  EXPECT_NEAR(student_p(3.1824, 3), .05, .002);
}

// Each test has its own folder, which is removed after it.
class Compare : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) / fmt::format("firstlight_compare_{}", getpid());
    fs::create_directory(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }
  std::string in_folder(const std::string& name) const { return folder_ / name; }

  struct Said {
    int status = -1;
    std::string text;
  };
  static Said compare(const std::string& arguments) {
    FILE* pipe = popen(fmt::format("{} {} 2>&1", COMPARE_PROGRAM, arguments).c_str(), "r");
    Said said;
    for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe))
      said.text += static_cast<char>(c);
    const int status = pclose(pipe);
    if (WIFEXITED(status)) said.status = WEXITSTATUS(status);
    return said;
  }

 private:
  fs::path folder_;
};

Film flat_film(double value, int width = 2, int height = 2) {
  Film film(width, height);
  for (FilmPixel& pixel : film.pixels) pixel = {gray(value), {}, value, 4};
  return film;
}

// One green channel of 12 differs by a half.
TEST_F(Compare, says_how_far_and_in_which_direction) {
  const std::string a = in_folder("a.exr"), b = in_folder("b.exr");
  Film film = flat_film(1);
  pt::write_image(b, film);
  film.set(0, 1, {{1, 0.5, 1}, {}, 1, 4});
  pt::write_image(a, film);
  const Said said = compare(a + " " + b);
  EXPECT_EQ(said.status, 0);
  std::string text = said.text.substr(0, said.text.find("equal"));
  const std::size_t flip = text.find("FLIP     0.");
  ASSERT_NE(flip, text.npos) << text;
  text.erase(flip, text.find('\n', flip) + 1 - flip);
  EXPECT_EQ(text,
            "MSE      0.0208333\n"
            "relMSE   0.0192616   (mean of (A - B)^2 / (B + 0.04)^2)\n"
            "mean A   1 0.875 1\n"
            "mean B   1 1 1\n"
            "largest  -0.5 at x 0, y 1 (from the top left), channel g: A 0.5, B 1\n");
}

Image flat(pt::Rgb color) {
  Image image(9, 5);
  for (pt::Rgb& pixel : image.pixels) pixel = color;
  return image;
}

// Pictures of one colour have no edges and nothing to blur. Between black and white L differs by 100, which is 100^.7 = 25.12 of
// the largest, 41.28; the first 40 % of that have 95 % of the range. Green and blue are furthest from each other.
TEST(flip, of_one_color_beside_another_is_known) {
  EXPECT_EQ(flip(flat(gray(.3)), flat(gray(.3))), 0);
  const double most = 41.2760, part = std::pow(100, .7) / most;
  EXPECT_NEAR(flip(flat({}), flat(gray(1))), .95 + .05 * (part - .4) / .6, 1e-5);
  EXPECT_NEAR(flip(flat({0, 1, 0}), flat({0, 0, 1})), 1, 1e-9);
  EXPECT_NEAR(flip(flat({0, 0, 1}), flat({0, 1, 0})), 1, 1e-9);
  EXPECT_EQ(flip(flat(gray(std::nan(""))), flat({})), 0) << "what is not finite is black";
}

// The values of the program of its authors (NVlabs/flip 1.7), for the same light and 67.02 pixels a degree.
TEST(flip, of_waves_and_of_points_is_that_of_its_authors) {
  Image waves(54, 40), darker = waves;
  for (int y = 0; y < 40; ++y) {
    for (int x = 0; x < 54; ++x) {
      waves.at(x, y) = gray(.5 * (1 + std::sin(x * .3) * std::cos(y * .2)));
      darker.at(x, y) = waves.at(x, y) * .9;
    }
  }
  EXPECT_NEAR(flip(waves, darker), .177869, 2e-5);
  Image edges(61, 45), points = edges;
  for (int y = 0; y < 45; ++y) {
    for (int x = 0; x < 61; ++x) {
      edges.at(x, y) = {x > 30 ? .8 : .2, .3, y > 22 ? .7 : .1};
      points.at(x, y) = (x * 7 + y * 13) % 29 == 0 ? gray(1) : edges.at(x, y);
    }
  }
  EXPECT_NEAR(flip(edges, points), .141717, 2e-5);
}

TEST_F(Compare, draws_blue_where_the_first_is_darker) {
  const std::string a = in_folder("a.exr"), b = in_folder("b.exr"), d = in_folder("d.png");
  Film film(2, 1);
  for (FilmPixel& pixel : film.pixels) pixel = {gray(1), {}, 0, 1};
  pt::write_image(b, film);
  film.set(0, 0, {gray(0.9), {}, 0, 1});
  film.set(1, 0, {gray(1.1), {}, 0, 1});
  pt::write_image(a, film);
  EXPECT_EQ(compare(a + " " + b + " -o " + d).status, 0);
  const Image drawn = pt::read_image(d);
  EXPECT_GT(drawn.at(0, 0).b, drawn.at(0, 0).r);
  EXPECT_LT(drawn.at(1, 0).b, drawn.at(1, 0).r);
}

// Two pictures each, 48 x 48, of which one side is a tenth darker.
TEST_F(Compare, takes_several_pictures_and_says_whether_they_differ) {
  std::mt19937 random(5);
  std::string names[3];
  for (int side = 0; side < 3; ++side) {
    for (int i = 0; i < 2; ++i) {
      const Image image =
          noisy(48, 48, 16, random, [&](int, int) { return side == 2 ? 0.9 : 1.0; });
      Film film(48, 48);
      for (std::size_t k = 0; k < film.pixels.size(); ++k) film.pixels[k].mean = image.pixels[k];
      const std::string file = in_folder(fmt::format("{}{}.exr", side, i));
      pt::write_image(file, film);
      names[side] += (i == 0 ? "" : ",") + file;
    }
  }
  const Said equal = compare(names[0] + " " + names[1]);
  EXPECT_EQ(equal.status, 0) << equal.text;
  EXPECT_NE(equal.text.find("equal    as far as the noise shows"), equal.text.npos) << equal.text;
  const std::string page = in_folder("page.html");
  const Said differ = compare(fmt::format("{} {} --html {}", names[2], names[1], page));
  EXPECT_EQ(differ.status, 1) << differ.text;
  EXPECT_NE(differ.text.find("differ   the whole picture"), differ.text.npos) << differ.text;
  EXPECT_NE(pt::read_file(page).find("wrong: they differ"), std::string::npos);
}

// A tenth darker everywhere: .1 of 1.04. The two pictures beside it have a noise of a hundredth.
TEST_F(Compare, has_the_error_beside_two_pictures) {
  std::mt19937 random(6);
  std::string both;
  for (const char* name : {"b0.exr", "b1.exr"}) {
    const Image image = noisy(48, 48, 40000, random, kEqual);
    Film film(48, 48);
    for (std::size_t k = 0; k < film.pixels.size(); ++k) film.pixels[k].mean = image.pixels[k];
    pt::write_image(in_folder(name), film);
    both += (both.empty() ? "" : ",") + in_folder(name);
  }
  pt::write_image(in_folder("dark.exr"), flat_film(.9, 48, 48));
  const std::string said = compare(in_folder("dark.exr") + " " + both).text;
  const std::size_t at = said.find("\nerror    ");
  ASSERT_NE(at, said.npos) << said;
  EXPECT_NEAR(std::stod(said.substr(at + 10)), 100 * .1 / 1.04, .1) << said;
}

TEST_F(Compare, exits_with_2_for_what_it_cannot_use) {
  const std::string a = in_folder("a.exr"), b = in_folder("b.png"), c = in_folder("c.exr");
  pt::write_image(a, flat_film(1, 4, 4));
  pt::write_image(b, flat_film(1, 4, 4));
  pt::write_image(c, flat_film(1, 4, 5));
  EXPECT_EQ(compare(a + " " + b).status, 0);
  EXPECT_NE(compare(a + " " + b).text.find("verdict  not known"), std::string::npos);
  EXPECT_EQ(compare(a + " " + c).status, 2);
  EXPECT_EQ(compare(a + " missing").status, 2);
  EXPECT_EQ(compare(a).status, 2);
  EXPECT_EQ(compare(a + " " + a + " -o /missing/d.png").status, 2);
  EXPECT_EQ(compare("--help").status, 0);
}

}  // namespace
}  // namespace grader::pictures
