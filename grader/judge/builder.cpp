#include "grader/judge/builder.h"

#include "grader/judge/files.h"
#include "grader/judge/sha256.h"
#include "grader/process/printable.h"
#include "grader/process/run_command.h"
#include "pt/error.h"

#include <algorithm>
#include <filesystem>
#include <sstream>

#include <fmt/format.h>

namespace grader {

namespace {

namespace fs = std::filesystem;

// A compiler can be made to work for ever, or to fill the disk.
constexpr Limits kCompilerLimits{
    .cpu_seconds = 60,
    .address_space = std::uint64_t{4} << 30,
    .file_size = std::uint64_t{256} << 20,
    .processes = {},
    .open_files = {},
};
constexpr std::chrono::seconds kCompilerTime{60};
constexpr std::size_t kMaxErrorLines = 12;

std::string headers_of(const std::string& root) {
  std::vector<std::string> paths;
  for (const auto& entry : fs::recursive_directory_iterator(root + "/pt")) {
    if (entry.path().extension() == ".h") paths.push_back(entry.path());
  }
  std::sort(paths.begin(), paths.end());
  std::string all;
  for (const std::string& path : paths) all += path + '\0' + sha256(read_file(path));
  return all;
}

bool starts_error(const std::string& line) {
  for (const char* sign : {"error:", "undefined reference to", "multiple definition of"}) {
    if (line.find(sign) != std::string::npos) return true;
  }
  return false;
}

// The first error with the lines that explain it.
std::string first_error(const CommandResult& result) {
  if (result.timed_out) return "the compiler did not finish in 60 s";
  std::istringstream lines(printable(result.output, kMaxOutput, true));
  std::string text;
  std::size_t count = 0;
  for (std::string line; std::getline(lines, line) && count < kMaxErrorLines;) {
    if (starts_error(line) && count > 0) break;
    if (count > 0 || starts_error(line)) {
      text += line + '\n';
      ++count;
    }
  }
  return text.empty() ? "the compiler ended with " + describe_status(result.status) : text;
}

Child command(const Config& config, const std::string& directory) {
  return {{config.compiler},
          {"PATH=/usr/bin:/bin", "LANG=C.UTF-8", "TMPDIR=" + config.work},
          {},
          directory,
          kCompilerLimits};
}

// Runs a command that writes to its last argument, under a name of its own until it is complete.
Built build(Child child, const std::string& path, const std::string& key) {
  if (fs::exists(path)) return {path, key, ""};
  const std::string temporary = temporary_name(path);
  child.command.push_back(temporary);
  const CommandResult result = run_command(child, kCompilerTime);
  if (!result.ok()) {
    fs::remove(temporary);
    return {"", key, first_error(result)};
  }
  fs::rename(temporary, path);
  return {path, key, ""};
}

}  // namespace

Builder::Builder(const Config& config) : config_(config), cache_(config.work + "/cache") {
  fs::create_directories(cache_);
  std::string tools = stamp(config.compiler);
  for (const auto* flags : {&config.compile_flags, &config.link_flags, &config.recording_flags}) {
    for (const std::string& flag : *flags) tools += flag + '\0';
  }
  toolchain_ = sha256(tools + headers_of(config.root));
  std::string objects;
  for (const auto* paths : {&config.framework, &config.recording}) {
    for (const std::string& path : *paths) objects += stamp(path);
  }
  framework_ = sha256(objects);
}

Built Builder::compile(const TaskConfig& task, const std::string& text) const {
  const std::string key = sha256(toolchain_ + task.file() + '\0' + text);
  const std::string tree = temporary_name(cache_ + "/" + key + ".tree");
  const std::string object = cache_ + "/" + key + ".o";
  if (fs::exists(object)) return {object, key, ""};
  fs::create_directories(tree + "/" + task.part);
  write_file(tree + "/" + task.file(), text);
  Child child = command(config_, tree);
  const auto& flags = config_.compile_flags;
  child.command.insert(child.command.end(), flags.begin(), flags.end());
  child.command.insert(child.command.end(), {"-fdiagnostics-color=never", "-c", task.file(), "-o"});
  const Built built = build(std::move(child), object, key);
  fs::remove_all(tree);
  return built;
}

Built Builder::link(const Paths& objects, const std::string& key, bool integrated) const {
  const std::string whole = sha256(framework_ + toolchain_ + key + (integrated ? "i" : "s"));
  Child child = command(config_, cache_);
  const auto add = [&](const std::vector<std::string>& more) {
    child.command.insert(child.command.end(), more.begin(), more.end());
  };
  add(config_.compile_flags);
  add(config_.framework);
  if (integrated) add(config_.recording);
  add(objects);
  add(config_.link_flags);
  if (integrated) add(config_.recording_flags);
  add({"-o"});
  return build(std::move(child), cache_ + "/" + whole + ".worker", whole);
}

}  // namespace grader
