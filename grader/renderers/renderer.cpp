#include "grader/renderers/renderer.h"

#include "grader/base/printable.h"
#include "grader/pictures/recipes/judge_recipe.h"
#include "grader/service/process/run_command.h"
#include "grader/service/sandbox/launcher_messages.h"
#include "pt/error.h"
#include "pt/image/image_io.h"

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <set>
#include <sstream>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/wait.h>

namespace grader::renderers {

using namespace pictures;

namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kMaxFile = std::uint64_t{256} << 20;  // of each file that it writes
constexpr std::uint64_t kMaxFiles = 256;                      // open at a time

bool contains(const std::vector<std::string>& words, const std::string& part) {
  return std::ranges::any_of(words, [&](const auto& word) { return word.find(part) != word.npos; });
}

void replace_all(std::string& text, const std::string& what, const std::string& by) {
  for (std::size_t at = text.find(what); at != text.npos; at = text.find(what, at + by.size())) {
    text.replace(at, what.size(), by);
  }
}

// The first {word} of lower-case letters that stands for nothing; empty if there is none.
std::string unknown_placeholder(const std::vector<std::string>& command) {
  for (const std::string& word : command) {
    for (std::size_t open = word.find('{'); open != word.npos; open = word.find('{', open + 1)) {
      const std::size_t close = word.find_first_not_of("abcdefghijklmnopqrstuvwxyz", open + 1);
      if (close == word.npos || word[close] != '}' || close == open + 1) continue;
      std::string found = word.substr(open, close + 1 - open);
      if (std::ranges::find(kPlaceholders, found) == std::end(kPlaceholders)) return found;
    }
  }
  return "";
}

bool is_of_the_system(const fs::path& program) { return program.string().starts_with("/usr/"); }

std::string last_line(const std::string& output) {
  std::istringstream lines(output);
  std::string last;
  for (std::string line; std::getline(lines, line);) {
    if (line.find_first_not_of(" \t\r") != line.npos) last = line;
  }
  return base::printable(last, 300);
}

// The fault of a run, for a person to read; empty if the program ended well.
std::string fault(const OtherRenderer& renderer, const process::CommandResult& run, int status) {
  const std::string last = last_line(run.output);
  const std::string said = last.empty() ? "" : fmt::format("; it printed last: {}", last);
  if (run.timed_out || (WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU)) {
    return fmt::format(
        "a picture took more than {} s of processor time or of sleep; give it more "
        "with --seconds{}",
        renderer.most.count(), said);
  }
  if (WIFSIGNALED(status) && WTERMSIG(status) == SIGXFSZ) {
    return fmt::format("it wrote a file of more than {} MiB{}", kMaxFile >> 20, said);
  }
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return "";
  return fmt::format("it ended with {}{}", process::describe_status(status), said);
}

}  // namespace

void require_command(const std::vector<std::string>& command) {
  if (command.empty()) {
    throw pt::Error(fmt::format("write the command that renders after --, with the words {} in it",
                                fmt::join(kPlaceholders, " ")));
  }
  if (const std::string word = unknown_placeholder(command); !word.empty()) {
    throw pt::Error(fmt::format("{} in the command stands for nothing; choose from {}", word,
                                fmt::join(kPlaceholders, " ")));
  }
  for (const char* needed : {"{scene}", "{samples}", "{seed}", "{out}"}) {
    if (!contains(command, needed)) {
      throw pt::Error(
          fmt::format("the command has no {0}; write {0} where the program takes it", needed));
    }
  }
  if (contains(command, "{from}") != contains(command, "{to}")) {
    throw pt::Error("the command has one of {from} and {to}; write both, or none");
  }
  program_of(command);
}

bool takes_bounces(const std::vector<std::string>& command) { return contains(command, "{from}"); }

std::vector<std::string> filled(const std::vector<std::string>& command, const Asked& asked,
                                const std::string& out) {
  std::vector<std::string> words = command;
  for (std::string& word : words) {
    replace_all(word, "{width}", std::to_string(asked.width));
    replace_all(word, "{height}", std::to_string(asked.height));
    replace_all(word, "{samples}", std::to_string(asked.samples));
    replace_all(word, "{depth}", std::to_string(asked.depth));
    replace_all(word, "{seed}", std::to_string(asked.seed));
    replace_all(word, "{from}", std::to_string(asked.from));
    replace_all(word, "{to}", std::to_string(asked.to));
    replace_all(word, "{scene}", asked.scene);
    replace_all(word, "{out}", out);
  }
  return words;
}

std::string program_of(const std::vector<std::string>& command) {
  const std::string& name = command.at(0);
  if (name.find('/') != name.npos) {
    if (fs::is_regular_file(name)) return fs::canonical(name);
  } else {
    const char* path = std::getenv("PATH");
    std::istringstream folders(path == nullptr ? "" : path);
    for (std::string folder; std::getline(folders, folder, ':');) {
      const fs::path program = fs::path(folder) / name;
      if (fs::is_regular_file(program)) return fs::canonical(program);
    }
  }
  throw pt::Error(
      fmt::format("there is no program {}; write its path", base::printable(name, 200)));
}

std::vector<std::string> files_of(const std::vector<std::string>& command) {
  std::set<std::string> folders;
  const fs::path program = program_of(command);
  if (is_of_the_system(program)) {
    if (fs::exists("/usr/share")) folders.insert("/usr/share");
  } else {
    folders.insert(program.parent_path());
  }
  for (std::size_t i = 1; i < command.size(); ++i) {
    if (fs::is_regular_file(command[i])) folders.insert(fs::canonical(command[i]).parent_path());
  }
  return {folders.begin(), folders.end()};
}

pt::Image render(const OtherRenderer& renderer, const Asked& asked) {
  // A picture of the run before must not stand for this one's.
  for (const fs::directory_entry& file : fs::directory_iterator(renderer.folder)) {
    fs::remove_all(file.path());
  }
  const fs::path out = fs::absolute(renderer.folder) / ("out." + renderer.format);
  sandbox::Box box;
  box.command = filled(renderer.command, asked, out);
  box.command[0] = program_of(renderer.command);
  for (std::size_t i = 1; i < box.command.size(); ++i) {
    if (fs::is_regular_file(box.command[i])) box.command[i] = fs::canonical(box.command[i]);
  }
  box.folder = fs::absolute(renderer.folder);
  box.environment = {"PATH=/usr/local/bin:/usr/bin:/bin", "LANG=C.UTF-8", "HOME=" + box.folder,
                     "TMPDIR=" + box.folder};
  box.visible = renderer.visible;
  for (const std::string& file : files_of(renderer.command)) box.visible.push_back(file);
  box.visible.push_back(fs::canonical(asked.scene).parent_path());
  box.tools = true;  // it may be a script that starts others
  // The clock of run_command stops it first, and says so.
  box.limits = {renderer.most.count() + 5, renderer.memory, kMaxFile, {}, kMaxFiles};
  const process::CommandResult run =
      process::run_command(sandbox::boxed(box, renderer.tier), renderer.most);
  const std::string problem =
      fault(renderer, run, sandbox::program_status(run.status, renderer.tier));
  if (!problem.empty()) {
    throw NoPicture{run.timed_out ? results::Cause::timeout : results::Cause::crash, problem};
  }
  if (!fs::exists(out)) {
    throw NoPicture{results::Cause::bad_reply, "it ended well and wrote no picture to {out}"};
  }
  try {
    return pt::read_image(out);
  } catch (const pt::Error& error) {
    throw NoPicture{results::Cause::bad_reply, error.what()};
  }
}

}  // namespace grader::renderers
