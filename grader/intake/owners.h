#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace grader::intake {

// The last part of a path that is a folder's own entry.
inline constexpr const char* kFolderItself = "";

// That of a file which is hidden, or in a hidden folder.
inline constexpr const char* kHidden = ".";

// Whose the entries of an archive of everybody's work are, by all of their paths.
class Owners {
 public:
  Owners() = default;
  explicit Owners(const std::vector<std::vector<std::string>>& paths);

  // How many folders stand around everything.
  std::size_t depth() const { return depth_; }

  // The same for all entries of one owner.
  std::string key(const std::vector<std::string>& place) const;

  // Places of owners who may be two: their files or folders come twice, and libarchive writes all accents in one
  // way. Where a platform's number is in the name, it is one.
  const std::vector<std::vector<std::string>>& in_doubt() const { return in_doubt_; }

 private:
  bool is_labelled(const std::string& part) const;
  std::vector<std::vector<std::string>> may_be_two(
      const std::vector<std::vector<std::string>>& paths) const;

  std::size_t depth_ = 0;
  bool is_canvas_ = false;
  std::vector<std::vector<std::string>> in_doubt_;
};

}  // namespace grader::intake
