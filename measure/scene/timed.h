#pragma once

#include "grader/base/parallel.h"
#include "pt/render/cpu_time.h"

#include <algorithm>
#include <cstddef>
#include <mutex>

namespace measure::scene {

// Calls work(i) for every i < count on a few threads. Returns the processor time of all.
template <class Work>
double timed(std::size_t count, int threads, const Work& work) {
  constexpr std::size_t kPiece = 64;  // items that a thread takes at a time
  double seconds = 0;
  std::mutex mutex;
  grader::base::for_each((count + kPiece - 1) / kPiece, threads, [&](std::size_t piece) {
    const double start = pt::thread_cpu_seconds();
    for (std::size_t i = piece * kPiece; i < std::min(count, (piece + 1) * kPiece); ++i) work(i);
    const std::lock_guard lock(mutex);
    seconds += pt::thread_cpu_seconds() - start;
  });
  return seconds;
}

}  // namespace measure::scene
