#pragma once

#include <cstdint>
#include <optional>

namespace grader::process {

// Limits of one process; an empty value is no limit. Children inherit the limits, each with its own
// count. Only `processes` counts all processes of the user together.
struct Limits {
  std::optional<std::uint64_t> cpu_seconds;
  std::optional<std::uint64_t> address_space;  // bytes; not applied to sanitised programs
  std::optional<std::uint64_t> file_size;      // bytes, of each file that it writes
  std::optional<std::uint64_t> processes;      // of the user, not enforced for root
  std::optional<std::uint64_t> open_files;
};

// Sets the limits of this process, irrevocably, and disables core files. Returns false if the
// kernel refuses. Allocates nothing, so it may be called between fork and exec.
[[nodiscard]] bool set_limits(const Limits& limits);

// True if this build uses a sanitiser, which reserves more address space than any limit (cmake/options.cmake).
#if defined(FIRSTLIGHT_SANITIZED)
inline constexpr bool kSanitized = true;
#else
inline constexpr bool kSanitized = false;
#endif

}  // namespace grader::process
