#pragma once

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <string>

#if __has_include(<sys/resource.h>)  // not on Windows
#include <sys/resource.h>
#include <unistd.h>
#endif

namespace pt {

// The bytes that this program can still have: of the machine's memory, and up to its own limit (ulimit -v).
inline std::uint64_t memory_left() {
  std::uint64_t kibibytes = 0;
  std::ifstream machine("/proc/meminfo");
  for (std::string word; machine >> word;) {
    std::uint64_t value = 0;
    if ((word == "MemAvailable:" || word == "SwapFree:") && machine >> value) kibibytes += value;
  }
  std::uint64_t left = kibibytes == 0 ? UINT64_MAX : kibibytes * 1024;
#if __has_include(<sys/resource.h>)
  rlimit limit{};
  if (getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY) {
    std::uint64_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    const std::uint64_t used = pages * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
    left = std::min<std::uint64_t>(left,
                                   limit.rlim_cur - std::min<std::uint64_t>(used, limit.rlim_cur));
  }
#endif
  return left;
}

// "1.5 GB"
inline std::string shown_bytes(std::uint64_t bytes) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2g GB", static_cast<double>(bytes) * 1e-9);
  return text;
}

}  // namespace pt
