#include "pt/render/radiance_apart.h"

#include "pt/render/common_radiance.h"
#include "pt/render/pixel_record.h"

#include <set>

namespace pt {

namespace {

// The ranges of the last call, cut into pieces. They are the same for many pixels.
struct Cut {
  std::vector<BounceRange> ranges, pieces;
};

const std::vector<BounceRange>& pieces_for(const std::vector<BounceRange>& ranges) {
  static thread_local Cut cut;
  if (cut.ranges != ranges) cut = {ranges, pieces_of(ranges)};
  return cut.pieces;
}

// One sample split by bounces: emission, and each piece.
struct Sample {
  Rgb emission;
  BouncesApart path;

  Rgb sum() const { return emission + path.sum; }
};

Sample take(const Scene& scene, const Ray& ray, const PathSettings& settings, Sampler& sampler,
            const std::vector<BounceRange>& pieces) {
  Sample sample{{}, {{}, std::vector<Rgb>(pieces.size()), true}};
  const std::optional<Hit> hit = scene.closest(ray);
  if (!hit) return sample;
  const SurfacePoint point = surface_point(scene, ray, *hit);
  sample.emission = point.emission;
  if (settings.to >= 1) {
    sample.path = trace_path_apart(scene, point, settings, pieces, sampler);
  }
  return sample;
}

void enter(const Sample& sample, const std::vector<BounceRange>& pieces, ApartRecord& record) {
  for (std::size_t i = 0; i < record.ranges.size(); ++i) {
    const BounceRange& range = record.ranges[i];
    Rgb sum;
    if (range.from <= 0) sum += sample.emission;
    for (std::size_t k = 0; k < pieces.size(); ++k) {
      if (range.from <= pieces[k].from && pieces[k].to <= range.to) sum += sample.path.ranges[k];
    }
    record.moments[i].add(sum);
  }
}

}  // namespace

ApartRecord& apart_record() {
  static thread_local ApartRecord record;
  return record;
}

std::vector<BounceRange> pieces_of(std::span<const BounceRange> ranges) {
  std::set<int> cuts{1};
  for (const BounceRange& range : ranges) cuts.insert({range.from, range.to + 1});
  std::vector<BounceRange> pieces;
  for (auto cut = cuts.lower_bound(1); std::next(cut) != cuts.end(); ++cut) {
    pieces.push_back({*cut, *std::next(cut) - 1});
  }
  return pieces;
}

Rgb radiance(const Scene& scene, const Ray& ray, const PathSettings& settings, Sampler& sampler) {
  ApartRecord& record = apart_record();
  if (record.ranges.empty()) return recorded(common_radiance(scene, ray, settings, sampler));
  const std::vector<BounceRange>& pieces = pieces_for(record.ranges);
  const Sample sample = take(scene, ray, settings, sampler, pieces);
  if (!is_finite(sample.sum())) return recorded(sample.sum());
  record.complete = record.complete && sample.path.complete;
  enter(sample, pieces, record);
  return recorded(sample.sum());
}

}  // namespace pt
