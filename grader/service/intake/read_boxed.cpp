#include "grader/service/intake/read_boxed.h"

#include "grader/service/process/run_command.h"
#include "grader/service/sandbox/launcher_messages.h"
#include "pt/error.h"

#include <chrono>
#include <csignal>
#include <filesystem>

#include <fmt/format.h>
#include <sys/wait.h>

namespace grader::intake {

namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kMaxMemory = std::uint64_t{2} << 30;
constexpr std::uint64_t kMaxFile = std::uint64_t{64} << 20;  // an owner may not have more
constexpr std::uint64_t kMaxFiles = 32;                      // open at a time

sandbox::Box box_for(const BoxedReader& reader) {
  sandbox::Box box;
  box.command = reader.command;
  box.environment = {"PATH=/usr/bin:/bin", "LANG=C.UTF-8"};
  box.descriptors = {reader.input};
  box.visible = reader.visible;
  box.visible.push_back(reader.command[0]);
  box.folder = fs::absolute(reader.folder);
  box.tools = true;  // it makes folders and files, but starts no processes
  box.limits = {reader.seconds, kMaxMemory, kMaxFile, 0, kMaxFiles};
  return box;
}

// Returns whether the program ended because of what it read: that was refused, took too long, or
// made the program crash. Anything else is the machine's fault: the disk is full, the box did not
// start, somebody killed it.
bool is_of_input(const process::CommandResult& run, int status) {
  if (run.timed_out) return true;
  if (WIFEXITED(status)) return WEXITSTATUS(status) == 2;
  const int signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  return signal == SIGXCPU || signal == SIGSEGV || signal == SIGBUS || signal == SIGABRT ||
         signal == SIGFPE || signal == SIGILL || signal == SIGSYS || signal == SIGXFSZ;
}

}  // namespace

sandbox::Tier tier_for_reading(const std::string& root, const std::string& work,
                               bool must_isolate) {
  const sandbox::Isolation found = sandbox::probe_isolation(root, work);
  if (must_isolate && found.tier == sandbox::Tier::limits) {
    throw pt::Error("nothing isolates submissions from this machine (" + found.why_not_better +
                    "); --not-isolated grades a class all the same");
  }
  // A sanitised program has no room for its shadow memory in a box.
  return process::kSanitized ? sandbox::Tier::limits : found.tier;
}

std::string read_boxed(const BoxedReader& reader, sandbox::Tier tier) {
  fs::create_directories(reader.folder);
  // The box ends a little earlier than the process that waits for it.
  const std::chrono::seconds most(5 * reader.seconds);
  const process::CommandResult run =
      process::run_command(sandbox::boxed(box_for(reader), tier), most);
  const int status = sandbox::program_status(run.status, tier);
  if (!run.timed_out && WIFEXITED(status) && WEXITSTATUS(status) == 0) return "";
  const std::string reason = process::fault_of(run);
  if (!is_of_input(run, status)) {
    throw pt::Error(
        fmt::format("'{}' could not be {}: {}; run this again", reader.name, reader.done, reason));
  }
  const std::string cannot = "cannot be " + reader.done;
  const bool says_whose = reason.find(cannot) != std::string::npos;
  return says_whose ? reason : fmt::format("'{}' {}: {}", reader.name, cannot, reason);
}

}  // namespace grader::intake
