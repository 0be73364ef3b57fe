// Runs the same path tracer with the same samples on our rays and on Embree's, then on ours with
// more threads.
#include "bench/against_embree.h"
#include "bench/embree.h"
#include "bench/render_tracing.h"
#include "bench/report.h"
#include "bench/test_scenes.h"
#include "pt/math/uncertain.h"
#include "pt/render/cpu_time.h"
#include "pt/tasks/estimate_pixel.h"

#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <thread>

namespace pt {
namespace {

struct Picture {
  Rgb mean;
  double seconds = 0;      // wall clock
  double cpu_seconds = 0;  // of all threads
  double rays = 0;
};

double wall_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

// Each thread takes one row at a time.
Picture render(const View& view, int samples, int threads) {
  std::vector<Rgb> rows(static_cast<std::size_t>(view.height));
  std::atomic<int> next{0};
  std::atomic<long long> rays{0};
  std::atomic<double> cpu{0};
  const auto work = [&] {
    const double begin = thread_cpu_seconds();
    const RayCount before = rays_traced();
    for (int y = next++; y < view.height; y = next++) {
      for (int x = 0; x < view.width; ++x) {
        Sampler sampler = Sampler::for_pixel(1, x, y);
        rows[y] += estimate_pixel(view, x, y, samples, sampler);
      }
    }
    const RayCount after = rays_traced();
    rays += after.closest - before.closest + after.occluded - before.occluded;
    cpu += thread_cpu_seconds() - begin;
  };
  const double start = wall_seconds();
  std::vector<std::thread> others;
  for (int i = 1; i < threads; ++i) others.emplace_back(work);
  work();
  for (std::thread& thread : others) thread.join();
  Picture picture{{}, wall_seconds() - start, cpu, static_cast<double>(rays)};
  for (const Rgb& row : rows) picture.mean += row / (view.width * view.height);
  return picture;
}

// Compares wall clock time, and the CPU time of all threads together. CPU time shows what the threads
// cost each other even if other programs keep the processors busy.
void compare_threads(const std::string& name, const View& view, const BenchSettings& settings,
                     Csv& csv, std::vector<Goal>& goals) {
  render_tracing = {nullptr, true};
  const int most = static_cast<int>(std::thread::hardware_concurrency());
  for (int threads = 2; threads <= most; threads *= 2) {
    std::vector<double> wall, cpu;
    for (int i = 0; i < settings.rounds; ++i) {
      const Picture one = render(view, settings.samples, 1);
      const Picture more = render(view, settings.samples, threads);
      wall.push_back(one.seconds / (threads * more.seconds));
      cpu.push_back(one.cpu_seconds / more.cpu_seconds);
    }
    std::printf("  %d threads: efficiency %.2f by the wall clock, %.2f by CPU time\n", threads,
                median_of(wall), median_of(cpu));
    char row[200];
    std::snprintf(row, sizeof row, "%s,%d threads: efficiency (wall; CPU),%.3f,%.3f,,,,,,",
                  name.c_str(), threads, median_of(wall), median_of(cpu));
    csv.row(row);
    goals.push_back(
        {name + ", " + std::to_string(threads) + " threads: efficiency", 0.95, median_of(wall)});
  }
}

// Prints one engine's line, and adds its row to the CSV.
void report(const std::string& name, const char* engine, double rays, double seconds, double mean,
            const Ratio& single, const Ratio& packets, Csv& csv) {
  std::printf(
      "  %-14s %6.2f M rays/s   mean %.6f   %.2f (%.2f to %.2f) x Embree, "
      "%.2f (%.2f to %.2f) x packets\n",
      engine, 1e-6 * rays / seconds, mean, single.median, single.least, single.most, packets.median,
      packets.least, packets.most);
  char row[200];
  std::snprintf(row, sizeof row, "%s,%s,%.4g,%.4g,%.3f,%.3f,%.3f,%.3f,%.3f,%.3f", name.c_str(),
                engine, seconds, 1e-6 * rays / seconds, single.median, packets.median, single.least,
                single.most, packets.least, packets.most);
  csv.row(row);
}

void compare(const std::string& argument, const BenchSettings& settings, Csv& csv,
             std::vector<Goal>& goals) {
  const bool is_blob = argument[0] >= '0' && argument[0] <= '9';
  const int width = is_blob ? settings.width / 2 : settings.width, height = width * 3 / 4;
  TestScene test =
      is_blob ? blob_scene(std::atoi(argument.c_str())) : file_scene(argument, width, height);
  Scene wide = test.scene, task = std::move(test.scene);
  wide.tracer = Tracer(Engine::wide, wide.primitives);
  task.tracer = Tracer(Engine::task, task.primitives);
  const EmbreeScene embree(task.primitives);
  PathSettings path;
  path.light_samples = 8;
  path.to = 6;
  const View ours{wide, test.camera, path, width, height};
  const View theirs{task, test.camera, path, width, height};

  Picture last[4];
  const auto run = [&](int which, const View& view, const EmbreeScene* by, bool groups) {
    return [&, which, by, groups] {
      render_tracing = {by, groups};
      last[which] = render(view, settings.samples, 1);
    };
  };
  const auto seconds = interleave({run(0, ours, nullptr, false), run(1, ours, nullptr, true),
                                   run(2, theirs, &embree, false), run(3, theirs, &embree, true)},
                                  settings.rounds);
  const char* names[] = {"wide", "wide groups", "Embree", "Embree packets"};
  std::printf("%s, %d x %d, %d samples\n", test.name.c_str(), width, height, settings.samples);
  for (int i = 0; i < 4; ++i) {
    report(test.name, names[i], last[0].rays, median_of(seconds[i]), luminance(last[i].mean),
           ratio(seconds[2], seconds[i]), ratio(seconds[3], seconds[i]), csv);
  }

  goals.push_back(
      {test.name + ", picture, times Embree", 1.5, ratio(seconds[2], seconds[1]).median});
  goals.push_back(
      {test.name + ", picture, times packets", 1.2, ratio(seconds[3], seconds[1]).median});
  if (is_blob) return;
  compare_threads(test.name, ours, settings, csv, goals);
}

}  // namespace

std::vector<Goal> compare_renders(const BenchSettings& settings,
                                  const std::vector<std::string>& scenes) {
  Csv csv(settings.folder + "/renders.csv",
          "scene,engine,seconds,million_rays_a_second,times_embree,times_packets,"
          "embree_least,embree_most,packets_least,packets_most");
  std::vector<Goal> goals;
  for (const std::string& scene : scenes) compare(scene, settings, csv, goals);
  return goals;
}

}  // namespace pt
