#pragma once

#include <array>
#include <cstdint>
#include <type_traits>

// The messages between the program `measure` and its workers. All are programs of one build on one
// machine, so messages are sent as they are in memory.

namespace measure::calls {

enum class What : std::uint32_t { time, find };

// A request about one case of one task, by their indices in the lists of measure/calls/tasks.h.
struct Request {
  std::uint32_t task = 0;
  std::uint32_t of_cases = 0;
  What what = What::time;
  std::uint32_t passes = 1;  // for time: how often to call the task on all inputs
  std::uint64_t seed = 0;    // for find: the seed of an estimator's random numbers
};

struct Timed {
  double seconds = 0;  // of processor time
  std::uint64_t calls = 0;
};

inline constexpr int kMaxErrors = 3;

// The results of calling the task on all inputs.
struct Found {
  std::array<double, kMaxErrors> errors{};  // the largest error of each kind in tasks.h
  double wrong = 0;     // the part of the calls with a wrong hit or a wrong miss
  double mean = 0;      // of estimators: the mean over the true mean, 1 if right
  double variance = 0;  // of one call, over the squared true mean
  double rays = 0;      // rays per call
  double boxes = 0;     // of trees: boxes tested per ray
  double primitives = 0;
  double samples = 0;  // samples per call
};

// An answer also says whether the task is written at all.
template <class Content>
struct Reply {
  std::uint64_t todo = 0;
  Content content;
};

static_assert(std::is_trivially_copyable_v<Request>);
static_assert(std::is_trivially_copyable_v<Reply<Timed>>);
static_assert(std::is_trivially_copyable_v<Reply<Found>>);

}  // namespace measure::calls
