#include "bench/against_embree.h"
#include "bench/queries.h"
#include "bench/report.h"
#include "bench/test_scenes.h"
#include "pt/math/uncertain.h"
#include "pt/render/cpu_time.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <span>

namespace pt {
namespace {

volatile double sink;  // keeps the timed code from being optimised away

// Shadow rays in groups from one point.
double occluded_by_groups(const WideBvh& bvh, const Primitives& primitives,
                          std::span<const Ray> rays) {
  int hits = 0;
  for (std::size_t i = 0; i + kShadowGroup <= rays.size(); i += kShadowGroup) {
    hits += __builtin_popcount(bvh.occluded(primitives, rays.subspan(i, kShadowGroup)));
  }
  return hits;
}

// The sides that ours is compared with. tinybvh may be missing.
constexpr int kOthers = 3;
constexpr std::array<const char*, kOthers> kOther{"Embree", "robust Embree", "tinybvh"};

// Rays of one kind: nanoseconds per ray, ours and then the others', and how many times as fast ours are.
struct Line {
  const char* kind;
  double ours;
  double others[kOthers];
  Ratio times[kOthers];
};

struct Result {
  std::string scene;
  int primitives;
  double bytes;  // per primitive
  std::vector<Line> lines;
};

using Seconds = std::vector<double>;  // of each round

Line line(const char* kind, std::size_t rays, const Seconds& ours,
          std::span<const Seconds> others) {
  const double scale = 1e9 / static_cast<double>(rays);
  Line line{kind, scale * median_of(ours), {NAN, NAN, NAN}, {}};
  for (Ratio& times : line.times) times = {NAN, NAN, NAN};
  for (std::size_t i = 0; i < others.size(); ++i) {
    line.others[i] = scale * median_of(others[i]);
    line.times[i] = ratio(others[i], ours);
  }
  return line;
}

// Lets all sides answer the rays by turns: ours, the others, and ours in groups if they are shadow rays.
void measure(const char* kind, const std::vector<Queries>& sides,
             std::function<double()> Queries::*query, std::size_t rays, int rounds,
             const std::function<double()>& groups, std::vector<Line>& lines) {
  if (rays == 0) return;
  std::vector<double> found(sides.size());
  std::vector<std::function<void()>> contenders;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    contenders.emplace_back([&, i] { sink = found[i] = (sides[i].*query)(); });
  }
  if (groups) contenders.emplace_back([&] { sink = groups(); });
  const std::vector<Seconds> seconds = interleave(contenders, rounds);
  const std::span<const Seconds> others(seconds.data() + 1, sides.size() - 1);
  lines.push_back(line(kind, rays, seconds[0], others));
  if (groups) lines.push_back(line("shadow x8", rays, seconds.back(), others));
  for (std::size_t i = 0; i < others.size(); ++i) {
    // Other sides' rays are in single precision and begin a little later.
    const double difference = std::abs(found[i + 1] / found[0] - 1);
    if (difference < 0.01) continue;
    std::printf("  %s rays: what %s finds differs by %.1f %%\n", kind, kOther.at(i),
                100 * difference);
  }
}

// The costs of a tree.
struct TreeCosts {
  double milliseconds;
  double bytes;  // per primitive
};

// Prints the line, and adds it to the file.
void report(const TestScene& test, const Line& line, const TreeCosts& ours, const TreeCosts& embree,
            Csv& csv) {
  std::printf("  %-10s %6.2f M/s ", line.kind, 1e3 / line.ours);
  const auto text = [](auto... values) {
    char part[100];
    std::snprintf(part, sizeof part, values...);
    return std::string(part);
  };
  std::string row =
      test.name + text(",%d,%s,%.4g", test.scene.primitives.size(), line.kind, line.ours);
  for (const double other : line.others) row += text(",%.4g", other);
  for (int i = 0; i < kOthers; ++i) {
    const Ratio& r = line.times[i];
    row += text(",%.3f,%.3f,%.3f", r.median, r.least, r.most);
    if (std::isnan(r.median)) continue;
    std::printf("  %.2f (%.2f to %.2f) x %s", r.median, r.least, r.most, kOther[i]);
  }
  std::printf("\n");
  csv.row(row + text(",%.4g,%.4g,%.1f,%.1f", ours.milliseconds, embree.milliseconds, ours.bytes,
                     embree.bytes));
}

Result compare(TestScene& test, const BenchSettings& settings, Csv& csv) {
  const Primitives& primitives = test.scene.primitives;
  double start = thread_cpu_seconds();
  const WideBvh bvh = WideBvh::build(primitives);
  const TreeCosts costs{1e3 * (thread_cpu_seconds() - start),
                        static_cast<double>(bvh.bytes()) / primitives.size()};
  start = thread_cpu_seconds();
  const EmbreeScene embree(primitives);
  const TreeCosts costs_embree{1e3 * (thread_cpu_seconds() - start),
                               static_cast<double>(embree.bytes()) / primitives.size()};
  const EmbreeScene robust(primitives, RTC_SCENE_FLAG_ROBUST);
  const auto tiny = tinybvh(primitives, embree);
  std::printf("%s: %d primitives; build %.1f ms, Embree %.1f; bytes each %.0f, Embree %.0f\n",
              test.name.c_str(), primitives.size(), costs.milliseconds, costs_embree.milliseconds,
              costs.bytes, costs_embree.bytes);

  test.scene.tracer = Tracer(Engine::wide, primitives);
  const RaySets rays = make_rays(test, settings.rays);
  Result result{test.name, primitives.size(), costs.bytes, {}};
  const auto compare_kind = [&](const char* kind, const std::vector<Ray>& these, auto query,
                                const std::function<double()>& groups) {
    std::vector<Queries> sides{queries_of(bvh, primitives, these),
                               queries_of(embree, primitives, these),
                               queries_of(robust, primitives, these)};
    if (tiny) sides.push_back(tiny(these));
    measure(kind, sides, query, these.size(), settings.rounds, groups, result.lines);
  };
  compare_kind("camera", rays.primary, &Queries::closest, {});
  compare_kind("bounce", rays.bounce, &Queries::closest, {});
  compare_kind("shadow", rays.shadow, &Queries::occluded,
               [&] { return occluded_by_groups(bvh, primitives, rays.shadow); });
  for (const Line& line : result.lines) report(test, line, costs, costs_embree, csv);
  return result;
}

// Rays are compared with the mode that bounds its errors as we do; pictures are goals of their own
// (bench/renders_against_embree.cpp). In a million triangles rays wait for memory, whoever asks.
void add_goals(const Result& result, std::vector<Goal>& goals) {
  constexpr int kRobust = 1;  // of kOther
  constexpr double kWanted = 1.25;
  for (const Line& line : result.lines) {
    if (result.primitives > 500000) continue;
    goals.push_back({result.scene + ", " + line.kind + " rays, times " + kOther[kRobust], kWanted,
                     line.times[kRobust].median});
  }
  goals.push_back({result.scene + ", bytes per triangle", 60, result.bytes, true});
}

// The growth of a bounce ray's time from the first blob to the last, over the growth of log(size).
Goal growth(const Result& first, const Result& last) {
  const double of_time = last.lines[1].ours / first.lines[1].ours;
  const double of_log = std::log(last.primitives) / std::log(first.primitives);
  return {"bounce, time over log N, " + first.scene + " to " + last.scene, 1, of_time / of_log,
          true};
}

}  // namespace

std::vector<Goal> compare_rays(const BenchSettings& settings, const std::vector<int>& blobs,
                               const std::vector<std::string>& files) {
  Csv csv(settings.folder + "/rays.csv",
          "scene,primitives,rays,ns,ns_embree,ns_robust,ns_tinybvh,times_embree,least,most,"
          "times_robust,least,most,times_tinybvh,least,most,build_ms,build_ms_embree,bytes,"
          "bytes_embree");
  std::vector<Goal> goals;
  std::vector<Result> of_blobs;
  for (const int triangles : blobs) {
    TestScene test = blob_scene(triangles);
    of_blobs.push_back(compare(test, settings, csv));
    add_goals(of_blobs.back(), goals);
  }
  std::vector<TestScene> others{needles_scene(10000)};
  for (const std::string& file : files) others.push_back(file_scene(file, 480, 360));
  for (TestScene& test : others) add_goals(compare(test, settings, csv), goals);
  for (std::size_t i = 2; i < of_blobs.size(); ++i) {
    goals.push_back(growth(of_blobs.front(), of_blobs[i]));
  }
  return goals;
}

}  // namespace pt
