// Judging a task with the submission's other tasks while it is still judged alone.
#include "grader/service/judging/alone.h"
#include "grader/service/judging/together.h"
#include "grader/tasks.h"

#include <algorithm>
#include <filesystem>

#include <gtest/gtest.h>

namespace grader::judging {
namespace {

namespace fs = std::filesystem;

const char* kAsked = "estimate_pixel";

// A submission's estimate_pixel, which needs camera_ray; nothing has been judged before.
struct Ahead : testing::Test {
  Ahead() {
    fs::remove_all(config.work + "/cache");  // the compiled headers stay for all tests
    fs::remove_all(submission);
    fs::create_directories(config.work);
    fs::copy(config.root + "/reference", submission, fs::copy_options::recursive);
    request.submission = submission;
    request.asked = {kAsked};
    request.threads = 1;
    request.pictures = false;
  }
  static void TearDownTestSuite() {
    std::error_code ignored;
    fs::remove_all(work(), ignored);
  }
  static std::string work() { return fs::current_path() / "ahead_test.work"; }

  // The number of property verdicts that each step left in the cache.
  struct Found {
    long tasks = 0, alone = 0, together = 0;
    results::State state{};
  };
  Found judge() const {
    const build::Builder builder(config, request.isolation.tier, request.compile_limit);
    std::vector<Judged> judged;
    for (const build::TaskConfig& task : config.tasks) {
      const bool needed = std::ranges::count(needs(kAsked), task.slug) > 0;
      if (needed || task.slug == kAsked) judged.push_back(not_judged(config, task));
    }
    compile_all(builder, request, judged);
    Found found;
    found.tasks = static_cast<long>(judged.size());
    judge_alone(config, builder, request, judged, [] {});
    found.alone = verdicts(builder);
    judge_together(config, builder, request, judged, [] {});
    found.together = verdicts(builder) - found.alone;
    for (const Judged& each : judged) {
      if (each.config->slug == kAsked) found.state = each.result.state;
    }
    return found;
  }

  static long verdicts(const build::Builder& builder) {
    return std::ranges::count_if(fs::directory_iterator(builder.cache()), [](const auto& entry) {
      return entry.path().extension() == ".json";
    });
  }

  build::Config config = [] {
    build::Config known = build::load_config(FIRSTLIGHT_CHECKS "/grade.json");
    known.work = work();
    return known;
  }();
  std::string submission = config.work + "/submission";
  GradeRequest request;
};

TEST_F(Ahead, leaves_nothing_to_find_out_where_the_task_is_right) {
  const Found found = judge();
  EXPECT_EQ(found.state, results::State::pass);
  EXPECT_EQ(found.alone, found.tasks + 1);
  EXPECT_EQ(found.together, 0);
}

TEST_F(Ahead, is_left_alone_where_the_task_is_wrong) {
  fs::copy_file(config.root + "/student/1_rays/estimate_pixel.cpp",
                submission + "/1_rays/estimate_pixel.cpp", fs::copy_options::overwrite_existing);
  const Found found = judge();
  EXPECT_NE(found.state, results::State::pass);
  EXPECT_EQ(found.alone, found.tasks);
  EXPECT_EQ(found.together, 0);
}

TEST_F(Ahead, is_not_tried_where_more_is_asked_for) {
  request.asked = {kAsked, "camera_ray"};
  const Found found = judge();
  EXPECT_EQ(found.state, results::State::pass);
  EXPECT_EQ(found.alone, found.tasks);
  EXPECT_GE(found.together, 1);
}

}  // namespace
}  // namespace grader::judging
