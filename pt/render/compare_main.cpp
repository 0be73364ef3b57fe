#include "pt/command_line.h"
#include "pt/file.h"
#include "pt/image/compare.h"
#include "pt/image/image_io.h"

#include <filesystem>
#include <optional>
#include <string>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

// compare A B [-o difference.png] [--page FOLDER]: prints how far picture A is from picture B, which is assumed to
// be right. Exit code 0 whatever the difference, 2 for input that cannot be used.

namespace {

struct Options {
  std::string a, b, difference;
  std::string page;                        // a folder, or empty
  std::string name_a = "A", name_b = "B";  // on the page
};

std::string described(const pt::Comparison& c) {
  std::string text = fmt::format(
      "MSE      {:.6g}\n"
      "relMSE   {:.6g}   (mean of (A - B)^2 / (B + {:.3g})^2)\n"
      "mean A   {:.6g} {:.6g} {:.6g}\n"
      "mean B   {:.6g} {:.6g} {:.6g}\n",
      c.mse, c.rel_mse, c.dark, c.mean_a.r, c.mean_a.g, c.mean_a.b, c.mean_b.r, c.mean_b.g,
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

std::string described(const std::optional<pt::MeanTest>& test) {
  if (!test) {
    return "z        not known: A or B has pixels without a variance, or that are not finite\n";
  }
  return fmt::format(
      "z        {:.3g}: the mean luminance differs by {:.6g}, with a standard error of {:.3g}\n",
      test->z, test->difference, test->standard_error);
}

// A picture of any format, and its film if the file has one.
struct Read {
  pt::Image image;
  std::optional<pt::Film> film;
};

Read read(const std::string& path) {
  if (!pt::is_exr(path)) return {pt::read_image(path), std::nullopt};
  const pt::Film film = pt::read_exr(path);
  return {mean(film), film};
}

// Writes both pictures and the numbers as a page, which shows difference.png too. The names are words of the
// caller's command.
void write_page(const Options& options, const pt::Image& a, const pt::Image& b,
                const std::string& numbers) {
  const std::filesystem::path folder = options.page;
  std::filesystem::create_directories(folder);
  pt::write_png(folder / "a.png", a);
  pt::write_png(folder / "b.png", b);
  const auto figure = [](const std::string& file, const std::string& words) {
    return fmt::format(
        "<figure><img src=\"{0}.png\" alt=\"{1}\"><figcaption>{1}</figcaption></figure>\n", file,
        words);
  };
  std::string page =
      "<!DOCTYPE html>\n<html lang=\"en\"><meta charset=\"utf-8\">"
      "<meta name=\"viewport\" content=\"width=device-width\"><title>Two codes, one scene</title>\n"
      "<style>:root { color-scheme: light dark; font: 16px/1.5 sans-serif } body { margin: 1rem }\n"
      "main { display: flex; flex-wrap: wrap; gap: 1rem } figure { margin: 0 }\n"
      "img { max-width: 100%; image-rendering: pixelated } pre { overflow-x: auto "
      "}</style>\n<main>\n";
  page += figure("a", "A: " + options.name_a) + figure("b", "B: " + options.name_b);
  page += figure("difference",
                 "The difference in luminance: blue where A is darker, orange where it is "
                 "brighter, full at 20 %");
  page += fmt::format("</main>\n<pre>{}</pre></html>\n", numbers);
  pt::write_file(folder / "index.html", page);
}

void run(const Options& options) {
  const auto [a, film_a] = read(options.a);
  const auto [b, film_b] = read(options.b);
  std::string numbers = described(pt::compare(a, b));
  if (film_a && film_b) numbers += described(pt::compare_means(*film_a, *film_b));
  fmt::print("{}", numbers);
  const pt::Picture difference = pt::difference_picture(a, b);
  if (!options.difference.empty()) {
    pt::write_png(options.difference, difference);
    fmt::print(
        "{}: the difference in luminance, blue where A is darker, orange where it is brighter, "
        "full at 20 %\n",
        options.difference);
  }
  if (options.page.empty()) return;
  write_page(options, a, b, numbers);
  pt::write_png(std::filesystem::path(options.page) / "difference.png", difference);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("How far picture A is from picture B, which is taken for right", "./run compare");
  app.footer(
      "./run compare SCENE.dae [--from student] [--against reference] [RENDER OPTIONS] renders a "
      "scene "
      "with\ntwo codes on the same random numbers, and shows both pictures on a page.");
  Options options;
  app.add_option("A", options.a, "PNG, JPEG, BMP or EXR")->required();
  app.add_option("B", options.b, "the picture to compare with")->required();
  app.add_option("-o,--output", options.difference,
                 "write the signed relative difference to this PNG");
  app.add_option("--page", options.page)->group("");
  app.add_option("--name-a", options.name_a)->group("");
  app.add_option("--name-b", options.name_b)->group("");
  return pt::run_command_line(app, argc, argv, [&] {
    run(options);
    return 0;
  });
}
