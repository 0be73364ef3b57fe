#include "view/worker/disk.h"

#include "pt/geometry/spawn_ray.h"
#include "pt/render/threads.h"
#include "pt/scene/recorder.h"
#include "pt/tasks/direct_hemisphere.h"
#include "pt/tasks/direct_lights.h"
#include "pt/tasks/trace_path.h"
#include "pt/todo.h"
#include "view/worker/json.h"

#include <algorithm>
#include <atomic>
#include <cmath>

namespace view {

namespace {

using Clock = std::chrono::steady_clock;

constexpr int kPasses = 64, kDraws = 20000, kCalls = 256;  // draws and calls: per pass
constexpr std::size_t kMostDots = 400;
constexpr int kBlockSide = 6, kBlocks = kDiskSide / kBlockSide;  // cells in a row of a block
constexpr double kCellSide = 2.0 / kDiskSide;

// The middle of a fraction of a cell, in -1 .. 1. Rows count from the top.
double across(int column, double part) { return (column + part) * kCellSide - 1; }
double up(int row, double part) { return 1 - (row + part) * kCellSide; }

int cell_at(double x, double y) {
  const auto place = [](double part) {
    return std::min(static_cast<int>(part / kCellSide), kDiskSide - 1);
  };
  return place(1 - y) * kDiskSide + place(1 + x);
}

int block_of(int cell) {
  return cell / kDiskSide / kBlockSide * kBlocks + cell % kDiskSide / kBlockSide;
}

pt::Sampler sampler_of(const Disk& disk, int x, int y) {
  return pt::Sampler::for_pixel(disk.seed + (static_cast<std::uint64_t>(disk.passes + 1) << 40), x,
                                y);
}

// The density that diffuse_pdf states, over the part of each cell that lies in the disk.
void find_densities(Disk& disk) {
  constexpr int kParts = 4;
  const pt::Vec3 wo = disk.point.frame.to_local(disk.point.wo);
  for (int i = 0; i < kDiskSide * kDiskSide; ++i) {
    DiskCell& cell = disk.cells[i];
    int inside = 0;
    for (int part = 0; part < kParts * kParts; ++part) {
      const int row = part / kParts, column = part % kParts;
      const pt::Vec3 wi = direction_at(across(i % kDiskSide, (column + 0.5) / kParts),
                                       up(i / kDiskSide, (row + 0.5) / kParts));
      if (!(wi.z > 0)) continue;
      ++inside;
      cell.density += diffuse_pdf(wo, wi) / wi.z;
    }
    cell.inside = static_cast<double>(inside) / (kParts * kParts);
    if (inside > 0) cell.density /= inside;
  }
  // Equal steps of z are equal solid angles. A sum over cells would be poor at the rim.
  constexpr int kSteps = 256;
  disk.stated.resize(kBlocks * kBlocks);
  for (int i = 0; i < kSteps * kSteps; ++i) {
    const int row = i / kSteps, column = i % kSteps;
    const double z = (row + 0.5) / kSteps;
    const double phi = 2 * pt::kPi * (column + 0.5) / kSteps;
    const double r = std::sqrt(1 - z * z), x = r * std::cos(phi), y = r * std::sin(phi);
    const double part = diffuse_pdf(wo, {x, y, z}) * 2 * pt::kPi / (kSteps * kSteps);
    disk.pdf_sum += part;
    disk.stated[block_of(cell_at(x, y))] += part;
  }
}

// The rays of one row: one through each cell.
void trace_row(Disk& disk, const pt::Scene& scene, int row) {
  const pt::SurfacePoint& point = disk.point;
  const pt::Vec3 wo = point.frame.to_local(point.wo);
  pt::PathSettings later = disk.settings;
  later.to = disk.settings.to - 1;
  const bool wants_all = disk.passes > 0 && later.to >= 1;
  double sums[2] = {};
  for (int column = 0; column < kDiskSide; ++column) {
    pt::Sampler sampler = sampler_of(disk, column, row);
    const pt::Vec2 at = sampler.next_2d();
    const pt::Vec3 wi = direction_at(across(column, at.x), up(row, at.y));
    if (!(wi.z > 0)) continue;
    DiskCell& cell = disk.cells[row * kDiskSide + column];
    const pt::Rgb f = diffuse_f(point.albedo, wo, wi);
    const pt::Ray ray = spawn_ray(point, point.frame.to_world(wi));
    const auto hit = scene.closest(ray);
    pt::Rgb emission = background(scene, ray.direction), reflected;
    if (hit) {
      const pt::SurfacePoint met = surface_point(scene, ray, *hit);
      emission = met.emission;
      if (wants_all) reflected = trace_path(scene, met, later, sampler);
    }
    ++cell.samples;
    cell.f += f;
    cell.emission += emission;
    if (wants_all && is_finite(reflected)) {
      ++cell.all_samples;
      cell.reflected += reflected;
    }
    const double area = kCellSide * kCellSide;
    sums[0] += area * luminance(f * emission);
    sums[1] += area * luminance(f * (emission + reflected));
  }
  for (int i = 0; i < 2; ++i) disk.rows[i][row] = sums[i];
}

// Returns whether a ray meets the light that was drawn, so that the rays of the disk have it already.
bool is_met(const pt::Scene& scene, const pt::SurfacePoint& point, const pt::LightSample& sample) {
  if (sample.delta) return false;
  const pt::Ray ray = spawn_ray(point, sample.wi);
  const auto hit = scene.closest(ray);
  return hit && std::abs(hit->t - sample.distance) < 1e-3 * sample.distance &&
         !is_black(surface_point(scene, ray, *hit).emission);
}

// Returns the reflected light of those lights that no ray of the disk meets: they have no size, or no surface.
// It is an estimate from one draw of each.
double light_without_surface(const Disk& disk, const pt::Scene& scene, pt::Sampler& sampler) {
  const pt::SurfacePoint& point = disk.point;
  const pt::Vec3 wo = point.frame.to_local(point.wo);
  double sum = 0;
  for (const pt::Light& light : scene.lights) {
    if (std::holds_alternative<pt::AmbientLight>(light)) continue;
    const pt::LightSample sample = sample_light(light, point.p, sampler);
    if (is_black(sample.radiance) || is_met(scene, point, sample)) continue;
    const pt::Vec3 wi = point.frame.to_local(sample.wi);
    const double seen = scene.occluded(shadow_ray(point, sample.wi, sample.distance)) ? 0 : 1;
    const double weight = seen * std::max(wi.z, 0.0) / sample.pdf;
    sum += weight * luminance(diffuse_f(point.albedo, wo, wi) * sample.radiance);
  }
  return sum;
}

Drawn::Kind kind_of(const Draw& draw) {
  if (!draw.was_traced) return Drawn::Kind::not_traced;
  const bool is_dark = draw.is_hidden || is_black(draw.sample.radiance);
  return is_dark ? Drawn::Kind::dark : Drawn::Kind::lit;
}

void call_direct(Disk& disk, const pt::Scene& scene, pt::Sampler& sampler) {
  const bool by_hemisphere = disk.settings.direct == pt::PathSettings::Direct::hemisphere;
  std::vector<pt::Call> calls;
  pt::recorder.calls = &calls;
  const auto task = by_hemisphere ? pt::direct_hemisphere : pt::direct_lights;
  const pt::Rgb light = task(scene, disk.point, disk.settings.light_samples, sampler);
  pt::recorder.calls = nullptr;
  if (is_finite(light)) disk.direct.returned.add(luminance(light));
  if (calls.empty()) return;
  for (const Draw& draw : direct_of(scene, calls, 0).draws) {
    disk.by_direct.add({disk.point.frame.to_local(draw.sample.wi), kind_of(draw)});
  }
}

// After the rays of a pass: what the tasks do at this point.
void call_tasks(Disk& disk, const pt::Scene& scene) {
  pt::Sampler sampler = sampler_of(disk, kDiskSide, kDiskSide);
  const pt::Vec3 wo = disk.point.frame.to_local(disk.point.wo);
  for (int i = 0; i < kDraws; ++i) {
    disk.by_bsdf.add({diffuse_sample(disk.point.albedo, wo, sampler).wi});
  }
  for (int i = 0; i < kCalls; ++i) {
    call_direct(disk, scene, sampler);
    if (disk.settings.to < 2) continue;
    const pt::Rgb light = trace_path(scene, disk.point, disk.settings, sampler);
    if (is_finite(light)) disk.all.returned.add(luminance(light));
  }
}

void end_pass(Disk& disk, const pt::Scene& scene) {
  call_tasks(disk, scene);
  const bool by_lights = disk.settings.direct == pt::PathSettings::Direct::lights;
  pt::Sampler sampler = sampler_of(disk, 0, kDiskSide);
  const double more = by_lights ? light_without_surface(disk, scene, sampler) : 0;
  double sums[2] = {more, more};
  for (int i = 0; i < 2; ++i) {
    for (const double row : disk.rows[i]) sums[i] += row;
  }
  disk.direct.disk.add(sums[0]);
  if (disk.passes > 0 && disk.settings.to >= 2) disk.all.disk.add(sums[1]);
  ++disk.passes;
  disk.next_row = 0;
}

nlohmann::json to_json(const Balance& balance) {
  const auto both = [](const Mean& mean) {
    return nlohmann::json{view::to_json(mean.mean), view::to_json(mean.error()), mean.count};
  };
  return {{"returned", both(balance.returned)}, {"disk", both(balance.disk)}};
}

nlohmann::json to_json(const Drawn& drawn) {
  nlohmann::json dots = nlohmann::json::array();
  const auto shorter = [](double value) { return view::to_json(std::round(value * 1e4) / 1e4); };
  for (const Drawn::Dot& dot : drawn.dots) {
    dots.push_back({shorter(dot.local.x), shorter(dot.local.y), shorter(dot.local.z),
                    static_cast<int>(dot.kind)});
  }
  return {{"count", drawn.count}, {"below", drawn.below}, {"dots", std::move(dots)}};
}

}  // namespace

pt::Vec3 direction_at(double x, double y) {
  return {x, y, std::sqrt(std::max(0.0, 1 - x * x - y * y))};
}

void Mean::add(double value) {
  ++count;
  const double distance = value - mean;
  mean += distance / static_cast<double>(count);
  squares += distance * (value - mean);
}

double Mean::error() const {
  const auto n = static_cast<double>(count);
  return count > 1 ? std::sqrt(squares / (n - 1) / n) : pt::kInfinity;
}

void Drawn::add(const Dot& dot) {
  ++count;
  if (!(dot.local.z > 0)) ++below;
  if (dots.size() < kMostDots) dots.push_back(dot);
  const bool is_in_disk = dot.local.z > 0 && std::hypot(dot.local.x, dot.local.y) <= 1;
  if (!is_in_disk) return;
  ++in_cell[cell_at(dot.local.x, dot.local.y)];
}

double elsewhere(const Disk& disk) {
  std::vector<double> apart = disk.stated;
  const auto count = static_cast<double>(std::max(disk.by_bsdf.count, 1LL));
  double in_disk = 0, sum = 0;
  for (int cell = 0; cell < kDiskSide * kDiskSide; ++cell) {
    apart[block_of(cell)] -= disk.by_bsdf.in_cell[cell] / count;
    in_disk += disk.by_bsdf.in_cell[cell] / count;
  }
  for (const double part : apart) sum += std::abs(part);
  return (sum + 1 - in_disk) / 2;
}

Disk begin_disk(const pt::SurfacePoint& point, const Settings& settings, int bounces_before) {
  Disk disk{point, path_settings(settings.render), settings.render.seed, settings.render.threads};
  disk.settings.from = 1;
  const bool has_paths = !pt::todo_reached("trace_path");
  disk.settings.to = has_paths ? std::max(1, settings.render.bounces - bounces_before) : 1;
  for (auto& rows : disk.rows) rows.resize(kDiskSide);
  find_densities(disk);
  return disk;
}

bool improve(Disk& disk, const pt::Scene& scene, std::chrono::milliseconds time) {
  if (disk.passes >= kPasses) return false;
  const auto start = Clock::now();
  std::atomic<int> next = disk.next_row;
  pt::in_threads(disk.threads, [&](int) {
    while (Clock::now() - start < time) {
      const int row = next++;
      if (row >= kDiskSide) break;
      trace_row(disk, scene, row);
    }
  });
  disk.next_row = std::min(next.load(), kDiskSide);
  if (disk.next_row == kDiskSide) end_pass(disk, scene);
  return disk.passes < kPasses;
}

std::vector<float> layers_of(const Disk& disk) {
  constexpr std::size_t kCells = static_cast<std::size_t>(kDiskSide) * kDiskSide;
  std::vector<float> layers(kDiskLayers * kCells);
  for (std::size_t i = 0; i < kCells; ++i) {
    const DiskCell& cell = disk.cells[i];
    const auto put = [&](int layer, double value) {
      layers[layer * kCells + i] = static_cast<float>(value);
    };
    const auto put_mean = [&](int layer, pt::Rgb sum, int count) {
      for (int c = 0; c < 3; ++c) put(layer + c, count > 0 ? sum[c] / count : 0);
    };
    const auto put_drawn = [&](int layer, const Drawn& drawn) {
      const double area = cell.inside * kCellSide * kCellSide;
      const bool is_told = area > 0 && drawn.count > 0;
      put(layer, is_told ? drawn.in_cell[i] / (area * static_cast<double>(drawn.count)) : 0);
    };
    put_mean(0, cell.emission, cell.samples);
    put_mean(3, cell.reflected, cell.all_samples);
    put_mean(6, cell.f, cell.samples);
    put(9, cell.density);
    put_drawn(10, disk.by_bsdf);
    put_drawn(11, disk.by_direct);
  }
  return layers;
}

nlohmann::json to_json(const Disk& disk) {
  const bool by_hemisphere = disk.settings.direct == pt::PathSettings::Direct::hemisphere;
  return {{"side", kDiskSide},
          {"passes", disk.passes},
          {"bounces", disk.settings.to},
          {"task", by_hemisphere ? "direct_hemisphere" : "direct_lights"},
          {"pdf_sum", to_json(disk.pdf_sum)},
          {"elsewhere", to_json(elsewhere(disk))},
          {"direct", to_json(disk.direct)},
          {"all", disk.settings.to < 2 ? nlohmann::json() : to_json(disk.all)},
          {"by_bsdf", to_json(disk.by_bsdf)},
          {"by_direct", to_json(disk.by_direct)}};
}

}  // namespace view
