// Tests which tier is used if some do not work. `contained` forbids the system calls that make
// namespaces, as a container does.
#include "grader/service/process/limits.h"
#include "grader/service/process/run_command.h"
#include "grader/service/sandbox/users.h"
#include "tests/fixtures/hostile_submission.h"

#include <algorithm>
#include <cstdlib>

#include <gtest/gtest.h>
#include <linux/landlock.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace grader::tests {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

// Grades the reference's camera_ray inside `contained`.
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

// A broken box would look like a machine without boxes, and every attack test would be skipped. So
// these two functions test the machine itself, without any code of ours.
bool makes_namespaces() {
  const process::Child bubblewrap{
      {"/usr/bin/bwrap", "--unshare-all", "--unshare-user", "--die-with-parent", "--ro-bind", "/",
       "/", "--dev", "/dev", "--proc", "/proc", "/bin/true"},
      {"PATH=/usr/bin:/bin"},
      {},
      "",
      {}};
  try {
    return process::run_command(bubblewrap, std::chrono::seconds(10)).ok();
  } catch (const std::exception&) {
    return false;  // bubblewrap is missing
  }
}

bool has_landlock() {
  return syscall(SYS_landlock_create_ruleset, nullptr, 0, LANDLOCK_CREATE_RULESET_VERSION) >= 1;
}

// Returns whether every user may enter the folders above a path.
bool is_reached_by_all(fs::path path) {
  for (path = fs::absolute(path).parent_path();; path = path.parent_path()) {
    struct stat status {};
    if (stat(path.c_str(), &status) != 0 || (status.st_mode & S_IXOTH) == 0) return false;
    if (path == path.root_path()) return true;
  }
}

void expect_tier(const std::string& tier) {
  const Submission submission("tier_" + tier);
  const Outcome outcome = submission.grade({"--isolation", tier, "--no-pictures", "camera_ray"});
  EXPECT_EQ(outcome.exit_status, 0) << outcome.output;
  EXPECT_EQ(outcome.state("camera_ray"), "pass");
  EXPECT_EQ(isolation_of(outcome).substr(0, 3), tier + ": ");
}

TEST(tier, A_works_where_bubblewrap_does) {
  if (process::kSanitized || !makes_namespaces())
    GTEST_SKIP() << "NOT TESTED: this machine makes no namespaces";
  expect_tier("A");
}

TEST(tier, B_works_where_there_are_landlock_and_other_users) {
  const Submission submission("work");
  const bool may = sandbox::is_root_of_the_machine() && is_reached_by_all(submission.work()) &&
                   is_reached_by_all(FIRSTLIGHT_GRADE);
  if (process::kSanitized || !has_landlock() || !may)
    GTEST_SKIP() << "NOT TESTED: no Landlock, or no other user";
  expect_tier("B");
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
}  // namespace grader::tests
