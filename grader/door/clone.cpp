#include "grader/door/clone.h"

#include "grader/base/descriptor.h"
#include "grader/base/files.h"
#include "grader/door/code.h"
#include "pt/error.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <set>
#include <string_view>

#include <fcntl.h>
#include <fmt/format.h>

namespace grader::door {

namespace fs = std::filesystem;

namespace {

// The largest clones have 250 source files of 6 MB, most of them of libraries.
constexpr std::size_t kMaxFiles = 2000;
constexpr std::size_t kMaxBytes = std::size_t{32} << 20;
constexpr int kMaxDepth = 8;
constexpr std::array kParts{"src", "CGL"};
constexpr const char* kWithFlag = "2023";
constexpr int kMaxAbove = 3;  // folders above a clone

// Returns whether a name can stand in a #line: no quotation mark ends it, and no newline.
bool is_plain(const std::string& name) {
  return std::ranges::all_of(name,
                             [](char c) { return c != '"' && c != '\\' && (c < 0 || c >= ' '); });
}

// The text with "\n" where a line ends in the way of Windows or of old Macs: compilers take all three.
std::string with_plain_ends(const std::string& text) {
  std::string plain;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\r' && i + 1 < text.size() && text[i + 1] == '\n') continue;
    plain += text[i] == '\r' ? '\n' : text[i];
  }
  return plain;
}

// Reads the folders of a clone, within the bounds.
class Reader {
 public:
  explicit Reader(fs::path top) : top_(std::move(top)) {}

  void read(const fs::path& folder, int depth) {
    if (depth > kMaxDepth) return refuse(fmt::format("more than {} folders deep", kMaxDepth));
    const base::Descriptor here(
        open((top_ / folder).c_str(), O_PATH | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
    if (!here.is_open()) return;
    for (const auto& entry : fs::directory_iterator(top_ / folder)) {
      const fs::path path = folder / entry.path().filename();
      const bool is_seen = !base::is_hidden(path.filename()) && is_plain(path.filename());
      if (!is_seen || !clone_.problem.empty()) continue;
      if (entry.is_directory() && !entry.is_symlink()) {
        read(path, depth + 1);
      } else if (is_read(path.filename())) {
        add(path, base::read_plain_file(here.number(), path.filename(), base::kMaxFile));
      }
    }
  }

  Clone clone() && { return std::move(clone_); }

 private:
  void refuse(const std::string& what) {
    clone_.problem = "its folders src and CGL are " + what + "; remove what is not its source";
  }

  void add(const fs::path& path, const base::Submitted& file) {
    bytes_ += file.text.size();
    if (clone_.files.size() >= kMaxFiles)
      return refuse(fmt::format("of more than {} files", kMaxFiles));
    if (bytes_ > kMaxBytes) return refuse(fmt::format("larger than {} MiB", kMaxBytes >> 20));
    clone_.files[path.generic_string()] = {with_plain_ends(file.text), file.rejected};
  }

  fs::path top_;
  Clone clone_;
  std::size_t bytes_ = 0;
};

void add_clones(const fs::path& folder, int depth, std::vector<fs::path>& found) {
  if (is_clone(folder)) return found.push_back(folder);
  if (depth == kMaxAbove) return;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (base::is_hidden(entry.path().filename()) || entry.is_symlink() || !entry.is_directory())
      continue;
    add_clones(entry.path(), depth + 1, found);
  }
}

// Takes a number and the newline behind it.
std::size_t take_number(std::string_view& rest) {
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), number);
  const auto length = static_cast<std::size_t>(end - rest.data());
  if (error != std::errc() || length >= rest.size() || rest[length] != '\n')
    throw pt::Error("this is not a packed clone");
  rest.remove_prefix(length + 1);
  return number;
}

std::string take_text(std::string_view& rest) {
  const std::size_t size = take_number(rest);
  if (size > rest.size()) throw pt::Error("this is not a packed clone");
  std::string text(rest.substr(0, size));
  rest.remove_prefix(size);
  return text;
}

}  // namespace

const Source* Clone::find(const std::string& path) const {
  const auto found = files.find(path);
  return found == files.end() ? nullptr : &found->second;
}

bool is_read(const std::string& name) {
  static const std::set<fs::path> endings{".h", ".hpp", ".inl", ".cpp", ".cc", ".c", ".cxx"};
  return endings.contains(fs::path(name).extension());
}

bool is_clone(const fs::path& folder) {
  std::error_code error;
  return fs::is_regular_file(folder / "src/pathtracer/pathtracer.cpp", error) ||
         (fs::is_directory(folder / "src/static_scene", error) &&
          fs::is_regular_file(folder / "src/pathtracer.cpp", error));
}

std::vector<fs::path> clones_in(const fs::path& folder) {
  std::vector<fs::path> found;
  add_clones(folder, 0, found);
  std::ranges::sort(found);
  return found;
}

std::vector<std::string> paths_in(const fs::path& folder) {
  std::vector<std::string> paths;
  for (const char* part : kParts) {
    std::error_code error;
    fs::recursive_directory_iterator at(folder / part, error);
    for (; !error && at != fs::recursive_directory_iterator(); at.increment(error)) {
      if (is_read(at->path().filename())) paths.push_back(at->path());
    }
  }
  return paths;
}

Clone read_clone(const fs::path& folder) {
  Reader reader(folder);
  for (const char* part : kParts) reader.read(part, 0);
  return std::move(reader).clone();
}

std::string pack(const Clone& clone) {
  std::string text;
  for (const auto& [path, file] : clone.files) {
    for (const std::string* each : {&path, &file.text, &file.refused})
      text += fmt::format("{}\n{}", each->size(), *each);
  }
  return text;
}

Clone unpack(const std::string& text) {
  Clone clone;
  for (std::string_view rest = text; !rest.empty();) {
    const std::string path = take_text(rest);
    Source& file = clone.files[path];
    file.text = take_text(rest);
    file.refused = take_text(rest);
  }
  return clone;
}

Course course_of(const Clone& clone) {
  for (const char* path : {"src/pathtracer/pathtracer.h", "src/pathtracer.h"}) {
    const Source* header = clone.find(path);
    if (header == nullptr) continue;
    const std::string code = only_code(header->text);
    const bool is_old = std::string_view(path) == "src/pathtracer.h";
    const Generation generation = is_old                                     ? Generation::of_2019
                                  : find_word(code, "Spectrum") != code.npos ? Generation::of_2020
                                                                             : Generation::of_2022;
    return {generation, find_word(code, "isAccumBounces") != code.npos};
  }
  return {};
}

const char* first_year(Generation generation) {
  switch (generation) {
    case Generation::of_2019:
      return "2019";
    case Generation::of_2020:
      return "2020";
    case Generation::of_2022:
      return "2022";
  }
  return "";
}

std::string year_of(const Course& course) {
  return course.accumulates ? kWithFlag : first_year(course.generation);
}

std::optional<Course> course_since(const std::string& year) {
  if (year == kWithFlag) return Course{Generation::of_2022, true};
  for (const Generation each : {Generation::of_2019, Generation::of_2020, Generation::of_2022}) {
    if (year == first_year(each)) return Course{each, false};
  }
  return std::nullopt;
}

}  // namespace grader::door
