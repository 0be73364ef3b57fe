#include "grader/service/intake/owners.h"

#include "grader/service/intake/entry_path.h"

#include <algorithm>
#include <map>
#include <optional>

namespace grader::intake {

namespace {

using Place = std::vector<std::string>;

bool is_ascii(const std::string& text) {
  return std::all_of(text.begin(), text.end(),
                     [](char c) { return static_cast<unsigned char>(c) < 0x80; });
}

// The number of times that files of an owner begin in an archive.
struct Begun {
  int files = 0, folders = 0;
  int rows = 0;  // groups of adjacent entries in the folder

  // An archive may lack entries for folders.
  bool twice() const { return files > 1 || folders > 1 || (folders == 0 && rows > 1); }
};

}  // namespace

Owners::Owners(const std::vector<Place>& paths) : depth_(folders_around(paths)) {
  std::vector<std::string> files, folders;
  for (const Place& path : paths) {
    if (path.size() > depth_) (path.size() == depth_ + 1 ? files : folders).push_back(path[depth_]);
  }
  labels_ = Labels(files, folders);
  in_doubt_ = may_be_two(paths);
}

std::string Owners::key(const Place& place) const {
  const std::string& part = place[std::min(depth_, place.size() - 1)];
  const std::optional<Label> label = labels_.of(part);
  return label ? label->key : part;
}

std::vector<Place> Owners::may_be_two(const std::vector<Place>& paths) const {
  std::map<Place, Begun> all;
  Place before;
  for (const Place& path : paths) {
    const std::size_t count = std::min(depth_ + 1, path.size());
    const Place place(path.begin(), path.begin() + static_cast<std::ptrdiff_t>(count));
    if (!is_ascii(place.back()) && !labels_.of(place.back())) {
      Begun& begun = all[place];
      if (path.size() == count) {
        ++begun.files;
      } else if (path.size() == count + 1 && path.back() == kFolderItself) {
        ++begun.folders;
      } else if (place != before) {
        ++begun.rows;
      }
    }
    before = place;
  }
  std::vector<Place> twice;
  for (const auto& [place, begun] : all) {
    if (begun.twice()) twice.push_back(place);
  }
  return twice;
}

}  // namespace grader::intake
