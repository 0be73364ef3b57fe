#pragma once

#include "bench/report.h"

#include <string>
#include <vector>

namespace pt {

// The effort of the benchmark, and the place of its files.
struct BenchSettings {
  std::string folder = ".";  // for the CSV files
  int rounds = 7;            // medians are taken over them
  int rays = 100000;         // per kind
  int width = 480;           // pixels; a picture is three quarters as high
  int samples = 16;          // camera rays per pixel
};

// Measures rays of each kind, ours and Embree's in turns, on blobs with these numbers of triangles and
// in scene files. Prints a table and writes rays.csv. Also: build time and memory.
std::vector<Goal> compare_rays(const BenchSettings& settings, const std::vector<int>& blobs,
                               const std::vector<std::string>& files);

// Renders whole pictures with our rays and with Embree's on one thread, then on more: renders.csv. A scene
// is a file, or the number of triangles of a blob, whose pictures are half as wide. Only files have goals.
std::vector<Goal> compare_renders(const BenchSettings& settings,
                                  const std::vector<std::string>& scenes);

}  // namespace pt
