// What a submission does to the grader must cost no more than the task it does it in.
#include "grader/self_check/hostile_submission.h"

#include <fstream>
#include <map>

#include <gtest/gtest.h>
#include <sys/stat.h>

namespace grader {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

TEST(hostile, costs_its_own_task_only) {
  Submission submission("hostile");
  submission.put("plain");
  const Outcome outcome = submission.grade();
  EXPECT_EQ(outcome.exit_status, 1);
  const std::map<std::string, std::string> expected{
      {"camera_ray", "crash"},    {"hit_triangle", "timeout"}, {"hit_sphere", "crash"},
      {"build_bvh", "crash"},     {"hit_box", "timeout"},      {"hit_bvh", "crash"},
      {"estimate_pixel", "fail"}, {"diffuse_bsdf", "crash"}};
  for (const json& task : outcome.results.at("tasks")) {
    const auto found = expected.find(task.at("slug"));
    EXPECT_EQ(task.at("state"), found == expected.end() ? "blocked" : found->second)
        << task.dump(1, ' ', false, json::error_handler_t::replace).substr(0, 2000);
  }
  // Nobody waits longer for its pictures than for one of its calls: there are fifty.
  for (const char* slug : {"hit_triangle", "hit_box"}) {
    ASSERT_FALSE(outcome.task(slug).at("pictures").empty()) << slug;
    for (const json& picture : outcome.task(slug).at("pictures")) {
      EXPECT_EQ(picture.at("text"), "no answer within 1 s") << picture.at("recipe");
    }
  }
}

// The texts of a submission reach the report as one harmless line.
TEST(hostile, cannot_write_the_report) {
  const Submission submission("throws");
  std::ofstream(submission / "1_rays/hit_sphere.cpp")
      << "#include \"pt/tasks/hit_sphere.h\"\n#include <stdexcept>\nnamespace pt {\n"
         "std::optional<SurfaceHit> hit_sphere(const Sphere&, const Ray&) {\n"
         "  throw std::runtime_error(\"\\x1b[2J\\ncause: wrong\\nexpected: this\\n\\xff\"); }\n}\n";
  const Outcome outcome = submission.grade({"hit_sphere"});
  EXPECT_EQ(outcome.state("hit_sphere"), "crash");
  const json& failure = outcome.task("hit_sphere").at("promises").at(0).at("failures").at(0);
  EXPECT_EQ(failure.at("expected"), "an answer");
  EXPECT_EQ(failure.at("cause"), "crash");
  const std::string got = failure.at("got");
  EXPECT_EQ(got.find('\x1b'), std::string::npos);
  EXPECT_EQ(got.find('\n'), std::string::npos);
}

TEST(hostile, only_plain_files_of_moderate_size_are_taken) {
  const Submission submission("files");
  fs::remove(submission / "1_rays/hit_sphere.cpp");
  fs::create_symlink(FIRSTLIGHT_ROOT "/reference/1_rays/hit_sphere.cpp",
                     submission / "1_rays/hit_sphere.cpp");
  fs::remove(submission / "1_rays/camera_ray.cpp");
  fs::remove(submission / "1_rays/hit_triangle.cpp");
  ASSERT_EQ(mkfifo((submission / "1_rays/hit_triangle.cpp").c_str(), 0600), 0);
  std::ofstream(submission / "2_bvh/hit_box.cpp", std::ios::app) << std::string(1 << 20, ' ');
  fs::rename(submission / "3_direct", submission / "elsewhere");
  fs::create_directory_symlink("elsewhere", submission / "3_direct");
  fs::create_hard_link(submission / "2_bvh/build_bvh.cpp", submission / "another name");
  const Outcome outcome = submission.grade(
      {"hit_sphere", "camera_ray", "hit_triangle", "hit_box", "diffuse_bsdf", "build_bvh"});
  EXPECT_EQ(outcome.exit_status, 1);
  EXPECT_EQ(outcome.state("hit_sphere"), "rejected");
  EXPECT_EQ(outcome.state("hit_triangle"), "rejected");
  EXPECT_EQ(outcome.state("hit_box"), "rejected");
  EXPECT_EQ(outcome.state("diffuse_bsdf"), "rejected");
  EXPECT_EQ(outcome.state("build_bvh"), "pass");
  EXPECT_EQ(outcome.state("camera_ray"), "not_attempted");
}

TEST(grade, names_the_line_that_does_not_compile) {
  const Submission submission("compile");
  std::ofstream(submission / "1_rays/hit_sphere.cpp") << "\n\nint f() { return; }\n";
  const Outcome outcome = submission.grade({"hit_sphere", "camera_ray"});
  EXPECT_EQ(outcome.state("hit_sphere"), "fail");
  EXPECT_EQ(outcome.state("camera_ray"), "pass");
  const std::string error = outcome.task("hit_sphere").at("compiler_output");
  EXPECT_EQ(error.find((submission / "1_rays/hit_sphere.cpp:3:").string()), 0u) << error;
}

// camera_ray is right for as many calls as its own properties make, and wrong soon after.
TEST(grade, blames_the_task_whose_exchange_mends_another) {
  const Submission submission("blame");
  std::string text = text_of(FIRSTLIGHT_ROOT "/reference/1_rays/camera_ray.cpp");
  const std::size_t body = text.find("Ray camera_ray(");
  ASSERT_NE(body, std::string::npos);
  const std::size_t brace = text.find('{', body) + 1;
  text.insert(brace, "\n  static int calls = 0;\n  if (++calls > 2500) return {};\n");
  std::ofstream(submission / "1_rays/camera_ray.cpp") << text;
  // A picture would show it at once.
  const Outcome outcome = submission.grade({"1_rays", "--no-pictures"});
  EXPECT_EQ(outcome.exit_status, 1);
  EXPECT_EQ(outcome.state("camera_ray"), "pass");
  EXPECT_EQ(outcome.state("estimate_pixel"), "fail");
  EXPECT_EQ(outcome.task("estimate_pixel").at("blamed"), json::array({"camera_ray"}));
}

TEST(grade, an_untouched_stub_is_not_attempted) {
  const Submission submission("stub");
  fs::copy_file(FIRSTLIGHT_ROOT "/student/1_rays/hit_sphere.cpp",
                submission / "1_rays/hit_sphere.cpp", fs::copy_options::overwrite_existing);
  const Outcome outcome = submission.grade({"hit_sphere", "hit_bvh"});
  EXPECT_EQ(outcome.state("hit_sphere"), "not_attempted");
  EXPECT_EQ(outcome.task("hit_sphere").at("points"), 0);
  EXPECT_EQ(outcome.state("hit_bvh"), "blocked");
  EXPECT_EQ(outcome.task("hit_bvh").at("blocked_by"), json::array({"hit_sphere"}));
}

}  // namespace
}  // namespace grader
