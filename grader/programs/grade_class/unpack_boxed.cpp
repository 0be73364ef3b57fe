#include "grader/programs/grade_class/unpack_boxed.h"

#include "grader/base/descriptor.h"
#include "grader/base/printable.h"
#include "grader/process/run_command.h"
#include "grader/sandbox/probe.h"
#include "grader/sandbox/told.h"

#include <chrono>
#include <filesystem>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/wait.h>

namespace grader::programs {

namespace {

namespace fs = std::filesystem;

constexpr std::chrono::minutes kMaxTime{5};
constexpr std::uint64_t kMaxSeconds = 60;
constexpr std::uint64_t kMaxMemory = std::uint64_t{2} << 30;
constexpr std::uint64_t kMaxFile = std::uint64_t{64} << 20;
constexpr std::size_t kMaxReason = 300;

std::string unpack_one(const std::string& program, sandbox::Tier tier, const std::string& archive,
                       const std::string& folder) {
  const std::string name = fs::path(archive).filename();
  const base::Descriptor file(open(archive.c_str(), O_RDONLY | O_CLOEXEC));
  if (!file.is_open()) return fmt::format("'{}' cannot be read", base::printable(name, kMaxReason));
  fs::create_directories(folder);
  sandbox::Box box;
  box.command = {program, name};
  box.environment = {"PATH=/usr/bin:/bin", "LANG=C.UTF-8"};
  box.descriptors = {file.number()};
  box.visible = {program};
  box.folder = fs::absolute(folder);
  box.tools = true;  // makes folders and files
  box.limits = {kMaxSeconds, kMaxMemory, kMaxFile, {}, {}};
  const process::CommandResult run = process::run_command(sandbox::boxed(box, tier), kMaxTime);
  const int status = sandbox::program_status(run.status, tier);
  if (!run.timed_out && WIFEXITED(status) && WEXITSTATUS(status) == 0) return "";
  const std::string reason = process::fault_of(run);
  const bool says_whose = reason.find("cannot be unpacked") != std::string::npos;
  return says_whose ? reason
                    : fmt::format("'{}' cannot be unpacked: {}", base::printable(name, kMaxReason),
                                  reason);
}

}  // namespace

intake::Unpack unpack_boxed(const judge::Config& config, const std::string& programs) {
  // A sanitised program finds no place for its shadow in a box.
  const sandbox::Tier tier = process::kSanitized
                                 ? sandbox::Tier::limits
                                 : sandbox::probe_isolation(config.root, config.work).tier;
  return [program = programs + "/unpack", tier](const std::string& archive,
                                                const std::string& folder) {
    return unpack_one(program, tier, archive, folder);
  };
}

}  // namespace grader::programs
