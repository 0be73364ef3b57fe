#include "bench/against_embree.h"
#include "bench/embree.h"
#include "bench/report.h"
#include "bench/test_scenes.h"
#include "pt/accel/wide_bvh.h"
#include "pt/render/cpu_time.h"

#include <cmath>
#include <cstdio>

namespace pt {
namespace {

volatile long long sink;  // keeps the timed code from being optimised away

// Embree's rays are converted beforehand, and copied because a query writes into them.
struct EmbreeRays {
  const EmbreeScene& scene;
  const std::vector<Ray>& from;
  std::vector<RTCRay> rays;

  EmbreeRays(const EmbreeScene& embree, const std::vector<Ray>& these)
      : scene(embree), from(these) {
    for (const Ray& ray : from) rays.push_back(scene.convert(ray));
  }
  // Like our query, it computes the normal at the hit.
  void closest(const Primitives& primitives) const {
    long long hits = 0;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    for (std::size_t i = 0; i < rays.size(); ++i) {
      RTCRayHit query;
      query.ray = rays[i];
      query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
      rtcIntersect1(scene.handle(), &context, &query);
      hits += scene.hit_of(primitives, from[i], query).has_value();
    }
    sink = hits;
  }
  void occluded() const {
    long long hits = 0;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    for (RTCRay ray : rays) {
      rtcOccluded1(scene.handle(), &context, &ray);
      hits += ray.tfar < 0;
    }
    sink = hits;
  }
};

struct Ours {
  const Primitives& primitives;
  const WideBvh& bvh;

