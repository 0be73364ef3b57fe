// Measures each step of a query in nanoseconds, on the same rays in one run, for each kernel.
// Decision 10 has the table.
#include "bench/ray_cost.h"

#include "bench/ray_sets.h"
#include "bench/report.h"
#include "pt/command_line.h"

#include <cstdio>
#include <functional>
#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>

namespace pt {

extern const RaySteps ray_steps_plain;
extern const RaySteps ray_steps_v3;
extern const RaySteps ray_steps_v4;

const RaySteps* find_ray_steps(const char* name) {
  const std::string_view asked = name;
  if (asked == "v4") return &ray_steps_v4;
  if (asked == "v3") return &ray_steps_v3;
  return asked == "plain" ? &ray_steps_plain : nullptr;
}

namespace {

volatile double sink;  // keeps the timed code from being optimised away

struct Step {
  const char* name;
  std::function<double(const Ray&)> of;
};

template <class Query>
std::function<void()> over(const std::vector<Ray>& rays, const Query& query) {
  return [&rays, query] {
    double sum = 0;
    for (const Ray& ray : rays) sum += query(ray);
    sink = sum;
  };
}

void print(const char* kind, const char* kernel, const std::vector<const char*>& names,
           const std::vector<std::vector<double>>& seconds, std::size_t rays) {
  std::printf("%-8s %-5s", kind, kernel);
  for (std::size_t i = 0; i < names.size(); ++i) {
    std::printf("  %s %.1f", names[i], 1e9 * median(seconds[i]) / static_cast<double>(rays));
  }
  std::printf("\n");
}

void closest_steps(const char* kind, Scene& scene, const std::vector<Ray>& rays,
                   const Kernel& kernel, int rounds) {
  if (rays.empty()) return;
  const Primitives& primitives = scene.primitives;
  const WideBvh bvh = WideBvh::build(primitives, kernel);
  const WideQuery query = bvh.query(primitives);
  const RaySteps& steps = *find_ray_steps(kernel.name);
  const auto step = [&](WideHit (*of)(const WideQuery&, const Ray&)) {
    return over(rays, [&query, of](const Ray& ray) { return of(query, ray).hit.t; });
  };
  const auto seconds = interleave({step(steps.call), step(steps.to_frame), step(steps.prepared),
                                   step(steps.found), step(kernel.closest),
                                   over(rays,
                                        [&](const Ray& ray) {
                                          const std::optional<Hit> hit =
                                              bvh.closest(primitives, ray);
                                          return hit ? hit->t + hit->n.x : 0;
                                        }),
                                   over(rays,
                                        [&](const Ray& ray) {
                                          const std::optional<Hit> hit = scene.closest(ray);
                                          return hit ? hit->t + hit->n.x : 0;
                                        })},
                                  rounds);
  print(kind, kernel.name,
        {"call", "+ frame", "+ prepared", "+ float search", "+ decision", "+ normal", "in a scene"},
        seconds, rays.size());
}  // NOLINT(clang-analyzer-cplusplus.NewDeleteLeaks): clang-tidy loses the list of std::function

void occluded_steps(Scene& scene, const std::vector<Ray>& rays, const Kernel& kernel, int rounds) {
  const Primitives& primitives = scene.primitives;
  const WideBvh bvh = WideBvh::build(primitives, kernel);
  const WideQuery query = bvh.query(primitives);
  const RaySteps& steps = *find_ray_steps(kernel.name);
  const auto groups_of = [&](std::size_t size) {
    return [&, size] {
      int sum = 0;
      const std::span<const Ray> all(rays);
      for (std::size_t i = 0; i + kShadowGroup <= rays.size(); i += kShadowGroup) {
        for (std::size_t k = 0; k < kShadowGroup; k += size) {
          sum += __builtin_popcount(bvh.occluded(primitives, all.subspan(i + k, size)));
        }
      }
      sink = sum;
    };
  };
  const auto seconds = interleave(
      {over(rays, [&](const Ray& ray) { return steps.call(query, ray).hit.t; }),
       over(rays, [&](const Ray& ray) { return steps.prepared(query, ray).hit.t; }),
       over(rays, [&](const Ray& ray) { return kernel.occluded(query, ray) ? 1.0 : 0.0; }),
       groups_of(4), groups_of(8)},
      rounds);
  print("shadow", kernel.name, {"call", "+ prepared", "alone", "in fours", "in eights"}, seconds,
        rays.size());
}

int run(const std::vector<std::string>& scenes, const std::vector<std::string>& kernels, int count,
        int rounds) {
  for (const std::string& name : scenes) {
    TestScene test =
        name.ends_with(".dae") ? file_scene(name, 480, 360) : blob_scene(std::stoi(name));
    test.scene.tracer = Tracer(Engine::wide, test.scene.primitives);
    const RaySets rays = make_rays(test, count);
    std::printf("%s, %d primitives; ns per ray, medians of %d rounds\n", test.name.c_str(),
                test.scene.primitives.size(), rounds);
    for (const std::string& asked : kernels) {
      const Kernel* kernel = find_kernel(asked.c_str());
      if (kernel == nullptr) continue;
      closest_steps("camera", test.scene, rays.primary, *kernel, rounds);
      closest_steps("bounce", test.scene, rays.bounce, *kernel, rounds);
      occluded_steps(test.scene, rays.shadow, *kernel, rounds);
    }
  }
  return 0;
}

}  // namespace
}  // namespace pt

int main(int count, char** arguments) {
  CLI::App app("Measures the time of each step of a ray query, for each kernel.");
  std::vector<std::string> scenes, kernels{"v4", "v3", "plain"};
  int rays = 100000, rounds = 7;
  app.add_option("scenes", scenes, "scene files, or numbers: blobs of so many triangles")
      ->required();
  app.add_option("--kernels", kernels, "only these, for example to count their instructions")
      ->check(CLI::IsMember({"v4", "v3", "plain"}))
      ->allow_extra_args(false);
  app.add_option("--rays", rays, "per kind")->check(CLI::PositiveNumber)->capture_default_str();
  app.add_option("--rounds", rounds)->check(CLI::PositiveNumber)->capture_default_str();
  return pt::run_command_line(app, count, arguments,
                              [&] { return pt::run(scenes, kernels, rays, rounds); });
}
