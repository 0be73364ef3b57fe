// Tests the tier that is taken where some do not work. `contained` forbids the system calls that
// make namespaces, as a container does.
#include "grader/self_check/hostile_submission.h"

#include <algorithm>

#include <gtest/gtest.h>

namespace grader::self_check {
namespace {

using Words = std::vector<std::string>;

// Grades the reference's camera_ray in there.
Outcome grade_contained(const Submission& submission, const Words& limits, const Words& options) {
  Words words{FIRSTLIGHT_CONTAINED};
  words.insert(words.end(), limits.begin(), limits.end());
  Words wanted{"--no-pictures", "camera_ray"};
  wanted.insert(wanted.end(), options.begin(), options.end());
  const Words command = submission.command(wanted);
  words.insert(words.end(), command.begin(), command.end());
  return submission.run(words);
}

std::string isolation_of(const Outcome& outcome) {
  return outcome.results.is_null() ? "" : outcome.results.at("isolation").get<std::string>();
}

bool is_one_line(const std::string& text) {
  return std::count(text.begin(), text.end(), '\n') == 1;
}

TEST(tier, is_B_in_a_container_without_namespaces) {
  const Submission submission("contained");
  const Outcome outcome = grade_contained(submission, {}, {"--require-isolation"});
  if (outcome.exit_status == 2) GTEST_SKIP() << "NOT TESTED, B does not work: " << outcome.output;
  EXPECT_EQ(outcome.exit_status, 0) << outcome.output;
  EXPECT_EQ(outcome.state("camera_ray"), "pass");
  EXPECT_EQ(isolation_of(outcome).substr(0, 3), "B: ");
  EXPECT_NE(outcome.output.find("Isolation " + isolation_of(outcome)), std::string::npos);
}

TEST(tier, is_not_A_in_there_even_if_that_is_asked_for) {
  const Submission submission("asked");
  const Outcome outcome = grade_contained(submission, {}, {"--isolation", "A"});
  EXPECT_EQ(outcome.exit_status, 2);
  EXPECT_TRUE(outcome.results.is_null());
  EXPECT_TRUE(is_one_line(outcome.output)) << outcome.output;
  EXPECT_EQ(outcome.output.find("isolation does not work here as asked: A: "), 0) << outcome.output;
}

TEST(tier, is_C_where_no_box_works_and_the_report_says_why) {
  const Submission submission("open");
  const Outcome outcome = grade_contained(submission, {"--no-programs"}, {});
  EXPECT_EQ(outcome.exit_status, 0) << outcome.output;
  const std::string words = isolation_of(outcome);
  EXPECT_EQ(words.find("C: rlimits only, not isolated (A: "), 0) << words;
  EXPECT_NE(words.find("; B: "), std::string::npos) << words;
}

TEST(tier, C_is_refused_where_isolation_is_required) {
  const Submission submission("refused");
  const Outcome outcome = grade_contained(submission, {"--no-programs"}, {"--require-isolation"});
  EXPECT_EQ(outcome.exit_status, 2);
  EXPECT_TRUE(outcome.results.is_null());
  EXPECT_TRUE(is_one_line(outcome.output)) << outcome.output;
  EXPECT_EQ(outcome.output.find("--require-isolation refuses to grade in C: A: "), 0)
      << outcome.output;
  EXPECT_NE(outcome.output.find("; B: "), std::string::npos) << outcome.output;
}

}  // namespace
}  // namespace grader::self_check
