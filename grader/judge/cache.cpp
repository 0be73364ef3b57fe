#include "grader/judge/cache.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <vector>

namespace grader::judge {

namespace {

namespace fs = std::filesystem;
using Clock = fs::file_time_type::clock;

struct Entry {
  std::vector<fs::path> files;
  std::uintmax_t bytes = 0;
  fs::file_time_type used = fs::file_time_type::min();
};

bool is_number(const std::string& extension) {
  return extension.size() > 1 && std::all_of(extension.begin() + 1, extension.end(),
                                             [](char c) { return c >= '0' && c <= '9'; });
}

// As temporary_name() makes them: of a process and a serial number.
bool is_temporary(const fs::path& path) {
  return is_number(path.extension()) && is_number(path.stem().extension());
}

void remove_quietly(const fs::path& path) {
  std::error_code ignored;
  fs::remove_all(path, ignored);
}

// The entries of the folder. Temporary files last touched before `in_use_since` are removed on the
// way.
std::vector<Entry> entries_of(const std::string& folder, fs::file_time_type in_use_since) {
  std::map<std::string, Entry> entries;
  std::error_code error;
  for (const fs::directory_entry& file : fs::directory_iterator(folder, error)) {
    // Another judge may have removed the file in between.
    const fs::file_time_type used = file.last_write_time(error);
    if (error) continue;
    if (is_temporary(file.path())) {
      if (used < in_use_since) remove_quietly(file.path());
      continue;
    }
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

void mark_used(const std::string& path) {
  std::error_code ignored;
  fs::last_write_time(path, Clock::now(), ignored);
}

void trim_cache(const std::string& folder, std::uintmax_t most) {
  const fs::file_time_type in_use_since = Clock::now() - kInUse;
  std::vector<Entry> entries = entries_of(folder, in_use_since);
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

}  // namespace grader::judge
