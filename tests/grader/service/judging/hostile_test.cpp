// A submission that attacks the grader loses only the task with the attack.
#include "grader/tasks.h"
#include "tests/fixtures/hostile_submission.h"

#include <fstream>
#include <map>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

namespace grader::tests {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

// Other limits grow with the limit of a call. It is short if a submission makes the judge wait.
constexpr int kShortLimit = 400;

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
    const std::string slug = task.at("slug");
    const auto found = expected.find(slug);
    const std::string others = needs(slug).empty() ? "pass" : "blocked";
    EXPECT_EQ(task.at("state"), found == expected.end() ? others : found->second)
        << task.dump(1, ' ', false, json::error_handler_t::replace).substr(0, 2000);
  }
  // There are fifty pictures: the first shows that there is no answer, and nobody waits for the others.
  for (const char* slug : {"hit_triangle", "hit_box"}) {
    ASSERT_FALSE(outcome.task(slug).at("pictures").empty()) << slug;
    const json& pictures = outcome.task(slug).at("pictures");
    const std::string recipe = pictures[0].at("recipe"), none = pictures[0].at("text");
    EXPECT_EQ(none.find("no answer within "), 0U) << none;
    for (const json& picture : pictures) {
      EXPECT_EQ(picture.at("state"), "timeout") << picture.at("recipe");
      EXPECT_EQ(picture.at("text"),
                picture == pictures[0] ? none : "not rendered: " + none + " for " + recipe);
    }
  }
}

// Nobody earns points for somebody else's code: each file lets another function do the work.
TEST(hostile, earns_nothing_by_calling_what_its_contract_does_not_allow) {
  Submission submission("calls");
  const std::vector<std::string> slugs = submission.put("calls");
  EXPECT_EQ(slugs.size(), 12u);
  const Outcome outcome = submission.grade(slugs);
  EXPECT_EQ(outcome.exit_status, 1);
  const std::map<std::string, std::string> called{{"estimate_pixel", "pt::adaptive_pixel"},
                                                  {"camera_ray", "pt::rays_traced"},
                                                  {"hit_triangle", "pt::best_kernel"},
                                                  {"hit_sphere", "pt::hit_triangle"},
                                                  {"build_bvh", "pt::build_binary_tree"},
                                                  {"hit_box", "pt::hit_sphere"},
                                                  {"hit_bvh", "pt::Tracer::closest"},
                                                  {"diffuse_bsdf", "pt::sample_light"},
                                                  {"direct_hemisphere", "pt::direct_lights"},
                                                  {"direct_lights", "pt::trace_path"},
                                                  {"trace_path", "pt::radiance"},
                                                  {"adaptive_pixel", "pt::estimate_pixel"}};
  for (const auto& [slug, function] : called) {
    EXPECT_EQ(outcome.state(slug), "rejected") << slug;
    EXPECT_EQ(outcome.task(slug).at("points"), 0) << slug;
    const std::string reason = outcome.task(slug).at("reason");
    EXPECT_EQ(reason.find("it calls " + function), 0u) << reason;
    EXPECT_NE(reason.find(slug + " may "), std::string::npos) << reason;
  }
}

// The same without a call that a linker sees, and with a call before there is anything to answer.
TEST(hostile, earns_nothing_by_headers_of_the_renderer_nor_before_it_is_asked) {
  Submission submission("headers");
  const std::vector<std::string> slugs = submission.put("headers");
  const Outcome outcome = submission.grade(slugs);
  EXPECT_EQ(outcome.exit_status, 1);
  const std::map<std::string, std::string> closed{
      {"hit_triangle", "hit_triangle may not include pt/accel/exact_hit.h"},
      {"hit_sphere", "hit_sphere may not include pt/scene/scene.h"},
      {"build_bvh", "build_bvh may not include pt/accel/binary_tree.h"}};
  for (const auto& [slug, words] : closed) {
    EXPECT_EQ(outcome.state(slug), "fail") << slug;
    EXPECT_EQ(outcome.task(slug).at("reason"), "it does not compile") << slug;
    const std::string output = outcome.task(slug).at("compiler_output");
    EXPECT_NE(output.find(words), std::string::npos) << output;
  }
  EXPECT_NE(outcome.state("hit_bvh"), "pass");
  for (const std::string& slug : slugs) EXPECT_EQ(outcome.task(slug).at("points"), 0) << slug;
}

