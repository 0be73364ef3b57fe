#pragma once

#include "grader/pictures/block_means.h"

#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

// Finds the known mistake that made the pictures of a task. It is named only if all pictures look
// like its own, and no other known mistake could have made them: a wrong name costs a learner hours.
// docs/verdicts.md says how, and how often it is right.

namespace grader::pictures {

// One of the wrong solutions that we keep, and the pictures of its task with it.
struct KnownMistake {
  std::string task;      // slug
  std::string name;      // the file's, without .cpp
  std::string content;   // the beginning of the file's hash
  std::string sentence;  // that says the mistake
  struct Picture {
    std::string recipe_hash;           // the beginning of what the golden's provenance has
    std::optional<BlockMeans> blocks;  // nothing: the picture is right all the same
    bool known = true;                 // false: there was no picture, or once a right one
  };
  std::map<std::string, Picture> pictures;  // by recipe
};

// Adds an entry. The pictures of several entries on one mistake of one content are put together, later ones in the
// place of earlier ones; a later content replaces an earlier one.
void add(std::vector<KnownMistake>& mistakes, KnownMistake mistake);

// A file with an object in each line, added in this way. Only those of `task`, unless it is empty.
// None if there is no file. Throws pt::Error with file and line for anything else.
std::vector<KnownMistake> read_mistakes(const std::filesystem::path& file, const std::string& task);

// One line, with its end.
std::string to_line(const KnownMistake& mistake);

// The evidence of one picture of a task: mistakes that may have made it (like), and mistakes that did
// not (unlike). A mistake may be in neither list.
struct Likeness {
  std::vector<std::string> like, unlike;
};

// A picture that is judged: one that passed, one that was wrong with its means, or anything else.
struct JudgedPicture {
  enum class Outcome { right, wrong, none } outcome = Outcome::none;
  std::optional<BlockMeans> blocks;
};

// `golden`: of the reference. Known mistakes of another version of the recipe do not count.
Likeness compare(const std::string& recipe, const std::string& recipe_hash,
                 const JudgedPicture& picture, const BlockMeans& golden,
                 std::span<const KnownMistake> mistakes);

}  // namespace grader::pictures
