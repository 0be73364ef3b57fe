#pragma once

#include "grader/calls.h"
#include "grader/wire/argument.h"

#include <cstdint>
#include <string_view>

// Both ends: the messages between judge and worker. One conversation at a time: the judge sends a call; the
// worker may ask back any number of times, each answered at once; then it replies. A message is a
// header and a payload.
//
//   call      judge to worker   CallHead, definitions, arguments
//   ask       worker to judge   AskHead, arguments: an inner call that the judge answers itself
//   answer    judge to worker   type code, result, the sampler if there is one
//   reply     worker to judge   ReplyHead, result(s), the sampler if there is one
//   threw     worker to judge   the text of an exception: instead of a reply

namespace grader::wire {

enum class Kind : std::uint32_t { call = 1, ask, answer, reply, threw };

inline constexpr std::uint32_t kMagic = 0x544c4631;  // "1FLT"

// The most that a payload may have.
inline constexpr std::size_t kMaxPayload = std::size_t{64} << 20;

struct Header {
  std::uint32_t magic = kMagic;
  Kind kind = Kind::call;
  std::uint64_t sequence = 0;  // of the call; everything that is said about it has the same
  std::uint64_t length = 0;    // of the payload
};
static_assert(sizeof(Header) == 24);

// Calls i = first .. first + count - 1 of a batch, call i with Sampler::for_pixel(seed, i, 0).
// A single call has count 0, and its sampler is among the arguments.
struct CallBatch {
  int first = 0;
  int count = 0;
  std::uint64_t seed = 0;
};

struct CallHead {
  std::uint32_t function = 0;  // a Function
  std::uint64_t code = 0;      // of its signature
  CallBatch batch;
  bool forget = false;            // everything that was defined so far
  std::uint64_t definitions = 0;  // that follow
};

// A scene, primitives or a tree, from now on known as `handle`.
enum class ObjectKind { scene, primitives, bvh };
struct Definition {
  Handle handle = 0;
  ObjectKind kind = ObjectKind::scene;
  std::string content;
};

struct AskHead {
  std::uint32_t function = 0;
  std::uint64_t code = 0;
};

// The tests that hit_bvh made in this call. Only the integrated worker says so; when hit_bvh is
// judged by itself, the judge makes these tests and counts them.
struct Tests {
  std::vector<pt::Box> boxes;
  std::vector<pt::Triangle> triangles;
  std::vector<pt::Sphere> spheres;
};

struct ReplyHead {
  std::uint64_t code = 0;    // of the signature
  std::uint32_t todo = 0;    // bit i: task i of kTasks has called todo()
  std::int64_t closest = 0;  // rays traced in this call, says the worker: no promise counts on them
  std::int64_t occluded = 0;
  std::uint64_t kept = 0;  // where the task keeps a variable (grader/wire/kept_state.h), or 0
  Tests tests;
};

FIRSTLIGHT_FIELDS(CallBatch, first, count, seed);
FIRSTLIGHT_FIELDS(CallHead, function, code, batch, forget, definitions);
FIRSTLIGHT_FIELDS(Definition, handle, kind, content);
FIRSTLIGHT_FIELDS(AskHead, function, code);
FIRSTLIGHT_FIELDS(Tests, boxes, triangles, spheres);
FIRSTLIGHT_FIELDS(ReplyHead, code, todo, closest, occluded, kept, tests);
template <>
inline constexpr int kLargest<ObjectKind> = static_cast<int>(ObjectKind::bvh);

// A scene travels as its parts and the engine that traces it; the other side makes its own tracer.
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

// Names objects by what they are. Only the judge's own objects are hashed, so nobody looks for two
// with the same hash.
inline Handle content_hash(ObjectKind kind, std::string_view bytes) {
  std::uint64_t lanes[4] = {1, 2, 3, static_cast<std::uint64_t>(kind) + 4};
  const auto mix = [](std::uint64_t h, std::uint64_t word) {
    h = (h ^ word) * 0x9e3779b97f4a7c15;
    return h ^ (h >> 32);
  };
  std::size_t i = 0;
  for (; i + 32 <= bytes.size(); i += 32) {
    std::uint64_t words[4];
    std::memcpy(words, bytes.data() + i, 32);
    for (int lane = 0; lane < 4; ++lane) lanes[lane] = mix(lanes[lane], words[lane]);
  }
  std::uint64_t hash = bytes.size();
  for (const std::uint64_t lane : lanes) hash = mix(hash, lane);
  for (; i < bytes.size(); ++i) hash = mix(hash, static_cast<unsigned char>(bytes[i]));
  return hash;
}

}  // namespace grader::wire
