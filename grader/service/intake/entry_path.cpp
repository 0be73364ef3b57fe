#include "grader/service/intake/entry_path.h"

#include "grader/base/files.h"
#include "grader/base/sha256.h"
#include "grader/service/intake/file_name.h"

#include <algorithm>
#include <sstream>

namespace grader::intake {

namespace {

// A file that is being written has a longer name.
constexpr std::size_t kMaxPart = 200;

std::string shortened(const std::string& part) {
  if (part.size() <= kMaxPart) return part;
  constexpr std::size_t kKept = 120, kDigits = 12;
  return cut_name(
      part.substr(0, kKept) + '~' + base::sha256(part).substr(0, kDigits) + ending_of(part),
      kMaxPart);
}

// Windows writes \ for /. The first part of an absolute path is empty.
std::vector<std::string> all_parts(std::string path) {
  std::replace(path.begin(), path.end(), '\\', '/');
  std::vector<std::string> all;
  std::istringstream parts(path);
  for (std::string part; std::getline(parts, part, '/');) all.push_back(part);
  return all;
}

}  // namespace

std::vector<std::string> parts_before_hidden(const std::string& path) {
  if (leads_out(path)) return {};
  std::vector<std::string> all;
  for (const std::string& part : all_parts(path)) {
    if (part.empty() || part == ".") continue;
    if (base::is_hidden(part)) break;
    all.push_back(shortened(part));
  }
  return all;
}

std::vector<std::string> parts_of(const std::string& path) {
  const std::vector<std::string> all = all_parts(path);
  const bool is_hidden = std::any_of(all.begin(), all.end(), [](const std::string& part) {
    return part != "." && base::is_hidden(part);
  });
  return is_hidden ? std::vector<std::string>() : parts_before_hidden(path);
}

bool leads_out(const std::string& path) {
  const std::vector<std::string> all = all_parts(path);
  return (!all.empty() && all[0].empty()) || std::find(all.begin(), all.end(), "..") != all.end();
}

std::size_t folders_around(const std::vector<std::vector<std::string>>& paths) {
  if (paths.empty()) return 0;
  std::size_t count = paths[0].size() - 1;
  for (const std::vector<std::string>& path : paths) {
    count = std::min(count, path.size() - 1);
    while (count > 0 && !std::equal(path.begin(), path.begin() + static_cast<std::ptrdiff_t>(count),
                                    paths[0].begin())) {
      --count;
    }
  }
  return count;
}

std::string joined(const std::vector<std::string>& parts, std::size_t count) {
  std::string path;
  for (std::size_t i = 0; i < std::min(count, parts.size()); ++i) {
    path += (i == 0 ? "" : "/") + parts[i];
  }
  return path;
}

}  // namespace grader::intake
