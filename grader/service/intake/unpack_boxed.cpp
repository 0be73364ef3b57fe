#include "grader/service/intake/unpack_boxed.h"

#include "grader/base/descriptor.h"
#include "grader/base/printable.h"
#include "grader/service/process/run_command.h"
#include "grader/service/sandbox/launcher_messages.h"
#include "grader/service/sandbox/probe.h"
#include "pt/error.h"

#include <chrono>
#include <csignal>
#include <filesystem>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/wait.h>

namespace grader::intake {

namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kMaxMemory = std::uint64_t{2} << 30;
constexpr std::uint64_t kMaxFile = std::uint64_t{64} << 20;  // an owner may not have more
constexpr std::uint64_t kMaxFiles = 32;                      // open at a time
constexpr std::size_t kMaxReason = 300;

// The limit of processor time; the box ends a little earlier than the process that waits for it.
std::uint64_t max_seconds(Extent extent) { return extent == Extent::everybody ? 3600 : 60; }

sandbox::Box box_for(const std::string& program, const std::string& name, int archive,
                     const std::string& folder, Extent extent) {
  sandbox::Box box;
  box.command = {program, name, extent == Extent::everybody ? "everybody" : "one"};
  box.environment = {"PATH=/usr/bin:/bin", "LANG=C.UTF-8"};
  box.descriptors = {archive};
  box.visible = {program};
  box.folder = fs::absolute(folder);
  box.tools = true;  // it makes folders and files, but starts no processes
  box.limits = {max_seconds(extent), kMaxMemory, kMaxFile, 0, kMaxFiles};
  return box;
}

// Returns whether the program ended because of the archive: the archive was refused, took too long,
// or made the library crash. Anything else is the machine's fault: the disk is full, the box did
// not start, somebody killed it.
bool is_of_archive(const process::CommandResult& run, int status) {
  if (run.timed_out) return true;
  if (WIFEXITED(status)) return WEXITSTATUS(status) == 2;
  const int signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  return signal == SIGXCPU || signal == SIGSEGV || signal == SIGBUS || signal == SIGABRT ||
         signal == SIGFPE || signal == SIGILL || signal == SIGSYS || signal == SIGXFSZ;
}

std::string unpack_one(const std::string& program, sandbox::Tier tier, const std::string& archive,
                       const std::string& folder, Extent extent) {
  const std::string name = base::printable(fs::path(archive).filename().string(), kMaxReason);
  const base::Descriptor file(open(archive.c_str(), O_RDONLY | O_CLOEXEC));
  if (!file.is_open()) return fmt::format("'{}' cannot be read", name);
  fs::create_directories(folder);
  const std::string own_name = fs::path(archive).filename();
  const sandbox::Box box = box_for(program, own_name, file.number(), folder, extent);
  const std::chrono::seconds most(5 * max_seconds(extent));
  const process::CommandResult run = process::run_command(sandbox::boxed(box, tier), most);
  const int status = sandbox::program_status(run.status, tier);
  if (!run.timed_out && WIFEXITED(status) && WEXITSTATUS(status) == 0) return "";
  const std::string reason = process::fault_of(run);
  if (!is_of_archive(run, status)) {
    throw pt::Error(fmt::format("'{}' could not be unpacked: {}; run this again", name, reason));
  }
  const bool says_whose = reason.find("cannot be unpacked") != std::string::npos;
  return says_whose ? reason : fmt::format("'{}' cannot be unpacked: {}", name, reason);
}

}  // namespace

Unpack unpack_boxed(const std::string& root, const std::string& work, const std::string& programs,
                    bool must_isolate) {
  const std::string program = programs + "/unpack";
  if (!fs::exists(program)) {
    return [](const std::string& archive, const std::string&, Extent) {
      return fmt::format("'{}' cannot be unpacked here; unpack it first",
                         base::printable(fs::path(archive).filename().string(), kMaxReason));
    };
  }
  const sandbox::Isolation found = sandbox::probe_isolation(root, work);
  if (must_isolate && found.tier == sandbox::Tier::limits) {
    throw pt::Error("nothing isolates submissions from this machine (" + found.why_not_better +
                    "); --not-isolated grades a class all the same");
  }
  // A sanitised program has no room for its shadow memory in a box.
  const sandbox::Tier tier = process::kSanitized ? sandbox::Tier::limits : found.tier;
  return [program, tier](const std::string& archive, const std::string& folder, Extent extent) {
    return unpack_one(program, tier, archive, folder, extent);
  };
}

}  // namespace grader::intake
