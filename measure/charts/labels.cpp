#include "measure/charts/labels.h"

#include "grader/base/printable.h"
#include "pt/error.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

#include <fmt/format.h>

namespace measure {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kMost = 40;  // letters

// The last `count` folders of the path, without the ending of an archive. The object of a mistake in a handout,
// hit_bvh.first_child_that_hits.o, has the name of the mistake.
std::string last_of(const std::string& path, int count) {
  fs::path rest = fs::absolute(path).lexically_normal();
  if (!rest.has_filename()) rest = rest.parent_path();
  std::string name = rest.filename();
  if (rest.extension() == ".o") {
    name = rest.stem().extension().string().substr(1);
  } else if (fs::is_regular_file(rest)) {
    name.resize(std::min(name.find('.', 1), name.size()));
  }
  for (; count > 1 && rest.parent_path().has_filename(); --count) {
    rest = rest.parent_path();
    name = rest.filename().string() + "_" + name;
  }
  return name;
}

std::string plain(const std::string& name) {
  std::string text = grader::base::printable(name, kMost);
  for (char& c : text) {
    const auto byte = static_cast<unsigned char>(c);
    const bool is_plain = byte >= 0x80 || std::isalnum(byte) != 0 || c == '.' || c == '-';
    if (!is_plain) c = '_';
  }
  return text;
}

}  // namespace

std::vector<std::string> labels_of(const std::vector<std::string>& paths) {
  constexpr int kMostFolders = 3;
  constexpr std::size_t kMostPaths = 4;  // more lines cannot be told apart in a chart
  if (paths.size() > kMostPaths) {
    throw pt::Error(
        fmt::format("--submission: {} are named, and at most {} can be compared at once",
                    paths.size(), kMostPaths));
  }
  std::vector<std::string> labels;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    const auto is_taken = [&](const std::string& label, int count) {
      return label == "reference" || std::ranges::any_of(paths, [&](const std::string& path) {
               return path != paths[i] && plain(last_of(path, count)) == label;
             });
    };
    int count = 1;
    while (count < kMostFolders && is_taken(plain(last_of(paths[i], count)), count)) ++count;
    std::string label = plain(last_of(paths[i], count));
    // The same folder twice, which shows what noise is.
    if (std::ranges::count(labels, label) > 0) label += fmt::format("_{}", i + 1);
    labels.push_back(label);
  }
  return labels;
}

}  // namespace measure
