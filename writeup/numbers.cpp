#include "writeup/figure.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace writeup {

std::string factor_text(double value, double error) {
  if (error == 0) return digits(value) + "\u00d7";
  const int places = std::clamp(static_cast<int>(std::ceil(-std::log10(error))), 0, 4);
  return fmt::format("{:.{}f} \u00b1 {:.{}f}\u00d7", value, places, error, places);
}

namespace {

using Words = std::vector<std::string>;

void add(Words& names, const std::string& before, const Words& ends) {
  for (const std::string& end : ends) names.push_back(before + end);
}

// All methods, also those that make no sense in some scene.
const Words kMethods{"l1",  "l2",  "l4",  "l8",   "l16",      "l32",  "h1",   "h8",    "h32",
                     "p30", "p50", "p85", "p100", "adaptive", "wide", "task", "linear"};

Words of_converge() {
  Words names{"fastest"};
  for (const std::string& method : kMethods) {
    add(names, method, {".time", ".slope", ".error"});
    for (const std::string& other : kMethods) {
      add(names, method + ".beside." + other, {".time", ".error", ".rays"});
    }
  }
  return names;
}

Words of_scene_needs() {
  Words names{"a",
              "b",
              "c0",
              "c1",
              "best_light_samples",
              "measured_light_samples",
              "off_the_line",
              "off_the_time_line",
              "error"};
  for (int m = 0; m <= 16; ++m) names.push_back('m' + std::to_string(m));
  return names;
}

}  // namespace

std::vector<std::string> number_names(const Figure& figure) {
  if (figure.kind == "converge") return of_converge();
  if (figure.kind == "scene_needs") return of_scene_needs();
  if (figure.kind == "rules") {
    Words names{"samples"};
    for (const char* rule : {"contract", "uniform", "no_black", "root", "neighbours"}) {
      add(names, rule, {".error", ".median", ".most", ".largest", ".on_black"});
    }
    return names;
  }
  if (figure.kind == "path") {
    return {"paths",  "points",   "x",      "y",      "direct",    "indirect",
            "result", "is_exact", "lights", "hidden", "throughput"};
  }
  if (figure.kind == "ray") {
    return {"boxes",  "missed", "opened", "behind", "leaves", "primitives", "primitives_of_all",
            "levels", "t",      "x",      "y"};
  }
  Words names;
  for (const std::string& line : figure.lines) {
    add(names, line, {".fails", ".first", ".last", ".largest", ".from", ".to"});
  }
  for (const Price& price : figure.prices) add(names, price.id, {".time", ".work"});
  for (const std::string& scene : figure.scenes) {
    if (figure.kind == "speedup") {
      add(names, scene, {"", ".linear", ".tree", ".linear_tests", ".tests", ".triangles", ".name"});
    } else {
      add(names, scene,
          {".samples", ".light_samples", ".bounces", ".seconds", ".surfaces", ".course",
           ".hemisphere", ".no_roulette", ".adaptive", ".no_tree", ".smooth"});
    }
  }
  for (const Picture& picture : figure.pictures) {
    names.push_back(picture.id + ".name");
    add(names, picture.id,
        {".seconds",       ".samples",      ".rays",       ".mean",          ".average",
         ".median",        ".most",         ".ratio",      ".error",         ".factor",
         ".bias",          ".pixel_median", ".pixel_most", ".pixel_largest", ".black_pixels",
         ".black_samples", ".lamp",         ".triangles",  ".batch",         ".tolerance",
         ".error_pm",      ".factor_pm",    ".noise",      ".bias_pm",       ".wrong"});
  }
  return names;
}

}  // namespace writeup
