#pragma once

#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace grader::base {

// Calls work(i) for i = 0 .. n - 1 from a few threads. After an exception no new call begins; the
// first exception is thrown again here, after all threads have ended.
template <class Work>
void for_each(std::size_t n, int threads, const Work& work) {
  std::atomic<std::size_t> next{0};
  std::exception_ptr thrown;
  std::mutex mutex;
  const auto run = [&] {
    for (std::size_t i = next++; i < n; i = next++) {
      try {
        work(i);
      } catch (...) {
        const std::lock_guard lock(mutex);
        if (!thrown) thrown = std::current_exception();
        next = n;
      }
    }
  };
  std::vector<std::thread> others;
  for (int i = 1; i < threads; ++i) others.emplace_back(run);
  run();
  for (std::thread& other : others) other.join();
  if (thrown) std::rethrow_exception(thrown);
}

// The i-th of n things, taken by turns from both ends. Late tasks take longest: with this order, two threads
// end at nearly the same time, and the first verdict is still that of the first task.
inline std::size_t from_both_ends(std::size_t i, std::size_t n) {
  return i % 2 == 0 ? i / 2 : n - 1 - i / 2;
}

}  // namespace grader::base
