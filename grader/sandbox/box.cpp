#include "grader/sandbox/box.h"

#include "grader/process/run_command.h"
#include "pt/error.h"

#include <filesystem>

#include <fmt/format.h>
#include <sys/wait.h>

namespace grader::sandbox {

namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

constexpr const char* kBubblewrap = "/usr/bin/bwrap";

Words operator+(Words words, const Words& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

// The launcher stands next to the program that runs.
std::string launcher_path() {
  static const std::string path = fs::read_symlink("/proc/self/exe").parent_path() / "box";
  return path;
}

// The folders of the system that a program needs. Not all of /usr: a project may lie in there.
Words system_files(bool tools) {
  Words names{"/usr/lib",       "/usr/lib32",       "/usr/lib64",      "/usr/libx32",
              "/usr/local/lib", "/usr/local/lib64", "/etc/ld.so.cache"};
  if (tools) {
    names = names + Words{"/usr/bin",         "/usr/libexec",       "/usr/include",
                          "/usr/local/bin",   "/usr/local/libexec", "/usr/local/include",
                          "/etc/alternatives"};
  }
  std::erase_if(names, [](const std::string& name) { return !fs::exists(name); });
  return names;
}

Words launcher(const Box& box, const Words& visible, bool inside) {
  Words words{launcher_path()};
  const auto add = [&](const char* name, const std::optional<std::uint64_t>& limit) {
    if (limit) words.push_back(fmt::format("--{}={}", name, *limit));
  };
  add("cpu", box.limits.cpu_seconds);
  add("memory", box.limits.address_space);
  add("file-size", box.limits.file_size);
  add("processes", box.limits.processes);
  add("files", box.limits.open_files);
  for (const std::string& path : visible) words.push_back("--visible=" + path);
  if (!box.folder.empty()) words.push_back("--folder=" + box.folder);
  if (box.tools) words.push_back("--tools");
  if (inside) words.push_back("--inside");
  words.push_back("--");
  return words + box.command;
}

// /lib and its like are links into /usr on most systems, and folders on the others.
Words root_folders() {
  Words words;
  for (const char* name : {"/bin", "/lib", "/lib32", "/lib64", "/libx32"}) {
    if (fs::is_symlink(name)) {
      words = words + Words{"--symlink", fs::read_symlink(name), name};
    } else if (fs::is_directory(name)) {
      words = words + Words{"--ro-bind", name, name};
    }
  }
  return words;
}

// Older ones lack it. The launcher's filter forbids new namespaces as well.
Words disable_userns() {
  static const bool known =
      process::run_command({{kBubblewrap, "--help"}, {}, {}, "", {}}, std::chrono::seconds(5))
          .output.find("--disable-userns") != std::string::npos;
  return known ? Words{"--disable-userns"} : Words{};
}

Words bubblewrap(const Box& box, const Words& visible) {
  Words words = Words{kBubblewrap, "--unshare-all",     "--unshare-user", "--cap-drop",
                      "ALL",       "--die-with-parent", "--new-session",  "--as-pid-1"} +
                disable_userns() + root_folders();
  for (const std::string& path : visible) words = words + Words{"--ro-bind", path, path};
  words = words + Words{"--dev-bind", "/dev/null", "/dev/null"} +
          Words{"--ro-bind", launcher_path(), launcher_path()};
  if (!box.folder.empty()) words = words + Words{"--bind", box.folder, box.folder};
  words = words + Words{"--remount-ro", "/", "--chdir", "/", "--"};
  return words + launcher(box, visible, true);
}

}  // namespace

char letter(Tier tier) { return "ABC"[static_cast<int>(tier)]; }

Tier tier_of(std::string_view word) {
  for (const Tier tier : {Tier::bubblewrap, Tier::restricted, Tier::limits}) {
    if (word.size() == 1 && word[0] == letter(tier)) return tier;
  }
  throw pt::Error(fmt::format("'{}' is not a tier of isolation: write A, B or C", word));
}

process::Child boxed(const Box& box, Tier tier) {
  if (tier == Tier::limits) {
    return {box.command, box.environment, box.descriptors, box.folder.empty() ? "/" : box.folder,
            box.limits};
  }
  Words visible = system_files(box.tools) + box.visible;
  if (!box.tools) visible.push_back(box.command.at(0));
  return {tier == Tier::bubblewrap ? bubblewrap(box, visible) : launcher(box, visible, false),
          box.environment,
          box.descriptors,
          "/",
          {}};
}

// The launcher inside bubblewrap says it as a shell does.
int program_status(int status, Tier tier) {
  const int code = WIFEXITED(status) ? WEXITSTATUS(status) : 0;
  return tier == Tier::bubblewrap && code > 128 && code <= 128 + 64 ? code - 128 : status;
}

}  // namespace grader::sandbox
