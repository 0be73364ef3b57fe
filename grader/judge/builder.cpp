#include "grader/judge/builder.h"

#include "grader/base/printable.h"
#include "grader/base/sha256.h"
#include "grader/judge/audit.h"
#include "grader/judge/cache.h"
#include "grader/judge/object_file.h"
#include "grader/judge/submission_flags.h"
#include "grader/process/run_command.h"
#include "grader/tasks.h"
#include "pt/error.h"

#include <filesystem>
#include <sstream>

#include <fmt/format.h>

namespace grader::judge {

namespace {

namespace fs = std::filesystem;

// A compiler can be made to work for ever, or to fill the disk.
constexpr process::Limits kCompilerLimits{
    .cpu_seconds = {},
    .address_space = std::uint64_t{4} << 30,
    .file_size = std::uint64_t{256} << 20,
    .processes = 64,
    .open_files = 256,
};
constexpr std::size_t kMaxErrorLines = 12;

// Far above what any task compiles to.
constexpr std::size_t kMaxObject = std::size_t{16} << 20;

constexpr std::size_t kMaxWarningLines = 40;

// The warnings about the file itself, each with the lines that explain it.
std::string warnings_of(const std::string& output, const std::string& file) {
  std::istringstream lines(base::printable(output, process::kMaxOutput, true));
  std::string text;
  std::size_t count = 0;
  bool about_file = false;
  for (std::string line; std::getline(lines, line) && count < kMaxWarningLines;) {
    const bool explains = line.starts_with(' ');
    if (!explains) about_file = line.starts_with(file + ":");
    const bool starts =
        line.find(" warning: ") != std::string::npos || line.find(" note: ") != std::string::npos;
    if (!about_file || (!explains && !starts)) continue;
    text += line + '\n';
    ++count;
  }
  return text;
}

bool starts_error(const std::string& line) {
  for (const char* sign :
       {"error:", "Error:", "undefined reference to", "multiple definition of"}) {
    if (line.find(sign) != std::string::npos) return true;
  }
  return false;
}

// The first error with the lines that explain it.
std::string first_error(const process::CommandResult& result, int seconds) {
  if (result.timed_out) return fmt::format("the compiler did not finish in {} s", seconds);
  std::istringstream lines(base::printable(result.output, process::kMaxOutput, true));
  std::string text;
  std::size_t count = 0;
  for (std::string line; std::getline(lines, line) && count < kMaxErrorLines;) {
    if (starts_error(line) && count > 0) break;
    if (count > 0 || starts_error(line)) {
      text += line + '\n';
      ++count;
    }
  }
  return text.empty() ? "the compiler ended with " + process::describe_status(result.status) : text;
}

// Headers were found below the project, for all that a person has to know.
std::string in_project(std::string text, const std::string& root) {
  for (std::size_t at = text.find("./pt/"); at != text.npos; at = text.find("./pt/", at + 1)) {
    text.replace(at, 1, root);
    at += root.size();
  }
  return text;
}

}  // namespace

Builder::Builder(const Config& config, sandbox::Tier tier, int seconds)
    : config_(config),
      tier_(tier),
      seconds_(seconds),
      cache_(config.work + "/cache"),
      headers_(public_headers(config.root)) {
  fs::create_directories(cache_);
  // An object that was compiled where more can be read, or audited by another judge, is not used.
  std::string tools = base::stamp(config.compiler) +
                      base::stamp(fs::read_symlink("/proc/self/exe")) + sandbox::letter(tier);
  for (const char* flag : kSubmissionFlags) tools += std::string(flag) + '\0';
  for (const auto* flags : {&config.compile_flags, &config.link_flags, &config.recording_flags}) {
    for (const std::string& flag : *flags) tools += flag + '\0';
  }
  for (const auto& [path, text] : headers_) tools += path + '\0' + base::sha256(text);
  toolchain_ = base::sha256(tools);
  std::string objects;
  for (const auto* paths : {&config.framework, &config.recording}) {
    for (const std::string& path : *paths) objects += base::stamp(path);
  }
  framework_ = base::sha256(objects);
}

Built Builder::compile(const TaskConfig& task, const std::string& text) const {
  const std::string key = base::sha256(toolchain_ + task.file() + '\0' + text);
  const std::string path = cache_ + "/" + key + ".o";
  const std::string warnings_path = cache_ + "/" + key + ".warnings";
  if (fs::exists(path)) {
    mark_used(path);
    return {path, key, "", "", fs::exists(warnings_path) ? base::read_file(warnings_path) : ""};
  }
  const Stage stage(base::temporary_name(cache_ + "/" + key + ".tree"),
                    headers_for(task_of(task.slug), headers_), task.file(), text);
  sandbox::Box box{{config_.compiler},
                   {"PATH=/usr/bin:/bin", "LANG=C.UTF-8", "TMPDIR=."},
                   {},
                   {},
                   stage.folder(),
                   true,
                   kCompilerLimits};
  box.limits.cpu_seconds = seconds_;
  const auto& flags = config_.compile_flags;
  box.command.insert(box.command.end(), flags.begin(), flags.end());
  box.command.insert(box.command.end(), kSubmissionFlags.begin(), kSubmissionFlags.end());
  box.command.insert(box.command.end(),
                     {"-I.", "-fdiagnostics-color=never", "-c", task.file(), "-o", "task.o"});
  process::CommandResult result =
      process::run_command(sandbox::boxed(box, tier_), std::chrono::seconds(seconds_));
  const std::string warnings = warnings_of(result.output, task.file());
  if (result.ok() && warnings.find(kNoReturn) != std::string::npos) {
    box.command.insert(box.command.end(), kTrapFlags.begin(), kTrapFlags.end());
    result = process::run_command(sandbox::boxed(box, tier_), std::chrono::seconds(seconds_));
  }
  if (!result.ok()) {
    return {"", key, in_project(first_error(result, seconds_), config_.root), "", ""};
  }
  const base::Submitted object = stage.take("task.o", kMaxObject);
  if (!object.present || !object.rejected.empty()) {
    return {"", key, "", "the compiled object is not accepted: " + object.rejected, ""};
  }
  std::set<std::string> contract;
  for (const std::string& reference : task.reference) {
    contract.merge(functions_in(base::read_file(reference)));
  }
  const std::string reason = audit(object.text, contract, task_of(task.slug));
  if (!reason.empty()) return {"", key, "", reason, ""};
  if (!warnings.empty()) base::write_file(warnings_path, warnings);
  base::write_file(path, with_state_marked(object.text));
  return {path, key, "", "", warnings};
}

// Outside the box: an object that has passed the audit has nothing in it that tells the linker to
// read other files, or to run the compiler.
Built Builder::link(const Paths& objects, const std::string& key, bool integrated) const {
  const std::string whole = base::sha256(framework_ + toolchain_ + key + (integrated ? "i" : "s"));
  const std::string path = cache_ + "/" + whole + ".worker";
  if (fs::exists(path)) {
    mark_used(path);
    return {path, whole, "", "", ""};
  }
  const std::string temporary = base::temporary_name(path);
  process::Child child{{config_.compiler},
                       {"PATH=/usr/bin:/bin", "LANG=C.UTF-8", "TMPDIR=" + config_.work},
                       {},
                       cache_,
                       kCompilerLimits};
  child.limits.processes.reset();
  const auto add = [&](const std::vector<std::string>& more) {
    child.command.insert(child.command.end(), more.begin(), more.end());
  };
  add(config_.compile_flags);
  add(config_.framework);
  if (integrated) add(config_.recording);
  add(objects);
  add(config_.link_flags);
  if (integrated) add(config_.recording_flags);
  add({"-o", temporary});
  const process::CommandResult result = process::run_command(child, std::chrono::seconds(seconds_));
  if (!result.ok()) {
    fs::remove(temporary);
    return {"", whole, first_error(result, seconds_), "", ""};
  }
  // Another user runs it.
  fs::permissions(temporary, fs::perms(0755));
  fs::rename(temporary, path);
  return {path, whole, "", "", ""};
}

}  // namespace grader::judge
