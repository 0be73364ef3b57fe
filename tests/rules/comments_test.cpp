// A comment is a sentence about the code below it: "Returns whether a ray meets the box.", not
// "Whether a ray meets the box.", which is half a sentence.
#include "pt/file.h"

#include <filesystem>
#include <optional>
#include <regex>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

namespace grader::tests {
namespace {

namespace fs = std::filesystem;

// The first line of a comment that begins with half a sentence, if there is one.
std::optional<std::string> half_a_sentence(const std::string& text) {
  static const std::regex begins(R"(\s*// (What|Whether|How|Why|Which|Who) .*)");
  static const std::regex comment(R"(\s*//.*)");
  std::istringstream lines(text);
  bool inside = false;
  for (std::string line; std::getline(lines, line);) {
    if (!inside && std::regex_match(line, begins)) return line;
    inside = std::regex_match(line, comment);
  }
  return std::nullopt;
}

TEST(comments, that_are_half_a_sentence_are_seen) {
  EXPECT_EQ(half_a_sentence("int a;\n  // Whether it is.\n"), "  // Whether it is.");
  EXPECT_EQ(half_a_sentence("// How far\n// it is.\n"), "// How far");
  EXPECT_FALSE(half_a_sentence("// Returns whether it is.\n"));
  EXPECT_FALSE(half_a_sentence("// Of the box.\n// How far it is, nobody knows.\n"));
}

TEST(comments, are_sentences) {
  int count = 0;
  for (const char* folder : {"pt", "scenes", "reference", "fast", "student", "grader", "measure",
                             "writeup", "tests", "bench"}) {
    const fs::path root = FIRSTLIGHT_ROOT;
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
      const std::string type = entry.path().extension(), path = fs::relative(entry.path(), root);
      if (type != ".cpp" && type != ".h") continue;
      ++count;
      const auto found = half_a_sentence(pt::read_file(entry.path()));
      EXPECT_FALSE(found) << path << ": " << *found << ": give it a subject";
    }
  }
  EXPECT_GT(count, 800);
}

}  // namespace
}  // namespace grader::tests
