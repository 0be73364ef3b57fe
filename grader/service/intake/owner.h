#pragma once

#include "grader/service/intake/form_table.h"

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace grader::intake {

enum class Platform { none, canvas, moodle, gradescope };

// The parts of the name that a platform gives to a file or folder of a learner.
struct Label {
  Platform platform = Platform::none;
  std::string name, id;   // of the learner; the ID may be empty
  std::string key;        // the same for all files of one learner, and for no other learner's
  std::string file;       // with the learner's name for it; empty: it is a folder
  std::string before;     // the text before that
  std::string attempt;    // of several attempts, the largest text is the last; empty: not known
  std::string dated;      // the date of the attempt as it is written
  std::string handed_in;  // its time, "2027-01-15 22:05"; empty: the name has none
  std::string order;      // of equal names in one attempt, the largest order counts
  bool late = false;
  bool text = false;    // typed into a form, not uploaded
  bool certain = true;  // the name cannot be read in another way
  // Somebody else who may own it; empty: nobody may.
  std::string rival_key{}, rival_name{}, rival_id{};
};

// The labels of all files and folders of an export. The form of a name is decided for the class as
// a whole, by the form that most names have: a learner chooses only the end of a name, and may
// choose it so that it looks like the name of another learner's file on another platform.
class Labels {
 public:
  Labels() = default;
  // `table`: the forms of all platforms but Canvas. Of two that as many names have, that which comes first in it counts, and Canvas'
  // last, as it has no words of its own.
  Labels(const std::vector<std::string>& files, const std::vector<std::string>& folders,
         const std::vector<NameForm>& table);

  // Nothing: no platform names its files so.
  std::optional<Label> of(const std::string& name) const;

 private:
  std::map<std::string, Label> labels_;
};

// The last part of the path in a folder's own entry.
inline constexpr const char* kFolderItself = "";

// The owner of a hidden file, or of a file in a hidden folder.
inline constexpr const char* kHidden = ".";

// Finds the owner of each entry in an archive of a whole class, from the paths of all entries.
class Owners {
 public:
  Owners() = default;
  Owners(const std::vector<std::vector<std::string>>& paths, const std::vector<NameForm>& table);

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

  std::size_t depth_;
  Labels labels_;
  std::vector<std::vector<std::string>> in_doubt_;
};

}  // namespace grader::intake
