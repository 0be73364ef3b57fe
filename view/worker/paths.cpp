#include "pt/render/bounces_apart.h"
#include "pt/render/common_radiance.h"
#include "pt/render/pixel_record.h"
#include "pt/tasks/adaptive_pixel.h"
#include "pt/tasks/estimate_pixel.h"
#include "view/worker/path.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace view {

namespace {

// This thread's pixel while it is recorded, and the first sample whose path is kept.
thread_local PixelPaths* recording = nullptr;
thread_local int first_kept = 0;

// The numbers that take a sampler from one state to the other; none if they are more than a few.
std::vector<double> numbers_between(const pt::Sampler::State& from, const pt::Sampler::State& to) {
  constexpr int kMost = 16;
  pt::Sampler sampler(from);
  std::vector<double> numbers;
  while (sampler.state() != to) {
    if (numbers.size() == kMost) return {};
    numbers.push_back(sampler.next_1d());
  }
  return numbers;
}

void add_numbers(Bounce& bounce, const pt::Sampler::State& from, const pt::Sampler::State& to) {
  const std::vector<double> numbers = numbers_between(from, to);
  bounce.drawn.insert(bounce.drawn.end(), numbers.begin(), numbers.end());
}

template <class... In>
std::tuple<In...> in(const pt::Call& call) {
  return std::any_cast<std::tuple<In...>>(call.in);
}
template <class Out>
Out out(const pt::Call& call) {
  return std::any_cast<Out>(call.out);
}

Draw light_draw(const pt::Scene& scene, const pt::SurfacePoint& point, const pt::Call& call) {
  Draw draw;
  const pt::Light* light = std::get<0>(in<const pt::Light*, pt::Vec3>(call));
  for (std::size_t i = 0; i < scene.lights.size(); ++i) {
    if (&scene.lights[i] == light) draw.light = static_cast<int>(i);
  }
  draw.sample = out<pt::LightSample>(call);
  draw.cosine = dot(point.n, draw.sample.wi);
  return draw;
}

Draw hemisphere_draw(const pt::Scene& scene, const pt::SurfacePoint& point, const pt::Call& call) {
  Draw draw;
  draw.ray = std::get<1>(in<const pt::Scene*, pt::Ray>(call));
  const auto hit = out<std::optional<pt::Hit>>(call);
  draw.was_traced = true;
  draw.sample.wi = draw.ray.direction;
  draw.sample.distance = hit ? hit->t : pt::kInfinity;
  draw.sample.radiance =
      hit ? surface_point(scene, draw.ray, *hit).emission : background(scene, draw.ray.direction);
  draw.sample.pdf = 1 / (2 * pt::kPi);
  draw.hit = hit ? hit->primitive : -1;
  draw.cosine = dot(point.n, draw.ray.direction);
  return draw;
}

// The draw that a shadow ray asks about: in the nearest direction, and no other ray has asked about it. Some tasks draw several
// times before they trace.
Draw* draw_towards(std::vector<Draw>& draws, pt::Vec3 wi) {
  Draw* found = nullptr;
  double nearest = 1e-3;
  for (Draw& draw : draws) {
    const double apart = length(wi - draw.sample.wi);
    if (draw.was_traced || !(apart < nearest)) continue;
    found = &draw;
    nearest = apart;
  }
  return found;
}

Bounce* bounce_at(Path& path, pt::Vec3 p) {
  const auto found = std::find_if(path.bounces.rbegin(), path.bounces.rend(),
                                  [&](const Bounce& bounce) { return bounce.point.p == p; });
  return found == path.bounces.rend() ? nullptr : &*found;
}

// Returns whether a ray leaves a point, but for the offset of its origin.
bool leaves(const pt::Ray& ray, const pt::SurfacePoint& point) {
  return length(ray.origin - point.p) <= 1e-6 * point.scale;
}

// A ray from a point before the last one begins a second path.
bool begins_another(const Path& path, const pt::Ray& ray) {
  if (path.bounces.back().ray) return true;
  if (leaves(ray, path.bounces.back().point)) return false;
  return std::ranges::any_of(path.bounces,
                             [&](const Bounce& bounce) { return leaves(ray, bounce.point); });
}

// Puts the calls of trace_path, from calls[first] on, into the points of the path.
void arrange(const pt::Scene& scene, Path& path, std::size_t first, const pt::Sampler::State& start,
             const pt::Sampler::State& end) {
  pt::Sampler::State last = start;
  for (std::size_t i = first; i < path.calls.size(); i = path.calls[i].end) {
    const pt::Call& call = path.calls[i];
    Bounce& here = path.bounces.back();
    if (call.name.starts_with("direct_")) {
      const auto point = std::get<1>(in<const pt::Scene*, pt::SurfacePoint, int>(call));
      // Some walk the whole path first.
      if (here.next.empty()) add_numbers(here, last, call.before);
      Bounce* const bounce = bounce_at(path, point.p);
      if (bounce != nullptr) bounce->direct.push_back(direct_of(scene, path.calls, i));
      path.lost_point = path.lost_point || bounce == nullptr;
      last = call.after;
    } else if (call.name == "diffuse_sample") {
      add_numbers(here, last, call.before);
      here.wo = std::get<1>(in<pt::Rgb, pt::Vec3>(call));
      here.next.push_back(out<pt::BsdfSample>(call));
      last = call.after;
    } else if (call.name == "closest") {
      const pt::Ray ray = std::get<1>(in<const pt::Scene*, pt::Ray>(call));
      path.is_one = path.is_one && !begins_another(path, ray);
      here.ray = ray;
      if (const auto hit = out<std::optional<pt::Hit>>(call)) {
        Bounce next;
        next.point = surface_point(scene, ray, *hit);
        next.primitive = hit->primitive;
        next.met_by = ray;
        next.met = *hit;
        path.bounces.push_back(next);
      }
    }
  }
  Bounce& ended = path.bounces.back();
  if (ended.next.empty()) add_numbers(ended, last, end);
}

// The number by which the light from the next point on was divided, as far as its part of the sum tells.
std::optional<double> division(const Bounce& after, pt::Rgb undivided) {
  if (after.direct.empty()) return std::nullopt;
  const double light = luminance(undivided * after.direct[0].light), part = luminance(after.part);
  if (!(light > 0 && part > 0 && std::isfinite(light / part))) return std::nullopt;
  return light / part;
}

// The throughput of each point by the calls. Survival is that of the settings, unless the parts tell that the task has its own.
void find_throughputs(Path& path, const pt::PathParts& parts, const pt::PathSettings& settings) {
  constexpr double kRounding = 1e-6;
  for (std::size_t i = 0; i < std::min(path.bounces.size(), parts.bounces.size()); ++i) {
    path.bounces[i].part = parts.bounces[i];
  }
  pt::Rgb throughput = pt::gray(1);
  bool is_right = true;  // the first direction was weighed as the contract says
  for (std::size_t i = 0; i < path.bounces.size(); ++i) {
    Bounce& bounce = path.bounces[i];
    bounce.throughput = throughput;
    path.is_one = path.is_one && bounce.direct.size() <= 1 && bounce.next.size() <= 1;
    if (bounce.next.empty()) continue;
    throughput *= factor(bounce.next[0]);
    if (i + 1 >= path.bounces.size()) continue;
    const std::optional<double> divided = division(path.bounces[i + 1], throughput);
    if (i == 0) {
      is_right = !divided || std::abs(*divided - 1) < kRounding;
      continue;
    }
    const bool is_told = is_right && divided && *divided > 0 && *divided < 1 + kRounding;
    bounce.survival = is_told || !bounce.drawn.empty() ? settings.survival : 1;
    // The task may have a survival of its own.
    if (is_told && std::abs(*divided - settings.survival) > kRounding) bounce.survival = *divided;
    throughput /= bounce.survival;
  }
}

Path walk(const pt::Scene& scene, const pt::Ray& ray, const pt::PathSettings& settings,
          pt::Sampler& sampler) {
  Path path;
  path.ray = ray;
  std::vector<pt::Call>* const outer = std::exchange(pt::recorder.calls, &path.calls);
  const std::optional<pt::Hit> hit = scene.closest(ray);
  if (hit) {
    const pt::SurfacePoint point = surface_point(scene, ray, *hit);
    const std::size_t first = path.calls.size();
    const pt::Sampler::State start = sampler.state();
    path.bounces.emplace_back();
    path.bounces[0].point = point;
    path.bounces[0].primitive = hit->primitive;
    path.bounces[0].met_by = ray;
    path.bounces[0].met = *hit;
    if (settings.from <= 0) path.emission = point.emission;
    pt::PathParts parts;
    if (settings.to >= 1) parts = trace_path_in_parts(scene, point, settings, sampler);
    path.traced = parts.sum;
    path.rest = parts.rest;
    pt::recorder.calls = nullptr;
    arrange(scene, path, first, start, sampler.state());
    find_throughputs(path, parts, settings);
  }
  pt::recorder.calls = outer;
  path.value = pt::Rgb{} + path.emission + path.traced;
  return path;
}

template <class Number>
pt::Rgb added(const std::vector<pt::Rgb>& parts) {
  std::array<Number, 3> sum{};
  for (const pt::Rgb& part : parts) {
    for (int c = 0; c < 3; ++c) sum[c] += static_cast<Number>(part[c]);
  }
  return {sum[0], sum[1], sum[2]};
}

// Keeps calls of the tasks between a pixel and its paths, as camera_ray.
class Recording {
 public:
  Recording(PixelPaths& pixel, int first) {
    recording = &pixel;
    first_kept = first;
    pt::recorder.calls = &pixel.calls;
  }
  ~Recording() {
    recording = nullptr;
    pt::recorder.calls = nullptr;
  }
  Recording(const Recording&) = delete;
  Recording& operator=(const Recording&) = delete;
};

// One sample of the pixel that is recorded.
pt::Rgb sample(PixelPaths& pixel, const pt::Scene& scene, const pt::Ray& ray,
               const pt::PathSettings& settings, pt::Sampler& sampler) {
  const int number = static_cast<int>(pixel.values.size());
  pt::Rgb value;
  if (number >= first_kept && number < first_kept + kMostPaths) {
    pixel.paths.push_back(walk(scene, ray, settings, sampler));
    value = pixel.paths.back().value;
  } else {
    std::vector<pt::Call>* const outer = std::exchange(pt::recorder.calls, nullptr);
    value = common_radiance(scene, ray, settings, sampler);
    pt::recorder.calls = outer;
  }
  pixel.values.push_back(value);
  return value;
}

}  // namespace

