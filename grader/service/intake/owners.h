#pragma once

#include "grader/service/intake/owner.h"

#include <cstddef>
#include <string>
#include <vector>

namespace grader::intake {

// The last part of the path in a folder's own entry.
inline constexpr const char* kFolderItself = "";

// The owner of a hidden file, or of a file in a hidden folder.
inline constexpr const char* kHidden = ".";

// Finds the owner of each entry in an archive of a whole class, from the paths of all entries.
class Owners {
 public:
  Owners() = default;
  explicit Owners(const std::vector<std::vector<std::string>>& paths);

  // The number of leading folders that everything shares.
  std::size_t depth() const { return depth_; }

  // A text that is the same for all entries of one owner.
  std::string key(const std::vector<std::string>& place) const;

  // Places of files or folders that may belong to two owners: their name occurs twice, because
  // libarchive makes names equal that differ only in the encoding of accents. A name with a
  // platform's number in it has one owner.
  const std::vector<std::vector<std::string>>& in_doubt() const { return in_doubt_; }

 private:
  std::vector<std::vector<std::string>> may_be_two(
      const std::vector<std::vector<std::string>>& paths) const;

  std::size_t depth_ = 0;
  Labels labels_;
  std::vector<std::vector<std::string>> in_doubt_;
};

}  // namespace grader::intake