  void closest(const std::vector<Ray>& rays) const {
    long long hits = 0;
    for (const Ray& ray : rays) hits += bvh.closest(primitives, ray).has_value();
    sink = hits;
  }
  void occluded(const std::vector<Ray>& rays) const {
    long long hits = 0;
    for (const Ray& ray : rays) hits += bvh.occluded(primitives, ray);
    sink = hits;
  }
  void occluded_by_groups(const std::vector<Ray>& rays) const {
    long long hits = 0;
    const std::span<const Ray> all(rays);
    for (std::size_t i = 0; i + kShadowGroup <= rays.size(); i += kShadowGroup) {
      hits += __builtin_popcount(bvh.occluded(primitives, all.subspan(i, kShadowGroup)));
    }
    sink = hits;
  }
};

struct Line {
  const char* kind;
  double ours;  // seconds, medians
  double embree;
  Ratio ratio;  // times Embree
};

Line line(const char* kind, const std::vector<double>& ours, const std::vector<double>& embree) {
  return {kind, median(ours), median(embree), ratio(embree, ours)};
}

// The results of one scene for which there are goals.
struct Result {
  struct Line {
    std::string kind;
    double nanoseconds;  // per ray
    double ratio;        // times Embree
  };
  std::string scene;
  int primitives;
  double bytes;  // per primitive
  std::vector<Line> lines;
};

// The costs of a tree.
struct TreeCosts {
  double seconds;
  double bytes;  // per primitive
};

// Prints the line, and adds it to the file.
void report(const TestScene& test, const Line& line, double million, const TreeCosts& ours,
            const TreeCosts& embree, Csv& csv) {
  std::printf("  %-10s %6.2f M/s   Embree %6.2f M/s   ratio %.2f (%.2f to %.2f)\n", line.kind,
              million / line.ours, million / line.embree, line.ratio.median, line.ratio.least,
              line.ratio.most);
  char row[300];
  std::snprintf(row, sizeof row, "%s,%d,%s,%.4g,%.4g,%.3f,%.4g,%.4g,%.1f,%.1f,%.3f,%.3f",
                test.name.c_str(), test.scene.primitives.size(), line.kind,
                1e3 * line.ours / million, 1e3 * line.embree / million, line.ratio.median,
                1e3 * ours.seconds, 1e3 * embree.seconds, ours.bytes, embree.bytes,
                line.ratio.least, line.ratio.most);
  csv.row(row);
}

Result compare(TestScene& test, const BenchSettings& settings, Csv& csv) {
  const Primitives& primitives = test.scene.primitives;
  double start = thread_cpu_seconds();
  const WideBvh bvh = WideBvh::build(primitives);
  const TreeCosts costs{thread_cpu_seconds() - start,
                        static_cast<double>(bvh.bytes()) / primitives.size()};
  start = thread_cpu_seconds();
  const EmbreeScene embree(primitives);
  const TreeCosts costs_embree{thread_cpu_seconds() - start,
                               static_cast<double>(embree.bytes()) / primitives.size()};
  std::printf("%s: %d primitives; build %.1f ms, Embree %.1f; bytes each %.0f, Embree %.0f\n",
              test.name.c_str(), primitives.size(), 1e3 * costs.seconds, 1e3 * costs_embree.seconds,
              costs.bytes, costs_embree.bytes);

  test.scene.tracer = Tracer(Engine::wide, primitives);
  const RaySets rays = make_rays(test, settings.rays);
  const EmbreeRays primary(embree, rays.primary), bounce(embree, rays.bounce);
  const EmbreeRays shadow(embree, rays.shadow);
  const Ours ours{primitives, bvh};
  const auto seconds =
      interleave({[&] { ours.closest(rays.primary); }, [&] { primary.closest(primitives); },
                  [&] { ours.closest(rays.bounce); }, [&] { bounce.closest(primitives); },
                  [&] { ours.occluded(rays.shadow); }, [&] { shadow.occluded(); },
                  [&] { ours.occluded_by_groups(rays.shadow); }},
                 settings.rounds);
  const std::size_t counts[] = {rays.primary.size(), rays.bounce.size(), rays.shadow.size(),
                                rays.shadow.size()};
  const Line lines[] = {
      line("camera", seconds[0], seconds[1]), line("bounce", seconds[2], seconds[3]),
      line("shadow", seconds[4], seconds[5]), line("shadow x8", seconds[6], seconds[5])};
  Result result{test.name, primitives.size(), costs.bytes, {}};
  for (int i = 0; i < 4; ++i) {
    const Line& l = lines[i];
    const double million = 1e-6 * static_cast<double>(counts[i]);
    if (counts[i] == 0) continue;
    result.lines.push_back({l.kind, 1e3 * l.ours / million, l.ratio.median});
    report(test, l, million, costs, costs_embree, csv);
  }
  return result;
}

// The lowest speed that we want for rays of this kind, as a multiple of Embree's. Rays in groups of
// eight share some of their cost.
double wanted_of(const std::string& kind, double primitives) {
  if (kind == "camera") return 1;
  if (kind == "bounce") return 1.1;
  if (kind == "shadow") return 1.3;
  return primitives > 500000 ? 1.25 : 1.5;
}

void add_goals(const Result& result, std::vector<Goal>& goals) {
  for (const Result::Line& line : result.lines) {
    const double wanted = wanted_of(line.kind, result.primitives);
    goals.push_back({result.scene + ", " + line.kind + " rays, times Embree", wanted, line.ratio});
  }
  goals.push_back({result.scene + ", bytes per triangle", 100, result.bytes, true});
}

// The growth of a bounce ray's time from the first blob to the last, over the growth of log(size).
Goal growth(const Result& first, const Result& last) {
  const double of_time = last.lines[1].nanoseconds / first.lines[1].nanoseconds;
  const double of_log = std::log(last.primitives) / std::log(first.primitives);
  return {"bounce, time over log N, " + first.scene + " to " + last.scene, 1, of_time / of_log,
          true};
}

}  // namespace

std::vector<Goal> compare_rays(const BenchSettings& settings, const std::vector<int>& blobs,
                               const std::vector<std::string>& files) {
  Csv csv(settings.folder + "/rays.csv",
          "scene,primitives,rays,ns,ns_embree,ratio,build_ms,build_ms_embree,bytes,bytes_embree,"
          "ratio_least,ratio_most");
  std::vector<Goal> goals;
  std::vector<Result> of_blobs;
  for (const int triangles : blobs) {
    TestScene test = blob_scene(triangles);
    of_blobs.push_back(compare(test, settings, csv));
    add_goals(of_blobs.back(), goals);
  }
  for (const std::string& file : files) {
    TestScene test = file_scene(file, 480, 360);
    add_goals(compare(test, settings, csv), goals);
  }
  for (std::size_t i = 2; i < of_blobs.size(); ++i) {
    goals.push_back(growth(of_blobs.front(), of_blobs[i]));
  }
  return goals;
}

}  // namespace pt
