#include "grader/service/sandbox/box.h"

#include "grader/base/files.h"
#include "grader/base/printable.h"
#include "grader/service/process/run_command.h"
#include "grader/service/sandbox/users.h"
#include "pt/error.h"
#include "pt/number.h"

#include <atomic>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <utility>

#include <fmt/format.h>
#include <unistd.h>

namespace grader::sandbox {

namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

constexpr const char* kBubblewrap = "/usr/bin/bwrap";

Words operator+(Words words, const Words& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

// The folders of the system that a program needs. Not all of /usr: a project may be in it.
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

// A program in its own namespaces sees no other process of its user. But a limit on processes
// counts all of them together, those of other judges too.
std::shared_ptr<const User> user_inside() {
  static std::atomic<unsigned> serial{0};
  const unsigned start = static_cast<unsigned>(getpid()) * 31 + ++serial;
  for (unsigned i = 0; i < kUsersOfTierA.count; ++i) {
    std::optional<User> user = take_user(kUsersOfTierA.first + (start + i) % kUsersOfTierA.count);
    if (user) return std::make_shared<const User>(std::move(*user));
  }
  throw pt::Error("all users for boxes are taken");
}

// Inside bubblewrap it cannot become a user itself.
Words launcher(const Box& box, const Words& visible, bool inside, const User* user) {
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
  if (box.tells_start) words.push_back(fmt::format("--started={}", box.descriptors.size() - 1));
  if (const auto newest = landlock_at_most())
    words.push_back(fmt::format("--landlock={}", *newest));
  if (inside) words.push_back("--inside");
  if (user != nullptr) words.push_back(fmt::format("--user={}", user->id));
  words.push_back("--");
  return words + box.command;
}

// /lib and similar paths are links into /usr on most systems, and folders on others.
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

// Older versions lack it. The launcher's filter forbids new namespaces too.
Words disable_userns() {
  static const bool known =
      process::run_command({{kBubblewrap, "--help"}, {}, {}, "", {}}, std::chrono::seconds(5))
          .output.find("--disable-userns") != std::string::npos;
  return known ? Words{"--disable-userns"} : Words{};
}

// The folders above visible paths. Bubblewrap would close them to another user.
Words open_folders(const Words& shown) {
  std::set<fs::path> folders;
  for (const std::string& path : shown) {
    for (fs::path above = fs::path(path).parent_path(); above.has_relative_path();
         above = above.parent_path()) {
      folders.insert(above);
    }
  }
  Words words;
  for (const fs::path& folder : folders) words = words + Words{"--dir", folder};
  return words;
}

Words bubblewrap(const Box& box, const Words& visible, const User* user) {
  Words words{kBubblewrap, "--cap-drop", "ALL", "--die-with-parent", "--new-session", "--as-pid-1"};
  if (user != nullptr) {
    // The launcher keeps the capabilities to become another user.
    words = words + Words{"--unshare-ipc", "--unshare-pid", "--unshare-net", "--unshare-uts",
                          "--unshare-cgroup-try"};
    for (const char* right : {"CAP_SETUID", "CAP_SETGID", "CAP_CHOWN"}) {
      words = words + Words{"--cap-add", right};
    }
  } else {
    words = words + Words{"--unshare-all", "--unshare-user"} + disable_userns();
  }
  words = words + root_folders() +
          open_folders(visible + Words{"/dev/null", launcher_path(), box.folder});
  for (const std::string& path : visible) words = words + Words{"--ro-bind", path, path};
  words = words + Words{"--dev-bind", "/dev/null", "/dev/null"} +
          Words{"--ro-bind", launcher_path(), launcher_path()};
  if (!box.folder.empty()) words = words + Words{"--bind", box.folder, box.folder};
  words = words + Words{"--remount-ro", "/", "--chdir", "/", "--"};
  return words + launcher(box, visible, true, user);
}

// A program that starts others, as a compiler does, has a limit for each of them. Together they get
// a quarter more than one of them, so that a single process meets its own limit first.
std::optional<std::uint64_t> tree_memory(const Box& box) {
  if (!box.limits.address_space) return std::nullopt;
  return *box.limits.address_space / 4 * 5;
}

}  // namespace

std::string launcher_path() {
  static const std::string path = base::programs_folder() + "/box";
  return path;
}

char letter(Tier tier) { return "ABC"[static_cast<int>(tier)]; }

Tier tier_of(std::string_view word) {
  for (const Tier tier : {Tier::bubblewrap, Tier::restricted, Tier::limits}) {
    if (word.size() == 1 && word[0] == letter(tier)) return tier;
  }
  throw pt::Error(fmt::format("'{}' is not a tier of isolation: write A, B or C", word));
}

std::optional<int> landlock_at_most() {
  const char* text = std::getenv(kLandlockVariable);
  if (text == nullptr) return std::nullopt;
  const std::optional<int> version = pt::number_in<int>(text);
  if (!version || *version < 0) {
    throw pt::Error(
        fmt::format("{} is '{}'; write the newest version of Landlock to use, such as 5",
                    kLandlockVariable, base::printable(text, 40)));
  }
  return version;
}

std::vector<std::string> judges_environment() {
  std::vector<std::string> words{"PATH=/usr/bin:/bin", "LANG=C.UTF-8"};
  if (const auto newest = landlock_at_most()) {
    words.push_back(fmt::format("{}={}", kLandlockVariable, *newest));
  }
  return words;
}

Box box_of_functions(const std::string& program, std::uint64_t cpu_seconds) {
  Box box;
  box.command = {program};
  box.environment = {"LANG=C.UTF-8"};
  box.limits = {.cpu_seconds = cpu_seconds,
                .address_space = std::uint64_t{1} << 30,
                .file_size = 0,
                .processes = 0,
                .open_files = 16};
  return box;
}

process::Child boxed(const Box& box, Tier tier) {
  if (tier == Tier::limits) {
    std::vector<int> descriptors = box.descriptors;
    if (box.tells_start) descriptors.pop_back();
    return {box.command, box.environment,  descriptors, box.folder.empty() ? "/" : box.folder,
            box.limits,  tree_memory(box), nullptr};
  }
  Words visible = system_files(box.tools) + box.visible;
  if (!box.tools) visible.push_back(box.command.at(0));
  const bool inside = tier == Tier::bubblewrap;
  const std::shared_ptr<const User> user =
      inside && is_root_of_the_machine() ? user_inside() : nullptr;
  return {inside ? bubblewrap(box, visible, user.get()) : launcher(box, visible, false, nullptr),
          box.environment,
          box.descriptors,
          "/",
          {},
          tree_memory(box),
          user};
}

}  // namespace grader::sandbox
