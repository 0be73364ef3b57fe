#include "pt/command_line.h"
#include "pt/image/compare.h"
#include "pt/image/image_io.h"

#include <cstdio>
#include <optional>
#include <string>

#include <CLI/CLI.hpp>

// compare A B [-o difference.png]: prints how far picture A is from picture B, which is assumed to
// be right. Exit code 0 whatever the difference, 2 for input that cannot be used.

namespace {

void print(const pt::Comparison& c) {
  std::printf("MSE      %.6g\n", c.mse);
  std::printf("relMSE   %.6g   (mean of (A - B)^2 / (B + %.3g)^2)\n", c.rel_mse, c.dark);
  std::printf("mean A   %.6g %.6g %.6g\n", c.mean_a.r, c.mean_a.g, c.mean_a.b);
  std::printf("mean B   %.6g %.6g %.6g\n", c.mean_b.r, c.mean_b.g, c.mean_b.b);
  if (c.largest.a != c.largest.b) {
    std::printf("largest  %.6g at x %d, y %d (from the top left), channel %c: A %.6g, B %.6g\n",
                c.largest.a - c.largest.b, c.largest.x, c.largest.y, "rgb"[c.largest.channel],
                c.largest.a, c.largest.b);
  } else {
    std::printf("largest  0: all pixels are equal\n");
  }
  if (c.not_finite > 0) {
    std::printf("left out %zu pixels that are not finite in A or B\n", c.not_finite);
  }
}

void print_means(const std::optional<pt::MeanTest>& test) {
  if (!test) {
    std::printf(
        "z        not known: A or B has pixels without a variance, or that are not finite\n");
    return;
  }
  std::printf("z        %.3g: the mean luminance differs by %.6g, with a standard error of %.3g\n",
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

void run(const std::string& path_a, const std::string& path_b, const std::string& output) {
  const auto [a, film_a] = read(path_a);
  const auto [b, film_b] = read(path_b);
  print(pt::compare(a, b));
  if (film_a && film_b) print_means(pt::compare_means(*film_a, *film_b));
  if (output.empty()) return;
  pt::write_png(output, pt::difference_picture(a, b));
  std::printf(
      "%s: the difference in luminance, blue where A is darker, orange where it is brighter, "
      "full at 20 %%\n",
      output.c_str());
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("How far picture A is from picture B, which is taken for right", "./run compare");
  std::string a, b, output;
  app.add_option("A", a, "PNG, JPEG, BMP or EXR")->required();
  app.add_option("B", b, "the picture to compare with")->required();
  app.add_option("-o,--output", output, "write the signed relative difference to this PNG");
  return pt::run_command_line(app, argc, argv, [&] {
    run(a, b, output);
    return 0;
  });
}
