// Whole pictures: the same path tracer with the same samples, its rays traced by us and by Embree.
// Then ours with two threads.
#include "bench/embree.h"
#include "bench/render_tracing.h"
#include "bench/report.h"
#include "bench/test_scenes.h"
#include "pt/accel/kernel.h"
#include "pt/error.h"
#include "pt/tasks/estimate_pixel.h"

#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <thread>

namespace pt {
namespace {

constexpr int kRounds = 5;

struct Picture {
  Rgb mean;
  double seconds = 0;      // of the wall clock
  double cpu_seconds = 0;  // of all threads
  double rays = 0;
};

double wall_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

// Rows are handed out one at a time.
Picture render(const View& view, int samples, int threads) {
  std::vector<Rgb> rows(static_cast<std::size_t>(view.height));
  std::atomic<int> next{0};
  std::atomic<long long> rays{0};
  std::atomic<double> cpu{0};
  const auto work = [&] {
    const double begin = cpu_seconds();
    const RayCount before = rays_traced();
    for (int y = next++; y < view.height; y = next++) {
      for (int x = 0; x < view.width; ++x) {
        Sampler sampler = Sampler::for_pixel(1, x, y);
        rows[y] += estimate_pixel(view, x, y, samples, sampler);
      }
    }
    const RayCount after = rays_traced();
    rays += after.closest - before.closest + after.occluded - before.occluded;
    cpu += cpu_seconds() - begin;
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

// By the wall clock, and by the CPU time that the threads took together: the second shows what they
// cost each other also where other programs keep the processors busy.
void compare_threads(const std::string& name, const View& view, int samples, Csv& csv) {
  render_tracing = {nullptr, true};
  const int most = static_cast<int>(std::thread::hardware_concurrency());
  for (int threads = 2; threads <= most; threads *= 2) {
    std::vector<double> wall, cpu;
    for (int i = 0; i < kRounds; ++i) {
      const Picture one = render(view, samples, 1), more = render(view, samples, threads);
      wall.push_back(one.seconds / (threads * more.seconds));
      cpu.push_back(one.cpu_seconds / more.cpu_seconds);
    }
    std::printf("  %d threads: efficiency %.2f by the wall clock, %.2f by CPU time\n", threads,
                median(wall), median(cpu));
    char row[200];
    std::snprintf(row, sizeof row, "%s,%d threads: efficiency (wall; CPU),%.3f,%.3f,,",
                  name.c_str(), threads, median(wall), median(cpu));
    csv.row(row);
  }
}

void compare(const std::string& argument, int width, int samples, Csv& csv) {
  const int height = width * 3 / 4;
  TestScene test = argument[0] >= '0' && argument[0] <= '9'
                       ? blob_scene(std::atoi(argument.c_str()))
                       : file_scene(argument, width, height);
  Scene wide = test.scene, task = std::move(test.scene);
  wide.tracer = Tracer(Engine::wide, wide.primitives);
  task.tracer = Tracer(Engine::task, task.primitives);
  const EmbreeScene embree(task.primitives);
  PathSettings settings;
  settings.light_samples = 8;
  settings.to = 6;
  const View ours{wide, test.camera, settings, width, height};
  const View theirs{task, test.camera, settings, width, height};

  Picture last[4];
  const auto run = [&](int which, const View& view, const EmbreeScene* by, bool groups) {
    return [&, which, by, groups] {
      render_tracing = {by, groups};
      last[which] = render(view, samples, 1);
    };
  };
  const auto seconds = interleave({run(0, ours, nullptr, false), run(1, ours, nullptr, true),
                                   run(2, theirs, &embree, false), run(3, theirs, &embree, true)},
                                  kRounds);
  const char* names[] = {"wide", "wide groups", "Embree", "Embree packets"};
  std::printf("%s, %d x %d, %d samples\n", test.name.c_str(), width, height, samples);
  for (int i = 0; i < 4; ++i) {
    const double rays = last[0].rays, time = median(seconds[i]);
    std::printf("  %-14s %6.2f M rays/s   mean %.6f   %.2f x Embree, %.2f x packets\n", names[i],
                1e-6 * rays / time, luminance(last[i].mean), ratio(seconds[2], seconds[i]),
                ratio(seconds[3], seconds[i]));
    char row[200];
    std::snprintf(row, sizeof row, "%s,%s,%.4g,%.4g,%.3f,%.3f", test.name.c_str(), names[i], time,
                  1e-6 * rays / time, ratio(seconds[2], seconds[i]), ratio(seconds[3], seconds[i]));
    csv.row(row);
  }

  compare_threads(test.name, ours, samples, csv);
}

int run(int count, char** arguments) {
  const char* folder = std::getenv("BENCH_OUT");
  Csv csv(std::string(folder ? folder : ".") + "/bench_renders.csv",
          "scene,engine,seconds,million_rays_a_second,times_embree,times_packets");
  std::printf("kernel %s\n", best_kernel().name);
  if (count < 4) throw Error("usage: bench_renders WIDTH SAMPLES SCENE...");
  for (int i = 3; i < count; ++i) {
    compare(arguments[i], std::atoi(arguments[1]), std::atoi(arguments[2]), csv);
  }
  return 0;
}

}  // namespace
}  // namespace pt

int main(int count, char** arguments) {
  try {
    return pt::run(count, arguments);
  } catch (const pt::Error& error) {
    std::fprintf(stderr, "bench_renders: %s\n", error.what());
    return 2;
  }
}
