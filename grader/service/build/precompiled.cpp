#include "grader/service/build/precompiled.h"

#include "grader/base/sha256.h"
#include "grader/service/build/cache.h"
#include "grader/service/process/run_command.h"
#include "pt/error.h"
#include "pt/file.h"

#include <filesystem>
#include <sstream>

namespace grader::build {

namespace {

namespace fs = std::filesystem;

constexpr std::chrono::seconds kMaxTimeToMake{60};

// The directive of a line, such as "#include <cmath>", without blanks; empty if there is none.
std::string directive_in(const std::string& line) {
  std::string text;
  for (const char c : line) {
    if (c != ' ' && c != '\t') text += c;
  }
  return text.starts_with('#') ? text : "";
}

// Returns whether a header that the contract includes means the same if it is included before the
// first line: a macro of the file could change a header. So only other headers may come before the
// contract.
bool starts_with_headers(const std::string& text, const std::string& contract) {
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const std::string directive = directive_in(line);
    if (directive == "#include\"" + contract + '"') return true;
    if (!directive.empty() && !directive.starts_with("#include")) return false;
  }
  return false;
}

}  // namespace

PrecompiledHeaders::PrecompiledHeaders(const Config& config, Headers headers)
    : config_(config), headers_(std::move(headers)) {
  kept_[0].included = "pt/scene/scene.h";
  kept_[1].included = "pt/math/vec3.h";
  std::string all = base::stamp(config.compiler) + config.compiler_version;
  for (const std::string& flag : config.compile_flags) all += flag + '\0';
  for (const auto& [path, text] : headers_) all += path + '\0' + base::sha256(text);
  folder_ = config.work + "/headers/" + base::sha256(all);
}

std::string PrecompiledHeaders::path_of(const Header& header) const {
  return folder_ + '/' + fs::path(header.included).filename().string();
}

std::vector<std::string> PrecompiledHeaders::flags_for(const TaskConfig& task,
                                                       const std::string& text) const {
  const std::string contract = "pt/tasks/" + task.slug + ".h";
  if (!config_.compiler_version.starts_with("GNU ")) return {};
  if (!starts_with_headers(text, contract)) return {};
  const std::set<std::string> reached = reached_from(contract, headers_);
  for (const Header& header : kept_) {
    if (!reached.contains(header.included)) continue;
    mark_used(folder_);
    std::call_once(header.once, [&] { make(header); });
    if (!header.there) continue;
    return {"-include", path_of(header)};
  }
  return {};
}

// If a header cannot be precompiled, files are compiled without it. Another judge may make the same
// header at the same time: both write under names of their own, and the last one stays.
void PrecompiledHeaders::make(const Header& header) const try {
  const std::string path = path_of(header), made = path + ".gch";
  if (!fs::exists(made)) {
    // The temporary files are in the cache: the next run removes what a killed run leaves.
    const fs::path cache = config_.work + "/cache";
    for (const fs::path& folder : {cache, fs::path(folder_)}) fs::create_directories(folder);
    remove_unused_beside(folder_);
    pt::write_file(path, "#include \"" + header.included + "\"\n");
    const std::string temporary = pt::temporary_name(cache / fs::path(made).filename());
    const ToolFolder folder(pt::temporary_name(cache / "headers.tree"));
    for (const auto& [name, text] : headers_) folder.put(name, text);
    if (!compiled(path, folder.folder(), temporary)) {
      fs::remove(temporary);
      return;
    }
    // Another user reads the file.
    fs::permissions(temporary, fs::perms(0644));
    fs::rename(temporary, made);
  }
  header.there = true;
} catch (const std::exception&) {
}

bool PrecompiledHeaders::compiled(const std::string& path, const std::string& folder,
                                  const std::string& output) const {
  process::Child child{{config_.compiler}, {"PATH=/usr/bin:/bin", "LANG=C.UTF-8"}, {}, folder, {}};
  std::vector<std::string>& words = child.command;
  words.insert(words.end(), config_.compile_flags.begin(), config_.compile_flags.end());
  for (const char* word : {"-I.", "-x", "c++-header", path.c_str(), "-o", output.c_str()}) {
    words.emplace_back(word);
  }
  return process::run_command(child, kMaxTimeToMake).ok();
}

}  // namespace grader::build
