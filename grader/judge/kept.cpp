#include "grader/judge/kept.h"

#include "grader/base/descriptor.h"
#include "grader/base/files.h"
#include "grader/judge/cache.h"
#include "pt/file.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <map>
#include <mutex>
#include <set>
#include <sstream>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>

namespace grader::judge {

namespace {

namespace fs = std::filesystem;

constexpr const char* kSums = ".sums";

// Four independent chains, each of every fourth word: headers of 80 MB are looked at before a file is compiled.
class Sum {
 public:
  static constexpr std::size_t kPiece = std::size_t{1} << 18;

  // All pieces but the last have kPiece bytes.
  void add(std::string_view piece) {
    size_ += piece.size();
    std::array<std::uint64_t, 4> words{};
    while (!piece.empty()) {
      const std::size_t count = std::min(piece.size(), sizeof words);
      if (count < sizeof words) words = {};
      std::memcpy(words.data(), piece.data(), count);
      piece.remove_prefix(count);
      for (std::size_t i = 0; i < 4; ++i) {
        chains_[i] = std::rotl((chains_[i] ^ words[i]) * 0x9e3779b97f4a7c15, 29);
      }
    }
  }
  std::string text() const {
    std::uint64_t all = 0;
    for (const std::uint64_t chain : chains_) all = (all ^ chain) * 0x9e3779b97f4a7c15;
    return fmt::format("{} {:016x}", size_, all);
  }

 private:
  std::uint64_t size_ = 0;
  std::array<std::uint64_t, 4> chains_{1, 2, 3, 4};
};

// Returns how many bytes came, up to the end of the file; -1 if it cannot be read.
ssize_t read_piece(const base::Descriptor& file, std::string& piece) {
  std::size_t size = 0;
  while (size < piece.size()) {
    const ssize_t got = read(file.number(), piece.data() + size, piece.size() - size);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return -1;
    if (got == 0) break;
    size += static_cast<std::size_t>(got);
  }
  return static_cast<ssize_t>(size);
}

std::string text_if_any(const std::string& path) {
  std::error_code error;
  return fs::is_regular_file(path, error) ? base::read_file(path) : "";
}

// A file's name and its sum, which is empty for a file that is not there.
std::string sum_line(const std::string& name, const std::string& path) {
  return name + ' ' + sum_of_file(path) + '\n';
}

// A line for each file of the folder.
std::string sums_in(const std::string& folder) {
  std::vector<std::string> lines;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const fs::path name = entry.path().lexically_relative(folder);
    if (entry.is_directory() || name == kSums) continue;
    lines.push_back(sum_line(name, entry.path()));
  }
  std::sort(lines.begin(), lines.end());
  std::string all;
  for (const std::string& line : lines) all += line;
  return all;
}

// A line for each of the files.
std::string sums_of(const std::vector<std::string>& files) {
  std::string all;
  for (const std::string& file : files) all += sum_line(fs::path(file).filename(), file);
  return all;
}

// Returns whether the file at the path is still the one that was opened.
bool is_still(const base::Descriptor& opened, const std::string& path) {
  struct stat then {
  }, now{};
  return opened.is_open() && fstat(opened.number(), &then) == 0 && stat(path.c_str(), &now) == 0 &&
         then.st_dev == now.st_dev && then.st_ino == now.st_ino;
}

base::Descriptor open_folder(const std::string& path) {
  return base::Descriptor(open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
}

}  // namespace

std::string sum_of(std::string_view bytes) {
  Sum sum;
  for (; !bytes.empty(); bytes.remove_prefix(std::min(bytes.size(), Sum::kPiece))) {
    sum.add(bytes.substr(0, Sum::kPiece));
  }
  return sum.text();
}

std::string sum_of_file(const std::string& path) {
  const base::Descriptor file(open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (!file.is_open()) return "";
  Sum sum;
  std::string piece(Sum::kPiece, '\0');
  for (ssize_t size = Sum::kPiece; size == Sum::kPiece;) {
    size = read_piece(file, piece);
    if (size < 0) return "";
    sum.add(std::string_view(piece).substr(0, static_cast<std::size_t>(size)));
  }
  return sum.text();
}

void note_sum(const std::string& path, const std::string& sum) {
  pt::write_file(path + ".sum", sum);
}

void keep_file(const std::string& path, const std::string& bytes) {
  note_sum(path, sum_of(bytes));
  pt::write_file(path, bytes);
}

bool is_whole(const std::string& path) {
  const std::string sum = text_if_any(path + ".sum");
  return !sum.empty() && sum == sum_of_file(path);
}

void note_sums_of(const std::string& path, const std::vector<std::string>& files) {
  note_sum(path, sums_of(files));
}

bool are_whole(const std::string& path, const std::vector<std::string>& files) {
  const std::string sums = text_if_any(path + ".sum");
  return !sums.empty() && sums == sums_of(files);
}

void note_sums(const std::string& folder) { pt::write_file(folder + '/' + kSums, sums_in(folder)); }

bool is_whole_folder(const std::string& folder) try {
  const std::string sums = text_if_any(folder + '/' + kSums);
  return !sums.empty() && sums == sums_in(folder);
} catch (const fs::filesystem_error&) {
  return false;
}

bool use_folder(const std::string& folder) {
  static std::mutex mutex;
  static std::map<std::string, base::Descriptor> used;
  const std::lock_guard lock(mutex);
  base::Descriptor& held = used[folder];
  if (is_still(held, folder)) return true;
  held = open_folder(folder);
  if (held.is_open()) flock(held.number(), LOCK_SH);
  return is_still(held, folder);  // or it was just removed
}

void remove_unused_beside(const std::string& folder) {
  std::error_code error;
  const auto now = fs::file_time_type::clock::now();
  for (const auto& entry : fs::directory_iterator(fs::path(folder).parent_path(), error)) {
    const auto age = now - entry.last_write_time(error);
    if (error || entry.path() == folder || (age < kInUse && age > -kInUse)) continue;
    // A clock that jumps, or a machine that slept, makes all times old.
    const base::Descriptor opened = open_folder(entry.path());
    if (opened.is_open() && flock(opened.number(), LOCK_EX | LOCK_NB) != 0) continue;
    fs::remove_all(entry.path(), error);
  }
}

}  // namespace grader::judge
