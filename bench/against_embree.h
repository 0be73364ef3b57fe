#pragma once

#include "bench/goals.h"

#include <string>
#include <vector>

namespace pt {

// The effort of the benchmark, and the place of its files.
struct BenchSettings {
  std::string folder = ".";  // of the CSV files
  int rounds = 7;            // of which medians are taken
  int rays = 100000;         // of each kind
  int width = 480;           // of the pictures; the height is three quarters of it
  int samples = 16;          // camera rays per pixel
};

// Single rays, each kind, ours and Embree's by turns, on blobs of so many triangles and in scene
// files: a table on the terminal, and rays.csv. Also build time, memory, and float against double.
std::vector<Goal> compare_rays(const BenchSettings& settings, const std::vector<int>& blobs,
                               const std::vector<std::string>& files);

// Whole pictures, on one thread by us and by Embree, then on more: renders.csv. A scene is a file,
// or a blob given by its number of triangles, whose pictures are half as wide. Goals are of files.
std::vector<Goal> compare_renders(const BenchSettings& settings,
                                  const std::vector<std::string>& scenes);

}  // namespace pt
