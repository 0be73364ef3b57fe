#include "grader/service/sandbox/probe.h"

#include "grader/base/files.h"
#include "grader/base/parallel.h"
#include "grader/base/printable.h"
#include "grader/service/process/run_command.h"
#include "pt/error.h"
#include "pt/file.h"

#include <array>
#include <filesystem>
#include <set>
#include <sstream>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace grader::sandbox {

namespace {

namespace fs = std::filesystem;

struct Trial {
  std::string words;    // empty if the tier does not work
  std::string problem;  // the reason for that
};

// A new folder, which the destructor removes.
struct Scratch {
  std::string path;
  explicit Scratch(const std::string& work) {
    std::error_code error;
    fs::create_directories(work, error);
    if (!error) path = pt::temporary_name(fs::canonical(work, error) / "probe");
    if (!error) fs::create_directory(path, error);
    if (!error) fs::permissions(path, fs::perms(0755), error);  // whatever the umask is
    if (error) throw pt::Error(work + ": no folder can be made here (" + error.message() + ")");
  }
  ~Scratch() {
    std::error_code ignored;
    fs::remove_all(path, ignored);
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
};

std::string asked_of_landlock() {
  const std::optional<int> newest = landlock_at_most();
  return newest ? fmt::format("; Landlock {} at most, as {} asks", *newest, kLandlockVariable) : "";
}

std::string words_of(Tier tier, const std::set<std::string>& holds) {
  std::vector<std::string> parts;
  if (tier == Tier::restricted || holds.contains("user")) {
    parts.emplace_back(holds.contains("user") ? "another user" : "the same user");
  }
  if (holds.contains("sockets")) parts.emplace_back("seccomp");
  if (tier == Tier::restricted && holds.contains("files")) parts.emplace_back("Landlock");
  std::string list = fmt::format("{}", fmt::join(parts, ", "));
  if (const std::size_t last = list.rfind(", "); last != list.npos) list.replace(last, 1, " and");
  if (tier == Tier::bubblewrap) {
    return "A: bubblewrap" + (list.empty() ? "" : " with " + list + " in it") + asked_of_landlock();
  }
  if (!holds.contains("sockets")) list += "; the network is open";
  if (!holds.contains("files")) list += "; other files are open to it as to everyone";
  return "B: " + list + asked_of_landlock();
}

std::set<std::string> what_holds(const process::CommandResult& result) {
  std::istringstream lines(result.output);
  std::set<std::string> holds;
  for (std::string line; std::getline(lines, line);) holds.insert(line);
  return holds;
}

// `folder` is the box's own. The box also sees `kept`, as a compiler's box sees headers.
process::CommandResult run_probe(const std::string& root, const std::string& folder,
                                 const std::string& kept, Tier tier) {
  const std::string program = base::programs_folder() + "/box_probe";
  Box box{{program, root + "/CMakeLists.txt", std::to_string(getuid()), kept},
          {},
          {},
          {},
          folder,
          false,
          {}};
  box.tools = !folder.empty();
  if (box.tools) box.visible = {program, kept};
  box.limits = {.cpu_seconds = 10,
                .address_space = std::uint64_t{1} << 30,
                .file_size = std::uint64_t{1} << 20,
                .processes = box.tools ? 64 : 0,
                .open_files = 16};
  return process::run_command(boxed(box, tier), std::chrono::seconds(10));
}

// Bubblewrap's message goes on with hints on where to read more.
std::string first_sentence(const std::string& text) {
  const std::string line = text.substr(0, text.find('\n'));
  return base::printable(line.substr(0, line.find(". ")), 200);
}

Trial try_tier(const std::string& root, const std::string& work, Tier tier) {
  const Scratch scratch(work), kept(work);
  std::set<std::string> holds;
  const std::array<std::string, 2> folders{"", scratch.path};
  std::array<process::CommandResult, 2> results;
  base::for_each(folders.size(), 2,
                 [&](std::size_t i) { results[i] = run_probe(root, folders[i], kept.path, tier); });
  for (std::size_t i = 0; i < folders.size(); ++i) {
    const std::string& folder = folders[i];
    const process::CommandResult& result = results[i];
    if (!result.ok()) {
      return {"", first_sentence(result.output)};
    }
    const std::set<std::string> now = what_holds(result);
    if (!now.contains("root")) {
      return {"", fmt::format("there is no Landlock, and everybody may read {} (chmod 711 the "
                              "folders on the way to {}, "
                              "and go-rwx all else)",
                              root, work)};
    }
    if (!folder.empty() && !now.contains("write")) return {"", "it cannot write in a folder"};
    if (!folder.empty() && !now.contains("kept")) {
      return {"", fmt::format("its user cannot reach {} (chmod go+x that folder and those above)",
                              work)};
    }
    if (folder.empty()) holds = now;
  }
  if (tier == Tier::restricted && !holds.contains("processes")) {
    return {"", "a program in it can start others"};
  }
  return {words_of(tier, holds), ""};
}

}  // namespace

const char* describe(Tier tier) {
  switch (tier) {
    case Tier::bubblewrap:
      return "A: bubblewrap";
    case Tier::restricted:
      return "B: another user, seccomp and Landlock";
    default:
      return "C: rlimits only, not isolated";
  }
}

Isolation probe_isolation(const std::string& root, const std::string& work,
                          std::optional<Tier> forced) {
  Isolation found{Tier::limits, describe(Tier::limits), ""};
  for (const Tier tier : {Tier::bubblewrap, Tier::restricted}) {
    if (forced && *forced != tier) continue;
    // A sanitised program needs more memory and system calls than a box allows.
    const Trial trial = process::kSanitized ? Trial{"", "it is not for sanitised programs"}
                                            : try_tier(root, work, tier);
    if (!trial.words.empty()) return {tier, trial.words, found.why_not_better};
    found.why_not_better += fmt::format("{}{}: {}", found.why_not_better.empty() ? "" : "; ",
                                        letter(tier), trial.problem);
  }
  if (forced && *forced != Tier::limits) {
    throw pt::Error("isolation does not work here as asked: " + found.why_not_better);
  }
  if (!found.why_not_better.empty()) found.words += " (" + found.why_not_better + ")";
  return found;
}

}  // namespace grader::sandbox