Direct direct_of(const pt::Scene& scene, const std::vector<pt::Call>& calls, std::size_t at) {
  const auto [of, point, samples] = in<const pt::Scene*, pt::SurfacePoint, int>(calls[at]);
  Direct direct{calls[at].name, samples, out<pt::Rgb>(calls[at]), true, {}};
  pt::Sampler::State last = calls[at].before;
  const bool may_draw_numbers = direct.task != "direct_lights";
  for (std::size_t i = at + 1; i < calls[at].end; ++i) {
    const pt::Call& call = calls[i];
    direct.plain = direct.plain && call.name != "diffuse_sample";
    if (call.name == "sample_light") {
      direct.plain = direct.plain && (may_draw_numbers || call.before == last);
      last = call.after;
      direct.draws.push_back(light_draw(scene, point, call));
    }
    if (call.name == "closest") direct.draws.push_back(hemisphere_draw(scene, point, call));
    if (call.name == "occluded") {
      const pt::Ray ray = std::get<1>(in<const pt::Scene*, pt::Ray>(call));
      if (Draw* const draw = draw_towards(direct.draws, normalize(ray.direction))) {
        draw->ray = ray;
        draw->was_traced = true;
        draw->is_hidden = out<bool>(call);
      }
    }
  }
  direct.plain = direct.plain && (may_draw_numbers || calls[at].after == last);
  return direct;
}