// The judge's own time has a limit too, for answers that are expensive and for answers that it has
// to wait for.
TEST(hostile, cannot_keep_the_judge_busy) {
  Submission submission("slow");
  std::vector<std::string> words = submission.put("slow");
  words.insert(words.end(), {"--no-pictures", "--all"});
  const Outcome outcome = submission.grade(words, kShortLimit);
  EXPECT_EQ(outcome.exit_status, 1) << outcome.output;
  EXPECT_EQ(outcome.state("camera_ray"), "timeout");
  EXPECT_NE(outcome.task("camera_ray").dump().find("all calls so far took"), std::string::npos);
  EXPECT_EQ(outcome.state("hit_triangle"), "crash");
  EXPECT_NE(outcome.task("hit_triangle").dump().find("too many calls"), std::string::npos);
  // A task that sleeps and then crashes is not called five hundred times.
  EXPECT_EQ(outcome.state("hit_sphere"), "crash");
  EXPECT_NE(outcome.task("hit_sphere").dump().find("all calls so far took"), std::string::npos)
      << outcome.task("hit_sphere").dump(1);
  // Sleep in the middle of an answer counts, however it is divided.
  EXPECT_EQ(outcome.state("hit_box"), "timeout");
  // Half a million nodes per tree: on a slow processor the short limit comes first.
  const std::string state = outcome.state("build_bvh");
  EXPECT_TRUE(state == "fail" || state == "timeout") << state;
  for (const json& promise : outcome.task("build_bvh").at("promises")) {
    EXPECT_FALSE(promise.at("held").get<bool>()) << promise.at("name");
  }
}

// A submission's texts reach the report as one harmless line.
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
  EXPECT_EQ(outcome.state("diffuse_bsdf"), "pass");  // found where the link leads
  EXPECT_EQ(outcome.state("build_bvh"), "rejected");
  EXPECT_EQ(outcome.state("camera_ray"), "not_attempted");
}

// A crash is reported with its cause, not only with the number of a signal.
TEST(hostile, crashes_are_named_by_their_cause) {
  Submission submission("crashes");
  std::vector<std::string> words = submission.put("crashes");
  words.insert(words.end(), {"--no-pictures", "--all"});
  const Outcome outcome = submission.grade(words);
  const std::map<std::string, std::string> causes{
      {"camera_ray", "Assertion `x < -1' failed. (line 10)"},
      {"hit_triangle", "ended without a return"},
      {"hit_sphere", "divided by zero"},
      {"build_bvh", "endless recursion: the stack overflowed"},
      {"hit_box", "out of memory"},
      {"hit_bvh", "the stack overflowed"},
      {"estimate_pixel", "an index is not below the size of its std::vector, std::array"},
      {"direct_lights", "the value of an empty std::optional was read"}};
  const auto said = [&](const std::string& slug, const std::string& cause) {
    const std::string all = outcome.task(slug).at("promises").dump();
    EXPECT_NE(all.find(cause), std::string::npos) << slug << all.substr(0, 1500);
  };
  for (const auto& [slug, cause] : causes) {
    EXPECT_EQ(outcome.state(slug), "crash") << slug;
    said(slug, cause);
  }
  said("diffuse_bsdf", "std::out_of_range: vector");
  said("diffuse_bsdf", "terminate called after throwing an instance of 'std::logic_error'");
  said("diffuse_bsdf", "what():  no sample");
  said("diffuse_bsdf", "a pointer to nothing");
  // The guilty line is named before anything runs.
  const std::string warnings = outcome.task("hit_triangle").at("warnings");
  EXPECT_NE(warnings.find("hit_triangle.cpp:9:"), std::string::npos) << warnings;
  EXPECT_NE(warnings.find("[-Wreturn-type]"), std::string::npos) << warnings;
  EXPECT_NE(outcome.output.find("[-Wreturn-type]"), std::string::npos) << outcome.output;
}

