#include "grader/service/sandbox/launcher/landlock.h"

#include "pt/error.h"

#include <algorithm>
#include <cerrno>
#include <cstring>

#include <fcntl.h>
#include <linux/landlock.h>
#include <sys/stat.h>
#include <sys/syscall.h>

namespace grader::sandbox::box {

namespace {

// landlock_ruleset_attr of the newest kernels: older headers have fewer members.
struct Ruleset {
  std::uint64_t files = 0;
  std::uint64_t network = 0;
  std::uint64_t scoped = 0;
};

constexpr std::uint64_t kRead = LANDLOCK_ACCESS_FS_READ_FILE | LANDLOCK_ACCESS_FS_EXECUTE;
constexpr std::uint64_t kReadFolder = kRead | LANDLOCK_ACCESS_FS_READ_DIR;
constexpr std::uint64_t kUseDevice = LANDLOCK_ACCESS_FS_READ_FILE | LANDLOCK_ACCESS_FS_WRITE_FILE;
// Only plain files and folders: somebody might follow a link or wait for a pipe later.
constexpr std::uint64_t kTruncate = std::uint64_t{1} << 14;  // since version 3
constexpr std::uint64_t kWrite = LANDLOCK_ACCESS_FS_READ_FILE | LANDLOCK_ACCESS_FS_READ_DIR |
                                 LANDLOCK_ACCESS_FS_WRITE_FILE | LANDLOCK_ACCESS_FS_MAKE_REG |
                                 LANDLOCK_ACCESS_FS_MAKE_DIR | LANDLOCK_ACCESS_FS_REMOVE_FILE |
                                 LANDLOCK_ACCESS_FS_REMOVE_DIR | kTruncate;

// Everything that a kernel of this version can forbid.
Ruleset all_of(long version) {
  Ruleset all;
  const int rights = version >= 5 ? 16 : version >= 3 ? 15 : version >= 2 ? 14 : 13;
  all.files = (std::uint64_t{1} << rights) - 1;
  if (version >= 4) all.network = 3;  // bind and connect
  if (version >= 6) all.scoped = 3;   // abstract sockets and signals
  return all;
}

std::size_t size_of(long version) { return version >= 6 ? 24 : version >= 4 ? 16 : 8; }

void allow(const base::Descriptor& rules, const std::string& path, std::uint64_t rights) {
  const base::Descriptor place(open(path.c_str(), O_PATH | O_CLOEXEC));
  struct stat found {};
  if (!place.is_open() || fstat(place.number(), &found) != 0) {
    throw pt::Error(path + ": " + std::strerror(errno));
  }
  if (!S_ISDIR(found.st_mode)) rights &= ~std::uint64_t{LANDLOCK_ACCESS_FS_READ_DIR};
  const landlock_path_beneath_attr rule{rights, place.number()};
  if (syscall(SYS_landlock_add_rule, rules.number(), LANDLOCK_RULE_PATH_BENEATH, &rule, 0) != 0) {
    throw pt::Error(path + " cannot be made visible: " + std::strerror(errno));
  }
}

}  // namespace

base::Descriptor file_rules(const Options& options) {
  const long version = std::min(options.landlock, syscall(SYS_landlock_create_ruleset, nullptr, 0,
                                                          LANDLOCK_CREATE_RULESET_VERSION));
  if (version < 1) return {};
  const Ruleset all = all_of(version);
  base::Descriptor rules(
      static_cast<int>(syscall(SYS_landlock_create_ruleset, &all, size_of(version), 0)));
  if (!rules.is_open()) throw pt::Error(std::string("no Landlock: ") + std::strerror(errno));
  for (const std::string& path : options.visible) allow(rules, path, kReadFolder);
  allow(rules, "/dev/null", kUseDevice);
  if (!options.folder.empty()) allow(rules, options.folder, kWrite & all.files);
  return rules;
}

void enforce(const base::Descriptor& rules) {
  if (!rules.is_open()) return;
  if (syscall(SYS_landlock_restrict_self, rules.number(), 0) != 0) {
    throw pt::Error(std::string("Landlock cannot be used: ") + std::strerror(errno));
  }
}

}  // namespace grader::sandbox::box
