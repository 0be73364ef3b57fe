#include "grader/judge/cache.h"

#include "grader/base/files.h"
#include "grader/base/sha256.h"
#include "pt/file.h"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <filesystem>
#include <map>
#include <mutex>
#include <vector>

namespace grader::judge {

namespace {

namespace fs = std::filesystem;
using FileClock = fs::file_time_type::clock;

struct Entry {
  std::vector<fs::path> files;
  std::uintmax_t bytes = 0;
  fs::file_time_type used = fs::file_time_type::min();
};

bool is_number(const std::string& extension) {
  return extension.size() > 1 && std::all_of(extension.begin() + 1, extension.end(),
                                             [](char c) { return c >= '0' && c <= '9'; });
}

// The process that made a temporary file, which its name tells: "<name>.<process>.<serial>.tmp", as
// pt::temporary_name() has it. 0 for other files.
pid_t maker_of(const fs::path& path) {
  const fs::path numbers = path.stem();
  const std::string serial = numbers.extension(), process = numbers.stem().extension();
  if (path.extension() != ".tmp" || !is_number(serial) || !is_number(process)) return 0;
  pid_t pid = 0;
  std::from_chars(process.data() + 1, process.data() + process.size(), pid);
  return pid;
}

bool is_running(pid_t pid) { return kill(pid, 0) == 0 || errno != ESRCH; }

void remove_quietly(const fs::path& path) {
  std::error_code ignored;
  fs::remove_all(path, ignored);
}

// The entries of the folder.
std::vector<Entry> entries_of(const std::string& folder) {
  std::map<std::string, Entry> entries;
  const fs::file_time_type now = FileClock::now();
  std::error_code error;
  for (const fs::directory_entry& file : fs::directory_iterator(folder, error)) {
    // Another judge may have removed the file in between.
    const fs::file_time_type used = file.last_write_time(error);
    if (error || maker_of(file.path()) != 0) continue;
    const std::uintmax_t bytes = file.file_size(error);
    if (error) continue;
    const std::string name = file.path().filename();
    Entry& entry = entries[name.substr(0, name.find('.'))];
    entry.files.push_back(file.path());
    entry.bytes += bytes;
    // A clock that was set back makes times of the future, which would keep an entry for ever.
    if (used <= now + kInUse) entry.used = std::max(entry.used, used);
  }
  std::vector<Entry> all;
  all.reserve(entries.size());
  for (auto& [key, entry] : entries) all.push_back(std::move(entry));
  return all;
}

// Temporary files of processes that are gone.
std::vector<fs::path> left_over_in(const fs::path& folder) {
  std::vector<fs::path> left;
  std::error_code error;
  for (const fs::directory_entry& file : fs::directory_iterator(folder, error)) {
    const pid_t maker = maker_of(file.path());
    if (maker != 0 && !is_running(maker)) left.push_back(file.path());
  }
  return left;
}

}  // namespace

std::string content_stamp(const std::string& path, const std::string& folder) {
  static std::mutex mutex;
  static std::map<std::string, std::string> known;
  const std::string version = base::stamp(path);
  const std::lock_guard lock(mutex);
  std::string& hash = known[version];
  if (!hash.empty()) return hash;
  const std::string kept = folder + "/" + base::sha256(version) + ".content";
  if (fs::exists(kept)) hash = base::read_file(kept);
  if (hash.size() == base::sha256("").size()) {
    mark_used(kept);
  } else {
    hash = base::sha256(base::read_file(path));
    fs::create_directories(folder);
    pt::write_file(kept, hash);
  }
  return hash;
}

void mark_used(const std::string& path) {
  std::error_code ignored;
  fs::last_write_time(path, FileClock::now(), ignored);
}

void remove_left_overs(const std::string& folder) {
  for (const fs::path& path : left_over_in(folder)) remove_quietly(path);
}

void remove_left_overs_of(const std::string& file) {
  const fs::path path = fs::absolute(file);
  for (const fs::path& left : left_over_in(path.parent_path())) {
    if (left.stem().stem().stem() == path.filename()) remove_quietly(left);
  }
}

void trim_cache(const std::string& folder, std::uintmax_t most) {
  const fs::file_time_type in_use_since = FileClock::now() - kInUse;
  std::vector<Entry> entries = entries_of(folder);
  std::uintmax_t total = 0;
  for (const Entry& entry : entries) total += entry.bytes;
  if (total <= most) return;
  std::ranges::sort(entries, {}, &Entry::used);
  for (const Entry& entry : entries) {
    if (total < most / 2 || entry.used >= in_use_since) return;
    for (const fs::path& path : entry.files) remove_quietly(path);
    total -= entry.bytes;
  }
}

// The time of a file tells when. A time in the future means that the clock was set back.
void trim_cache_now_and_then(const std::string& folder, std::uintmax_t most) {
  const std::string looked = folder + "/trimmed";
  std::error_code error;
  const fs::file_time_type last = fs::last_write_time(looked, error), now = FileClock::now();
  if (!error && last <= now && now - last < kTrimPause) return;
  trim_cache(folder, most);
  pt::write_file(looked, "");
}

}  // namespace grader::judge
