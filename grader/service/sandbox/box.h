#pragma once

#include "grader/service/process/spawn.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

// The box for programs that come from a submission, or that read a submission.
// docs/decisions/0020-sandbox.md describes the tiers.

namespace grader::sandbox {

// The best tier comes first. grader/service/sandbox/probe.h finds the first that works.
enum class Tier {
  bubblewrap,  // A: namespaces of its own; Landlock and seccomp as in B
  restricted,  // B: another user if we are root; Landlock and seccomp if available
  limits,      // C: only limits
};

// Converts from and to 'A', 'B' or 'C'. Throws pt::Error for other words.
char letter(Tier tier);
Tier tier_of(std::string_view word);

// A program and what it gets. It also sees the system's libraries, and if `tools` the compiler and
// its headers, but no other file, no other process and no network. The caller limits its running
// time.
struct Box {
  std::vector<std::string> command;      // argv; the program is a path
  std::vector<std::string> environment;  // "NAME=value", all of it
  std::vector<int> descriptors;          // entry i becomes descriptor i; all others are closed
  std::vector<std::string> visible;      // files and folders it may read, besides its program
  std::string folder;                    // it starts and may write here; empty: "/", read-only
  bool tools = false;                    // it may start programs, as a compiler does
  process::Limits limits;
  // The last descriptor belongs to the launcher, not to the program. The launcher writes one byte
  // when only the program itself is left to start, a second byte if that fails, and in tier A the
  // program's status when it has ended (grader/service/sandbox/launcher_messages.h). Not in tier C.
  bool tells_start = false;
};

// The box of a program that is linked with somebody's functions: it writes no file and starts no process. The judge's own clock
// usually stops it; the limit on processor time only matters if the judge itself is gone.
Box box_of_functions(const std::string& program, std::uint64_t cpu_seconds);

// The child that runs the box's program in this tier. In tier A, as root, it gets a user that no
// other box has; throws pt::Error if all are taken. In tiers A and B, all processes of the box end
// with the program, the child or this process; a program that cannot be started exits with 127 and
// one sentence.
process::Child boxed(const Box& box, Tier tier);

// The launcher: the program `box`, next to the program that runs.
std::string launcher_path();

// The newest version of Landlock that boxes may use, from the environment variable
// FIRSTLIGHT_LANDLOCK: with it, tests try attacks as on older kernels (5: without scopes; 0:
// without Landlock). Throws pt::Error if it is not a number.
inline constexpr const char* kLandlockVariable = "FIRSTLIGHT_LANDLOCK";
std::optional<int> landlock_at_most();

// The environment of our programs that start boxes: plain, plus that variable if it is set.
std::vector<std::string> judges_environment();

}  // namespace grader::sandbox
