// compare A B: prints how far picture A is from picture B, and where the noise of both is known, whether they differ. The exit status is 1 if they
// do, 0 if not or if nobody knows, 2 for input that cannot be used.
#include "pt/image/compare.h"

#include "grader/pictures/statistics/flip.h"
#include "grader/pictures/statistics/welch.h"
#include "grader/report/side_by_side.h"
#include "pt/command_line.h"
#include "pt/error.h"
#include "pt/file.h"
#include "pt/image/accuracy.h"
#include "pt/image/image_io.h"
#include "pt/math/uncertain.h"

#include <cmath>
#include <filesystem>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace {

using namespace grader;
using pictures::BlockDifference;

struct Options {
  std::string a, b, difference, page;
  std::string name_a, name_b;  // on the page; empty: the files' names
  bool same_numbers = false;   // both pictures come from the same random numbers
};

std::string described(const pt::Comparison& c, double flip) {
  std::string text = fmt::format(
      "MSE      {:.6g}\n"
      "relMSE   {:.6g}   (mean of (A - B)^2 / (B + {:.3g})^2)\n"
      "FLIP     {:.4g}   (what an eye sees of it on a screen, from 0 to 1: Andersson et al. 2020)\n"
      "mean A   {:.6g} {:.6g} {:.6g}\n"
      "mean B   {:.6g} {:.6g} {:.6g}\n",
      c.mse, c.rel_mse, c.dark, flip, c.mean_a.r, c.mean_a.g, c.mean_a.b, c.mean_b.r, c.mean_b.g,
      c.mean_b.b);
  if (c.largest.a != c.largest.b) {
    text += fmt::format(
        "largest  {:.6g} at x {}, y {} (from the top left), channel {}: A {:.6g}, B {:.6g}\n",
        c.largest.a - c.largest.b, c.largest.x, c.largest.y, "rgb"[c.largest.channel], c.largest.a,
        c.largest.b);
  } else {
    text += "largest  0: all pixels are equal\n";
  }
  if (c.not_finite > 0) {
    text += fmt::format("left out {} pixels that are not finite in A or B\n", c.not_finite);
  }
  return text;
}

// A picture of any format, and its noise if the file or several files show it.
struct Side {
  pt::Image image;
  std::optional<pictures::NoisyPicture> noisy;
  std::vector<pt::Image> images;  // of several files
};

// The mean luminance of every second of the images.
std::vector<double> half_of(const std::vector<pt::Image>& images, std::size_t first) {
  std::vector<double> sum(images[first].pixels.size());
  const std::size_t count = (images.size() - first + 1) / 2;
  for (std::size_t k = first; k < images.size(); k += 2) {
    for (std::size_t i = 0; i < sum.size(); ++i) {
      sum[i] += pt::luminance(images[k].pixels[i]) / static_cast<double>(count);
    }
  }
  return sum;
}

// The error of A where B is several pictures, which are two goldens; "" where it is not known.
std::string error_beside(const Side& a, const Side& b) {
  if (b.images.size() < 2) return "";
  const pt::Accuracy accuracy =
      pt::accuracy_of(half_of({a.image}, 0), {}, {half_of(b.images, 0), half_of(b.images, 1)});
  if (!std::isfinite(accuracy.error.value)) return "";
  return fmt::format(
      "error    {:.3g} \u00b1 {:.2g} %   (root of relMSE in luminance, without the noise of B)\n",
      100 * accuracy.error.value, 100 * accuracy.error.error);
}

bool has_variance(const pt::Film& film) {
  for (const pt::FilmPixel& pixel : film.pixels) {
    if (pixel.samples < 2 || !is_finite(pixel.mean)) return false;
  }
  return !film.pixels.empty();
}

// One file, or several with commas between them.
Side read(const std::string& words) {
  std::vector<pt::Image> images;
  std::istringstream names(words);
  std::string name;
  while (std::getline(names, name, ',')) images.push_back(pt::read_image(name));
  if (images.size() > 1) {
    pictures::NoisyPicture noisy = pictures::noisy_picture(images);
    return {noisy.mean, noisy, images};
  }
  if (!pt::is_exr(words)) return {images.at(0), std::nullopt, {}};
  const pt::Film film = pt::read_exr(words);
  if (!has_variance(film)) return {images[0], std::nullopt, {}};
  return {images[0], pictures::noisy_picture(film, words), {}};
}