// The launcher and the kernel report why a compiler or a worker ended. Similar words of a
// submission do not put the blame on the machine, because then nobody would get a verdict.
TEST(hostile, cannot_speak_for_the_machine) {
  for (const char* tier : {"A", "B", "C"}) {
    Submission submission(std::string("words") + tier);
    std::vector<std::string> words = submission.put("words");
    words.insert(words.end(), {"--no-pictures", "--isolation", tier});
    const Outcome outcome = submission.grade(words);
    if (outcome.output.find("isolation does not work here") == 0) continue;
    EXPECT_EQ(outcome.exit_status, 1) << tier << outcome.output;
    for (const char* slug : {"camera_ray", "hit_triangle", "hit_sphere", "hit_box"}) {
      EXPECT_EQ(outcome.task(slug).value("reason", ""), "it does not compile") << tier << slug;
    }
    EXPECT_EQ(outcome.state("build_bvh"), "crash") << tier;
    const std::string promises = outcome.task("build_bvh").at("promises").dump();
    EXPECT_NE(promises.find("ended by itself, with exit status 137"), std::string::npos)
        << tier << promises.substr(0, 1500);
  }
}

// Whatever a submission prints, throws or makes the compiler and the loader say: a report that is given
// back shows where its own files are, and no path of the judge's machine.
TEST(hostile, is_shown_no_path_of_the_judge) {
  for (const char* tier : {"A", "B"}) {
    Submission submission(std::string("paths") + tier);
    const fs::path page = submission / "page.html";
    std::vector<std::string> words = submission.put("paths");
    words.insert(words.end(),
                 {"--no-pictures", "--isolation", tier, "--name", "ada", "--html", page});
    const Outcome outcome = submission.grade(words);
    if (outcome.output.find("isolation does not work here") == 0) continue;
    EXPECT_EQ(outcome.exit_status, 1) << outcome.output;
    const std::string text = outcome.results.dump() + text_of(page);
    for (const std::string& path : {std::string(FIRSTLIGHT_ROOT "/"), submission.work().string(),
                                    (submission / "1_rays").string()}) {
      const std::size_t at = text.find(path);
      EXPECT_EQ(at, text.npos) << tier << text.substr(at < 200 ? 0 : at - 200, 400);
    }
    const auto says = [&](const char* slug, const std::string& sentence) {
      const std::string task = outcome.task(slug).dump();
      EXPECT_NE(task.find(sentence), task.npos) << tier << task.substr(0, 1500);
    };
    const std::string own = "1_rays/camera_ray.cpp";
    says("camera_ray", fmt::format("{0} {0} {0} {0}", own));
    says("hit_triangle", "student/1_rays/hit_triangle.cpp:2:");
  }
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

// camera_ray is right during the calls of its own properties, some 70,000, and wrong in those of estimate_pixel, which come later.
TEST(grade, blames_the_task_whose_exchange_mends_another) {
  const Submission submission("blame");
  std::string text = text_of(FIRSTLIGHT_ROOT "/reference/1_rays/camera_ray.cpp");
  const std::size_t body = text.find("Ray camera_ray(");
  ASSERT_NE(body, std::string::npos);
  const std::size_t brace = text.find('{', body) + 1;
  text.insert(brace, "\n  thread_local int calls = 0;\n  if (++calls > 130000) return {};\n");
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
}  // namespace grader::tests
