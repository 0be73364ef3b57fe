#pragma once

#include <array>
#include <cstdint>
#include <type_traits>

// The messages between the program `measure` and its workers: programs of one build on one machine, so
// messages travel as they lie in memory.

namespace writeup::measure {

enum class What : std::uint32_t { time, find };

// About one case of one task (writeup/measure/tasks.h), by their places in the lists there.
struct Request {
  std::uint32_t task = 0;
  std::uint32_t of_cases = 0;
  What what = What::time;
  std::uint32_t passes = 1;  // time: how often it calls the task on all inputs
  std::uint64_t seed = 0;    // find: of the random numbers that an estimator draws
};

struct Timed {
  double seconds = 0;  // of processor time
  std::uint64_t calls = 0;
};

inline constexpr int kMaxErrors = 3;

// The results of calling the task on all inputs.
struct Found {
  std::array<double, kMaxErrors> errors{};  // the largest, of each kind that tasks.h names
  double wrong = 0;     // the part of the calls that hit or missed where the other is right
  double mean = 0;      // of estimators: the mean over the true mean, 1 where it is right
  double variance = 0;  // of one call, over the squared true mean
  double rays = 0;      // traced by one call
  double boxes = 0;     // tested by one ray; of trees
  double primitives = 0;
  double samples = 0;  // that one call took
};

// Either way, whether the task is written at all comes with it.
template <class Content>
struct Reply {
  std::uint64_t todo = 0;
  Content content;
};

static_assert(std::is_trivially_copyable_v<Request>);
static_assert(std::is_trivially_copyable_v<Reply<Timed>>);
static_assert(std::is_trivially_copyable_v<Reply<Found>>);

}  // namespace writeup::measure
