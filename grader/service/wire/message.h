#pragma once

#include "grader/calls.h"
#include "grader/service/wire/argument.h"
#include "pt/scene/recorder.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>
#include <vector>

// Both ends: the messages between judge and worker. There is one conversation at a time: the judge
// sends a call; the worker may ask back any number of times, and gets an answer each time; then it
// replies. A message is a header and a payload.
//
//   call      judge to worker   CallHead, definitions, arguments
//   ask       worker to judge   AskHead, arguments: an inner call that the judge answers itself
//   answer    judge to worker   type code, result, the sampler if there is one
//   reply     worker to judge   ReplyHead, result(s), the sampler if there is one
//   threw     worker to judge   the text of an exception: instead of a reply
//   asked     worker to judge   inner calls that took an answer given in advance: what `ask` would have
//   going_on  worker to judge   nothing: a call of a batch has ended, and the next has its own limit

namespace grader::wire {

enum class Kind : std::uint32_t { call = 1, ask, answer, reply, threw, asked, going_on };

inline constexpr std::uint32_t kMagic = 0x544c4631;  // "1FLT"

// The maximum size of a payload.
inline constexpr std::size_t kMaxPayload = std::size_t{64} << 20;

struct Header {
  std::uint32_t magic = kMagic;
  Kind kind = Kind::call;
  std::uint64_t sequence = 0;  // of the call, also in all messages about it
  std::uint64_t length = 0;    // of the payload
};
static_assert(sizeof(Header) == 24);

// Calls first .. first + count - 1 of a batch; call i has Sampler::for_pixel(seed, i, 0). A single
// call has count 0, and its sampler is one of the arguments.
struct CallBatch {
  int first = 0;
  int count = 0;
  std::uint64_t seed = 0;
};

// Answers of radiance() that are given in advance: one after the other, and then the last one again.
struct RadiancesAhead {
  std::vector<pt::Rgb> values;  // one at least
  int numbers = 0;              // that each call draws from its sampler
  bool are_told = true;         // the judge hears of each call
};

struct CallHead {
  std::uint32_t function = 0;  // a Function
  std::uint64_t code = 0;      // of its signature
  CallBatch batch;
  std::optional<RadiancesAhead> ahead{};
  int others = 0;  // so many more of the same call; if an answer differs, it is the answer
  bool records =
      false;  // of each call of the batch, reply what it asked too (grader/explain/record.h)
  std::uint64_t definitions = 0;  // the number of definitions that follow
};

// Defines a scene, primitives or a tree, which is called `handle` until the next one of its kind is defined.
enum class ObjectKind { scene, primitives, bvh };
inline constexpr std::size_t kObjectKinds = 3;
struct Definition {
  Handle handle = 0;
  ObjectKind kind = ObjectKind::scene;
  std::string content;
};

struct AskHead {
  std::uint32_t function = 0;
  std::uint64_t code = 0;
};

struct ReplyHead {
  std::uint64_t code = 0;    // of the signature
  std::uint32_t todo = 0;    // bit i: task i of kTasks has called todo()
  std::int64_t closest = 0;  // rays of this call, as the worker says: no promise relies on it
  std::int64_t occluded = 0;
  std::uint64_t kept = 0;  // the place of kept state (grader/service/wire/kept_state.h), or 0
  // The tests that hit_bvh made in this call. Only the integrated worker says so, and it could lie.
  // When hit_bvh is judged alone, the judge makes and counts these tests.
  pt::Tested tests;
};

FIRSTLIGHT_FIELDS(CallBatch, first, count, seed);
FIRSTLIGHT_FIELDS(RadiancesAhead, values, numbers, are_told);
FIRSTLIGHT_FIELDS(CallHead, function, code, batch, ahead, others, records, definitions);
FIRSTLIGHT_FIELDS(Definition, handle, kind, content);
FIRSTLIGHT_FIELDS(AskHead, function, code);
FIRSTLIGHT_FIELDS(pt::Tested, boxes, triangles, spheres);
FIRSTLIGHT_FIELDS(ReplyHead, code, todo, closest, occluded, kept, tests);
template <>
inline constexpr int kLargest<ObjectKind> = static_cast<int>(ObjectKind::bvh);

// A scene is sent as its parts and its engine; the other side makes its own tracer.
template <>
struct Codec<pt::Scene> {
  static void put(Writer& out, const pt::Scene& scene, pt::Engine engine) {
    const auto& [primitives, material_of, materials, lights, tracer] = scene;
    wire::put(out, primitives);
    wire::put(out, material_of);
    wire::put(out, materials);
    wire::put(out, lights);
    wire::put(out, engine);
  }
  static void put(Writer& out, const pt::Scene& scene) { put(out, scene, scene.tracer.engine()); }
  static pt::Scene get(Reader& in) {
    pt::Scene scene{wire::get<pt::Primitives>(in),
                    wire::get<std::vector<int>>(in),
                    wire::get<std::vector<pt::Material>>(in),
                    wire::get<std::vector<pt::Light>>(in),
                    {}};
    const auto engine = wire::get<pt::Engine>(in);
    scene.tracer = pt::Tracer(engine, scene.primitives);
    return scene;
  }
};

// Names objects by a hash of their content. Only the judge's own objects are hashed, so nobody can
// search for two with the same hash.
inline Handle content_hash(ObjectKind kind, std::string_view bytes) {
  return std::hash<std::string_view>{}(bytes) + static_cast<Handle>(kind);
}

}  // namespace grader::wire
