// A solution in grader/tasks/*/noisy/ keeps every promise. The picture that its first line names is
// judged right on average and too noisy. No picture is judged wrong.
#include "grader/base/files.h"
#include "tests/fixtures/hostile_submission.h"
#include "tests/fixtures/task_folder.h"

#include <gtest/gtest.h>

namespace grader::tests {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

TEST(noisy, solutions_are_too_noisy_and_not_wrong) {
  int tried = 0;
  for (const auto& folder : fs::directory_iterator(FIRSTLIGHT_ROOT "/grader/tasks")) {
    const std::string slug = folder.path().filename();
    for (const fs::path& file : base::sources_in(folder.path() / "noisy")) {
      SCOPED_TRACE(file);
      ++tried;
      const Submission submission("noisy");
      submission.replace(slug, file);
      const Outcome outcome = submission.grade({slug}, kLongLimit);
      EXPECT_EQ(outcome.state(slug), "too_noisy");
      for (const json& picture : outcome.task(slug).at("pictures")) {
        const bool named = picture.at("recipe") == first_line(file, "// noisy: ");
        if (picture.at("state") == "pass" && !named) continue;
        EXPECT_EQ(picture.at("state"), "too_noisy") << picture.at("recipe");
      }
    }
  }
  EXPECT_GT(tried, 0);
}

}  // namespace
}  // namespace grader::tests
