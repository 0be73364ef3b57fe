#pragma once

#include <thread>
#include <vector>

namespace pt {

// Calls work(0), work(1), ... in so many threads at the same time, this one included, and waits for all of them. std::jthread is not in
// every library.
template <class Work>
void in_threads(int count, const Work& work) {
  struct Threads {
    std::vector<std::thread> list;
    ~Threads() {
      for (std::thread& thread : list) thread.join();
    }
  } threads;
  for (int i = 1; i < count; ++i) threads.list.emplace_back([&work, i] { work(i); });
  work(0);
}

}  // namespace pt
