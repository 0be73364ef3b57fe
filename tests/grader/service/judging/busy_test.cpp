// Other work on the machine changes no verdict, because a limit counts the submission's processor
// time.
#include "tests/fixtures/hostile_submission.h"
#include "tests/grader/service/judging/busy_loops.h"

#include <fstream>
#include <thread>

#include <gtest/gtest.h>

namespace grader::tests {
namespace {

// The reference's function, but it first computes or sleeps.
void slow_down(const Submission& submission, const std::string& slug, const std::string& lines) {
  const std::filesystem::path file = submission.file_of(slug);
  std::string text = text_of(file);
  const std::size_t begin = text.find(" " + slug + "(");
  ASSERT_NE(begin, std::string::npos) << file;
  text.insert(text.find("{\n", begin) + 1, "\n" + lines);
  std::ofstream(file) << "#include <chrono>\n#include <ctime>\n#include <thread>\n" << text;
}

std::string computing(const char* seconds) {
  return std::string(
             "  static const bool computed = [] {\n    const auto start = std::clock();\n") +
         "    while (std::clock() - start < " + seconds + " * CLOCKS_PER_SEC) {\n    }\n" +
         "    return true;\n  }();\n  if (!computed) return {};\n";
}

// By the clock a compile takes sixteen times its processor time, and more than the limit, on any number of processors.
int many() { return 15 * static_cast<int>(std::thread::hardware_concurrency()); }

// A call may take 0.4 s. These calls use half of it, which would take seconds on the clock; twice
// as much; and no processor time at all.
TEST(busy, machine_changes_no_verdict) {
  const Submission submission("busy");
  slow_down(submission, "camera_ray", computing("0.2"));
  slow_down(submission, "hit_sphere", computing("0.8"));
  slow_down(submission, "hit_box", "  std::this_thread::sleep_for(std::chrono::hours(1));\n");
  const BusyLoops loops(many());
  const Outcome outcome = submission.grade({"--no-pictures", "--compile-limit", "14", "camera_ray",
                                            "hit_sphere", "hit_box", "hit_triangle"},
                                           400);
  EXPECT_EQ(outcome.state("camera_ray"), "pass") << outcome.output;
  EXPECT_EQ(outcome.state("hit_triangle"), "pass") << outcome.output;
  EXPECT_EQ(outcome.state("hit_sphere"), "timeout") << outcome.output;
  EXPECT_EQ(outcome.state("hit_box"), "timeout") << outcome.output;
}

// An answer of the judge costs the judge's time, and many calls of hit_bvh wait for many answers.
TEST(busy, judge_answers_at_its_own_cost) {
  const Submission submission("answers");
  const BusyLoops loops(many());
  const Outcome outcome = submission.grade({"--no-pictures", "hit_bvh"}, 400);
  EXPECT_EQ(outcome.state("hit_bvh"), "pass") << outcome.output;
}

}  // namespace
}  // namespace grader::tests
