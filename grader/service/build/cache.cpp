#include "grader/service/build/cache.h"

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

namespace grader::build {

namespace {

namespace fs = std::filesystem;
using FileClock = fs::file_time_type::clock;

constexpr const char* kRunning = "running.";

struct Entry {
  std::vector<fs::path> files;
  std::uintmax_t bytes = 0;
  fs::file_time_type used = fs::file_time_type::min();
};

bool is_number(const std::string& extension) {
  return extension.size() > 1 && std::all_of(extension.begin() + 1, extension.end(),
                                             [](char c) { return c >= '0' && c <= '9'; });
}

// The process that made a temporary file, from its name "<name>.<process>.<serial>.tmp" (see
// pt::temporary_name()). 0 for other files.
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

// The file `trimmed` has the time of the last look.
std::string last_look(const std::string& folder) { return folder + "/trimmed"; }

// Since when entries may be in use.
fs::file_time_type in_use_since(const std::string& folder) {
  fs::file_time_type since = FileClock::now() - kJustUsed;
  std::error_code error;
  for (const fs::directory_entry& file : fs::directory_iterator(folder, error)) {
    if (!file.path().filename().string().starts_with(kRunning)) continue;
    const pid_t maker = maker_of(file.path());
    const fs::file_time_type begun = file.last_write_time(error);
    if (!error && maker != 0 && is_running(maker)) since = std::min(since, begun);
  }
  return since;
}

// The entries of the folder.
std::vector<Entry> entries_of(const std::string& folder) {
  std::map<std::string, Entry> entries;
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
    entry.used = std::max(entry.used, used);
  }
  std::vector<Entry> all;
  all.reserve(entries.size());
  for (auto& [key, entry] : entries) all.push_back(std::move(entry));
  return all;
}

}  // namespace

Running::Running(const std::string& folder) {
  fs::create_directories(folder);
  path_ = pt::temporary_name(folder + "/" + kRunning + "judge");
  pt::write_file(path_, "");
}

Running::~Running() { remove_quietly(path_); }

void keep(const std::string& path, const std::string& bytes) {
  pt::write_file(path, bytes);
  if (bytes.size() > kLarge) remove_quietly(last_look(fs::path(path).parent_path()));
}

std::string content_stamp(const std::string& path, const std::string& folder) {
  static std::mutex mutex;
  static std::map<std::string, std::string> known;
  const std::string version = base::stamp(path);
  const std::lock_guard lock(mutex);
  std::string& hash = known[version];
  if (!hash.empty()) return hash;
  const std::string kept = folder + "/" + base::sha256(version) + ".content";
  if (fs::exists(kept)) {
    hash = pt::read_file(kept);
    mark_used(kept);
  } else {
    hash = base::sha256(pt::read_file(path));
    fs::create_directories(folder);
    pt::write_file(kept, hash);
  }
  return hash;
}

void mark_used(const std::string& path) {
  std::error_code ignored;
  fs::last_write_time(path, FileClock::now(), ignored);
}

void remove_unused_beside(const std::string& folder) {
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(fs::path(folder).parent_path(), error)) {
    const fs::file_time_type used = entry.last_write_time(error);
    if (error || entry.path() == folder || FileClock::now() - used < kInUse) continue;
    // Nobody must find half an entry.
    const fs::path removed = pt::temporary_name(entry.path());
    fs::rename(entry.path(), removed, error);
    remove_quietly(removed);
  }
}

void remove_left_overs(const std::string& folder) {
  std::error_code error;
  for (const fs::directory_entry& file : fs::directory_iterator(folder, error)) {
    const pid_t maker = maker_of(file.path());
    if (maker != 0 && !is_running(maker)) remove_quietly(file.path());
  }
}

void trim_cache(const std::string& folder, std::uintmax_t most) {
  const fs::file_time_type since = in_use_since(folder);
  std::vector<Entry> entries = entries_of(folder);
  std::uintmax_t total = 0;
  for (const Entry& entry : entries) total += entry.bytes;
  if (total <= most) return;
  std::ranges::sort(entries, {}, &Entry::used);
  for (const Entry& entry : entries) {
    if (total < most / 2 || entry.used >= since) return;
    for (const fs::path& path : entry.files) remove_quietly(path);
    total -= entry.bytes;
  }
}

void trim_cache_now_and_then(const std::string& folder, std::uintmax_t most) {
  const std::string looked = last_look(folder);
  std::error_code error;
  const fs::file_time_type last = fs::last_write_time(looked, error);
  if (!error && FileClock::now() - last < kTrimPause) return;
  trim_cache(folder, most);
  pt::write_file(looked, "");
}

}  // namespace grader::build
