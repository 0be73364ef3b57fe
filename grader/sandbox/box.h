#pragma once

#include "grader/process/spawn.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

// The box in which programs run that come from a submission, or that read one.
// docs/decisions/0020-sandbox.md says what each tier holds.

namespace grader::sandbox {

// From the best: each is tried (grader/sandbox/probe.h), and the first that works here is used.
enum class Tier {
  bubblewrap,  // A: namespaces of its own; Landlock and seccomp as in B
  restricted,  // B: another user where we are root, Landlock and seccomp where there are any
  limits,      // C: nothing but limits
};

// 'A', 'B' or 'C', and the way back. Throws pt::Error for other words.
char letter(Tier tier);
Tier tier_of(std::string_view word);

// A program and what it gets. Beside that it sees the system's libraries, and the compiler and its
// headers if it is one of the `tools`: no other file, no other process, no network. How long it may
// run is up to who starts it.
struct Box {
  std::vector<std::string> command;      // argv; the program is a path
  std::vector<std::string> environment;  // "NAME=value", all of it
  std::vector<int> descriptors;          // entry i becomes descriptor i; all others are closed
  std::vector<std::string> visible;      // files and folders it may read, besides its program
  std::string folder;                    // it may write in, and starts in; empty: none, and "/"
  bool tools = false;                    // it may start programs, as a compiler does
  process::Limits limits;
  // The last of the descriptors is not the program's but the launcher's: one byte comes there when
  // nothing but the program itself is left to start, a second one if that fails, and in tier A the
  // program's status when it has ended (grader/sandbox/launcher_messages.h). Not in tier C.
  bool tells_start = false;
};

// The child that runs the box's program in this tier. In tier A, as root, it gets a user that no other box has; throws
// pt::Error if all are taken. In tiers A and B, all processes of the box end when the program, the started child or this
// process ends. There, a program that cannot be started exits with 127 and one sentence.
process::Child boxed(const Box& box, Tier tier);

// The launcher: the program `box`, next to the program that runs.
std::string launcher_path();

// The newest version of Landlock that boxes may use, if the environment variable FIRSTLIGHT_LANDLOCK is
// set: tests try attacks as on older kernels (5: without scopes; 0: without Landlock). Throws pt::Error
// if it is not a number.
inline constexpr const char* kLandlockVariable = "FIRSTLIGHT_LANDLOCK";
std::optional<int> landlock_at_most();

// The environment of programs of ours that start boxes: plain, and with that variable if it is there.
std::vector<std::string> judges_environment();

}  // namespace grader::sandbox
