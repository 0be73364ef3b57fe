#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <sys/types.h>

namespace grader {

// What a child process may use at most; nothing means no limit of our own. They are a process's,
// not its children's.
struct Limits {
  std::optional<std::uint64_t> cpu_seconds;
  std::optional<std::uint64_t> address_space;  // bytes; not applied to sanitised programs
  std::optional<std::uint64_t> file_size;      // bytes, of any file it writes
  std::optional<std::uint64_t> processes;      // of the user, not enforced for root
  std::optional<std::uint64_t> open_files;
};

struct Child {
  std::vector<std::string> command;      // argv; the program is a path
  std::vector<std::string> environment;  // "NAME=value", all of it
  std::vector<int> descriptors;          // entry i becomes descriptor i; all others are closed
  std::string directory;                 // to run in; empty: this one
  Limits limits;
};

// Starts the child in a process group of its own. It dies with the thread that started it, gains no
// privileges, leaves no core, and finds SIGPIPE ignored. This is the one place where programs of a
// submission start, and where a sandbox goes. Throws pt::Error if there is no process to be had; a
// program that cannot be run exits with 127.
pid_t spawn(const Child& child);

// Ends the child and its group, and takes its exit status (as waitpid gives it).
int kill_child(pid_t pid);

// "signal 11 (Segmentation fault)" or "exit status 0".
std::string describe_status(int status);

// Whether this build uses AddressSanitizer, which reserves more address space than any limit.
#if defined(__SANITIZE_ADDRESS__)
inline constexpr bool kSanitized = true;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
inline constexpr bool kSanitized = true;
#else
inline constexpr bool kSanitized = false;
#endif
#else
inline constexpr bool kSanitized = false;
#endif

// Other processes of the same user cannot read or trace this one any more.
void hide_process();

}  // namespace grader
