#include "pt/render/bounces_apart.h"

#include "pt/scene/recorder.h"
#include "pt/tasks/trace_path.h"

#include <algorithm>
#include <limits>

namespace pt {

namespace {

// is_only_direct_light() checks one path in this many.
constexpr std::uint64_t kCheckEvery = 16;
constexpr std::size_t kAllLights = std::numeric_limits<std::size_t>::max();

// Walks the path again by its tape, with the direct light of one range only. The path ends when enough lights were played.
Rgb played(const Scene& scene, const SurfacePoint& point, const PathSettings& settings,
           const BounceRange& range, Sampler sampler, PathTape& tape,
           std::size_t enough = kAllLights) {
  tape.only = range;
  tape.enough = enough;
  tape.next_light = 0;
  tape.next_ray = 0;
  return trace_path(scene, point, settings, sampler);
}

// The light of a range. The first bounce reaches the camera unchanged. After the last light of the range the path may end: all that
// follows is black, and a path that ends keeps what it has found.
Rgb light_of(const Scene& scene, const SurfacePoint& point, const PathSettings& settings,
             const BounceRange& range, Sampler sampler, PathTape& tape) {
  Rgb first;
  bool later = false;
  std::size_t enough = 0;
  for (const PathTape::DirectLight& direct : tape.lights) {
    const bool wanted = range.from <= direct.bounce && direct.bounce <= range.to;
    if (!wanted || direct.light == Rgb{}) continue;
    enough = &direct - tape.lights.data() + 1;
    later = later || direct.bounce > 1;
    if (direct.bounce == 1) first = direct.light;
  }
  return later ? played(scene, point, settings, range, sampler, tape, enough) : first;
}

// Returns false if trace_path adds anything but direct light: without it, it must return black.
bool is_only_direct_light(const Scene& scene, const SurfacePoint& point,
                          const PathSettings& settings, const Sampler& sampler, PathTape& tape) {
  if (sampler.state()[0] % kCheckEvery != 0) return true;
  return played(scene, point, settings, {-1, -1}, sampler, tape) == Rgb{};
}

bool add_up(const BouncesApart& apart) {
  Rgb rest = apart.sum;
  double size = 0;
  for (const Rgb& part : apart.ranges) {
    rest = rest - part;
    size += size_of(part);
  }
  return is_rounding_error(rest, size);
}

// The tape of this thread while it is in use. If a task throws, later tasks must not use it.
class Taping {
 public:
  explicit Taping(Vec3 start) {
    static thread_local PathTape tape;
    tape.rays.clear();
    tape.lights.clear();
    tape.start = start;
    tape.mode = PathTape::Mode::record;
    recorder.path = &tape;
  }
  ~Taping() {
    recorder.path = nullptr;
    recorder.calls = calls_;
  }
  Taping(const Taping&) = delete;
  Taping& operator=(const Taping&) = delete;

  // Calls are not kept while the path is played.
  PathTape& to_play() {
    recorder.path->mode = PathTape::Mode::play;
    recorder.calls = nullptr;
    return *recorder.path;
  }

 private:
  std::vector<Call>* calls_ = recorder.calls;
};

}  // namespace

BouncesApart trace_path_apart(const Scene& scene, const SurfacePoint& point,
                              const PathSettings& settings, std::span<const BounceRange> ranges,
                              Sampler& sampler) {
  BouncesApart apart;
  Taping taping(point.p);
  const Sampler before = sampler;
  apart.sum = trace_path(scene, point, settings, sampler);
  PathTape& tape = taping.to_play();
  for (const BounceRange& range : ranges) {
    apart.ranges.push_back(light_of(scene, point, settings, range, before, tape));
  }
  apart.complete = add_up(apart) && is_only_direct_light(scene, point, settings, before, tape);
  return apart;
}

PathParts trace_path_in_parts(const Scene& scene, const SurfacePoint& point,
                              const PathSettings& settings, Sampler& sampler) {
  PathParts parts;
  Taping taping(point.p);
  const Sampler before = sampler;
  parts.sum = trace_path(scene, point, settings, sampler);
  PathTape& tape = taping.to_play();
  int last = 0;
  for (const PathTape::DirectLight& direct : tape.lights) last = std::max(last, direct.bounce);
  for (int k = 1; k <= last; ++k) {
    parts.bounces.push_back(played(scene, point, settings, {k, k}, before, tape));
  }
  parts.rest = played(scene, point, settings, {-1, -1}, before, tape);
  return parts;
}

}  // namespace pt
