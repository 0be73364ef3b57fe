#pragma once

#include "view/worker/path.h"

#include <array>
#include <chrono>
#include <vector>

#include <nlohmann/json.hpp>

namespace view {

// The directions above a point as a disk: the direction (x, y, z) of the point's frame, z along the normal, is at (x, y) (Nusselt
// 1928). An area of the disk is the integral of the cosine over its directions. So reflected light is the integral of f L over
// the disk, and a density of cos / pi is uniform there.
inline constexpr int kDiskSide =
    72;  // cells in a row and in a column; the top row has the largest y

// The direction through the point (x, y) of the square -1 .. 1 around the disk; outside the disk its z is 0.
pt::Vec3 direction_at(double x, double y);

// The mean of numbers that come one after the other.
struct Mean {
  long long count = 0;
  double mean = 0;
  double squares = 0;  // sum of the squared differences from the mean

  void add(double value);
  double error() const;  // the standard error
};

// What is known of the directions through a cell.
struct DiskCell {
  int samples = 0, all_samples = 0;  // rays; those that looked for all light
  pt::Rgb emission;                  // that arrives: the sum over the samples
  pt::Rgb reflected;                 // other light that arrives: the sum over all_samples
  pt::Rgb f;                         // of diffuse_f: the sum over the samples
  double inside = 0;                 // the part of the cell that lies in the disk
  double density = 0;                // of diffuse_pdf, per area of the disk
};

// Directions that a task has drawn.
struct Drawn {
  enum class Kind {
    lit,
    dark,
    not_traced
  };  // whether light comes from there, as the task has found
  struct Dot {
    pt::Vec3 local;
    Kind kind = Kind::lit;
  };
  long long count = 0, below = 0;  // below: the surface
  std::vector<Dot> dots{};         // the first ones
  std::vector<int> in_cell = std::vector<int>(kDiskSide * kDiskSide);

  void add(const Dot& dot);
};

// Luminances: of what a task returned for the point, and of the light that reaches the disk, times f.
struct Balance {
  Mean returned, disk;
};

struct Disk {
  pt::SurfacePoint point;
  pt::PathSettings settings;  // `to`: the bounces that are left at the point
  std::uint64_t seed = 0;
  int threads = 1;

  std::vector<DiskCell> cells = std::vector<DiskCell>(kDiskSide * kDiskSide);
  std::vector<double> stated{};  // the integral of diffuse_pdf over the directions of each block
  double pdf_sum = 0;            // the integral of diffuse_pdf over the directions above the point
  Drawn by_bsdf{}, by_direct{};  // by diffuse_sample; by direct_lights or direct_hemisphere
  Balance direct{}, all{};       // emission, and direct light; all light, and trace_path
  int passes = 0, next_row = 0;  // complete ones; of the pass that is not
  std::vector<double> rows[2] = {};  // what the rows of this pass reflect: emission; all light
};

// `bounces_before` counts the points of the path before this one.
Disk begin_disk(const pt::SurfacePoint& point, const Settings& settings, int bounces_before);

// The part of the directions of diffuse_sample that would have to go elsewhere to agree with diffuse_pdf, by blocks of cells.
double elsewhere(const Disk& disk);

// Goes on for about this time, and at most to the end of a pass. Returns false if there is nothing left to do.
bool improve(Disk& disk, const pt::Scene& scene, std::chrono::milliseconds time);

// Numbers of the cells, one layer after the other: emission (r of all cells, then g, then b), other light, f, the density that
// diffuse_pdf states, those of the directions drawn by diffuse_sample and for direct light.
inline constexpr int kDiskLayers = 12;
std::vector<float> layers_of(const Disk& disk);

nlohmann::json to_json(const Disk& disk);

}  // namespace view