pt::Rgb factor(const pt::BsdfSample& sample) {
  return sample.f * (std::abs(sample.wi.z) / sample.pdf);
}

pt::Rgb sum_of_parts(const Path& path) {
  pt::Rgb sum;
  for (const Bounce& bounce : path.bounces) sum += bounce.part;
  return sum + path.rest;
}

bool adds_up(const Path& path) {
  std::vector<pt::Rgb> parts;
  for (const Bounce& bounce : path.bounces) parts.push_back(bounce.part);
  parts.push_back(path.rest);
  const auto is_sum = [&] {
    return added<double>(parts) == path.traced || added<float>(parts) == path.traced;
  };
  if (is_sum()) return true;
  std::ranges::reverse(parts);
  return is_sum();
}

PixelPaths paths_of_pixel(const pt::View& view, const Settings& settings) {
  PixelPaths pixel;
  const pt::RenderOptions& render = settings.render;
  {
    const Recording calls(pixel, settings.first);
    pt::Sampler sampler = pt::Sampler::for_pixel(render.seed, settings.x, settings.y);
    if (render.adaptive) {
      const pt::PixelEstimate estimate =
          adaptive_pixel(view, settings.x, settings.y, *render.adaptive, sampler);
      pixel.mean = estimate.mean;
      pixel.samples = estimate.samples;
    } else {
      pixel.mean = estimate_pixel(view, settings.x, settings.y, render.samples, sampler);
      pixel.samples = render.samples;
    }
  }
  int sample = 0;
  for (const pt::Call& call : pixel.calls) {
    if (call.name != "camera_ray") continue;
    const int path = sample++ - settings.first;
    if (path < 0 || path >= static_cast<int>(pixel.paths.size())) continue;
    const auto [camera, x, y] = in<pt::Camera, double, double>(call);
    pixel.paths[path].at = {x, y};
  }
  return pixel;
}

}  // namespace view

namespace pt {

// The slot of the seam (pt/render/radiance.h) in the view: `recorded`, which keeps the path while one is looked at.
Rgb radiance(const Scene& scene, const Ray& ray, const PathSettings& settings, Sampler& sampler) {
  if (view::recording == nullptr) {
    return recorded(common_radiance(scene, ray, settings, sampler));
  }
  return recorded(view::sample(*view::recording, scene, ray, settings, sampler));
}

}  // namespace pt