std::string place_of(const BlockDifference& block) {
  if (block.side == 0) return "the whole picture";
  return fmt::format("the {} x {} pixels from x {}, y {} (from the top left)", block.width,
                     block.height, block.x, block.y);
}

std::string described(const BlockDifference& block) {
  return fmt::format("{} is {:.2g} % {} in A (a chance of {:.1g} if there were no difference)",
                     place_of(block), 100 * std::abs(block.off_by),
                     block.off_by < 0 ? "darker" : "brighter", block.p);
}

std::string described(const pictures::WelchTest& test) {
  if (!test.differing.empty()) {
    const BlockDifference& worst = test.differing[0];
    const BlockDifference& whole = test.blocks.back();
    std::string text = "differ   ";
    if (worst.side != 0 && whole.p < pictures::kWelchLevel / pictures::kWelchSides.size()) {
      text += described(whole) + "\n         ";
    }
    return text + described(worst) + "\n";
  }
  std::vector<double> found;
  for (const BlockDifference& block : test.blocks) {
    if (block.side == 24) found.push_back(block.would_be_found);
  }
  return fmt::format(
      "equal    as far as the noise shows: {:.2g} % of the whole picture would have been found "
      "nine "
      "times of ten, and {:.2g} % of a block of 24 x 24\n",
      100 * test.blocks.back().would_be_found, 100 * pt::median_of(found));
}

int run(const Options& options) {
  const Side a = read(options.a), b = read(options.b);
  const pt::Comparison comparison = pt::compare(a.image, b.image);  // they have one size
  std::string numbers =
      described(comparison, pictures::flip(a.image, b.image)) + error_beside(a, b);
  std::string verdict;
  if (!options.same_numbers && a.noisy && b.noisy) {
    const pictures::WelchTest test = pictures::welch_test(*a.noisy, *b.noisy);
    numbers += described(test);
    verdict = test.differing.empty() ? "agrees" : "wrong";
  } else if (!options.same_numbers) {
    numbers +=
        "verdict  not known: A or B is one picture without variances; give several with commas, or "
        "EXRs of ./run render\n";
  }
  fmt::print("{}", numbers);
  if (!options.difference.empty()) {
    pt::write_png(options.difference, pt::difference_picture(a.image, b.image));
    fmt::print(
        "{}: the difference in luminance, blue where A is darker, orange where it is brighter, "
        "full at 20 %\n",
        options.difference);
  }
  if (!options.page.empty()) {
    const auto name = [](const char* letter, const std::string& given, const std::string& file) {
      return fmt::format("{}: {}", letter, given.empty() ? file : given);
    };
    pt::write_file(
        options.page,
        report::side_by_side_page(
            "Two pictures",
            {{"", verdict == "wrong" ? "wrong: they differ" : verdict, numbers, a.image, b.image,
              name("A", options.name_a, options.a), name("B", options.name_b, options.b),
              pt::difference_map(a.image, b.image),
              "The difference in luminance: blue where A is darker, orange where it is brighter, "
              "full at 20 %"}},
            ""));
    fmt::print("{}\n", options.page);
  }
  return verdict == "wrong" ? 1 : 0;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("How far picture A is from picture B, and whether they differ by more than noise",
               "./run compare");
  app.footer(
      "A and B are files, or each several pictures of one scene with commas between them (A1,A2 "
      "B1,B2). The noise is known of\n"
      "several, and of an EXR of ./run render. The error of A is known where B is several "
      "pictures.\n\n"
      "./run compare SCENE.dae [--from student] [--against reference] [RENDER OPTIONS] renders a "
      "scene with\n"
      "two codes on the same random numbers, and shows both pictures on a page.");
  Options options;
  app.add_option("A", options.a, "PNG, JPEG, BMP, EXR, HDR or PFM")->required();
  app.add_option("B", options.b, "the picture to compare with")->required();
  app.add_option("-o,--output", options.difference,
                 "write the signed relative difference to this PNG");
  app.add_option("--html", options.page, "write a page with both pictures");
  app.add_option("--name-a", options.name_a)->group("");
  app.add_option("--name-b", options.name_b)->group("");
  app.add_flag("--same-numbers", options.same_numbers)->group("");
  return pt::run_command_line(app, argc, argv, [&] { return run(options); });
}
