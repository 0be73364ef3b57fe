#include "pt/render/bounces_apart.h"

#include "pt/scene/hit_tape.h"
#include "pt/tasks/trace_path.h"

#include <algorithm>
#include <optional>

namespace pt {

namespace {

// One path in so many is checked by is_only_direct_light().
constexpr std::uint64_t kCheckEvery = 16;

// The direct light of one path, in the order in which it was asked for.
struct DirectTape {
  struct Entry {
    int bounce = 0;  // 0: of a point that is not on the path
    Rgb light;
    Sampler::State after;
  };

  enum class Mode { off, record, play };
  Mode mode = Mode::off;
  std::vector<Entry> entries;
  std::size_t next = 0;
  Vec3 start;        // of the path
  BounceRange only;  // while it is played
  HitTape hits;
};

DirectTape& direct_tape() {
  static thread_local DirectTape tape;
  return tape;
}

bool is_in(const BounceRange& range, int bounce) {
  return range.from <= bounce && bounce <= range.to;
}

// Bounce k + 1 is direct light where the path's k-th ray ended, whether the task asks for it before
// it goes on or when it comes back.
int bounce_at(const DirectTape& tape, Vec3 p) {
  for (std::size_t k = tape.hits.entries.size(); k > 0; --k) {
    const HitTape::Entry& entry = tape.hits.entries[k - 1];
    if (entry.hit && entry.ray.at(entry.hit->t) == p) return static_cast<int>(k) + 1;
  }
  return tape.start == p ? 1 : 0;
}

// The walk again, by the tapes, with the direct light of one range only.
Rgb played(const Scene& scene, const SurfacePoint& point, const PathSettings& settings,
           const BounceRange& range, Sampler sampler, DirectTape& tape) {
  tape.only = range;
  tape.next = 0;
  tape.hits.next = 0;
  return trace_path(scene, point, settings, sampler);
}

// The light that a range brings. The first bounce reaches the camera as it is.
Rgb light_of(const Scene& scene, const SurfacePoint& point, const PathSettings& settings,
             const BounceRange& range, Sampler sampler, DirectTape& tape) {
  Rgb first;
  bool later = false;
  for (const DirectTape::Entry& entry : tape.entries) {
    if (!is_in(range, entry.bounce) || entry.light == Rgb{}) continue;
    later = later || entry.bounce > 1;
    if (entry.bounce == 1) first = entry.light;
  }
  return later ? played(scene, point, settings, range, sampler, tape) : first;
}

// Returns false if trace_path adds anything but direct light: without it, it must return black.
bool is_only_direct_light(const Scene& scene, const SurfacePoint& point,
                          const PathSettings& settings, const Sampler& sampler, DirectTape& tape) {
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

// The tapes of this thread, in use. A task may throw, and others go on without tapes.
class Taping {
 public:
  explicit Taping(Vec3 start) : tape_(direct_tape()) {
    tape_.entries.clear();
    tape_.hits.entries.clear();
    tape_.start = start;
    tape_.mode = DirectTape::Mode::record;
    tape_.hits.mode = HitTape::Mode::record;
    hit_tape = &tape_.hits;
  }
  ~Taping() {
    hit_tape = nullptr;
    tape_.mode = DirectTape::Mode::off;
  }
  Taping(const Taping&) = delete;
  Taping& operator=(const Taping&) = delete;

  DirectTape& rewound() {
    tape_.mode = DirectTape::Mode::play;
    tape_.hits.mode = HitTape::Mode::play;
    return tape_;
  }

 private:
  DirectTape& tape_;
};

}  // namespace

BouncesApart trace_path_apart(const Scene& scene, const SurfacePoint& point,
                              const PathSettings& settings, std::span<const BounceRange> ranges,
                              Sampler& sampler) {
  BouncesApart apart;
  Taping taping(point.p);
  const Sampler before = sampler;
  apart.sum = trace_path(scene, point, settings, sampler);
  DirectTape& tape = taping.rewound();
  for (const BounceRange& range : ranges) {
    apart.ranges.push_back(light_of(scene, point, settings, range, before, tape));
  }
  apart.complete = add_up(apart) && is_only_direct_light(scene, point, settings, before, tape);
  return apart;
}

Rgb direct_by_tape(DirectTask& task, const Scene& scene, const SurfacePoint& point, int samples,
                   Sampler& sampler) {
  DirectTape& tape = direct_tape();
  if (tape.mode == DirectTape::Mode::play) {
    if (tape.next == tape.entries.size()) return {};
    const DirectTape::Entry& entry = tape.entries[tape.next++];
    sampler = Sampler(entry.after);
    return is_in(tape.only, entry.bounce) ? entry.light : Rgb{};
  }
  HitTape* const hits = hit_tape;
  hit_tape = nullptr;  // its own rays do not belong to the path
  const Rgb light = task(scene, point, samples, sampler);
  hit_tape = hits;
  if (tape.mode == DirectTape::Mode::record) {
    tape.entries.push_back({bounce_at(tape, point.p), light, sampler.state()});
  }
  return light;
}

}  // namespace pt
