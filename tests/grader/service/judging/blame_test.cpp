// The tasks that are blamed for a picture that is right with the reference's other tasks and wrong
// with the submission's.
#include "grader/results/json.h"
#include "grader/service/judging/alone.h"
#include "grader/service/judging/pictures.h"
#include "grader/service/judging/together.h"
#include "pt/file.h"

#include <filesystem>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace grader::judging {
namespace {

namespace fs = std::filesystem;

// The reference's trace_path and direct_lights, as a submission. A script replaces the program that
// judges pictures: it chooses the verdict by the arguments.
struct Blame : testing::Test {
  Blame() {
    fs::create_directories(config.work);
    request.submission = config.root + "/reference";
    request.asked = {"trace_path"};
    request.threads = 1;
    config.picture = config.work + "/picture";
  }
  ~Blame() override {
    std::error_code ignored;
    fs::remove_all(config.work, ignored);
  }

  std::string verdict(results::State state, const std::string& text) const {
    results::Results results;
    results::PictureResult picture;
    picture.recipe = "RECIPE";
    picture.state = state;
    picture.text = text;
    results.complete = true;
    results.tasks.emplace_back().slug = "trace_path";
    results.tasks[0].state = state;
    results.tasks[0].pictures.push_back(picture);
    std::string path = fmt::format("{}/{}.json", config.work, text);
    results::write_json(results, path);
    return path;
  }

  // `fails` is a shell condition on $worker and $integrated.
  void judge_by(const std::string& fails) const {
    const std::string options =
        "integrated=no\n"
        "while [ $# -gt 0 ]; do\n"
        "  case $1 in\n"
        "    --worker) worker=$2 ;;\n"
        "    --recipe) recipe=$2 ;;\n"
        "    --report) report=$2 ;;\n"
        "    --integrated) integrated=yes ;;\n"
        "  esac\n"
        "  shift\n"
        "done\n";
    pt::write_file(config.picture,
                   "#!/bin/sh\n" + options +
                       fmt::format("verdict='{}'\n"
                                   "if [ {} ]; then verdict='{}'; fi\n"
                                   "sed \"s/RECIPE/$recipe/\" \"$verdict\" >\"$report\"\n",
                                   verdict(results::State::pass, "right"), fails,
                                   verdict(results::State::fail, "too dark")));
    fs::permissions(config.picture, fs::perms(0755));
  }

  std::vector<Judged> submitted(const build::Builder& builder) const {
    std::vector<Judged> judged;
    for (const build::TaskConfig& task : config.tasks) {
      if (task.slug == "trace_path" || task.slug == "direct_lights") {
        judged.push_back(not_judged(config, task));
      }
    }
    compile_all(builder, request, judged);
    for (Judged& each : judged) {
      each.right_alone = each.object.ok();
      each.result.state = results::State::pass;
    }
    list_pictures(config, request, judged);
    return judged;
  }

  // The pictures of trace_path.
  std::vector<results::PictureResult> pictures(const build::Builder& builder,
                                               std::vector<Judged> judged) const {
    judge_pictures(config, builder, request, judged, [] {});
    return judged.back().result.pictures;
  }

  build::Config config = [] {
    build::Config known = build::load_config(FIRSTLIGHT_CHECKS "/grade.json");
    known.work = fs::current_path() / "blame_test.work";
    return known;
  }();
  GradeRequest request;
};

TEST_F(Blame, is_for_the_task_whose_exchange_mends_a_picture) {
  const build::Builder builder(config, request.isolation.tier, request.compile_limit);
  const std::vector<Judged> judged = submitted(builder);
  const build::Built together = link_together(config, builder, judged, Elsewhere::reference);
  judge_by(fmt::format("\"$worker\" = '{}'", together.path));
  const auto found = pictures(builder, judged);
  ASSERT_FALSE(found.empty());
  for (const results::PictureResult& picture : found) {
    EXPECT_EQ(picture.state, results::State::fail) << picture.recipe;
    EXPECT_EQ(picture.text,
              "right with the reference elsewhere, not with your other tasks: too dark (only with "
              "your direct_lights)")
        << picture.recipe;
  }
}

// Some samples reveal a small mistake and others do not.
TEST_F(Blame, is_for_no_other_task_if_the_same_samples_are_wrong_with_the_reference) {
  const build::Builder builder(config, request.isolation.tier, request.compile_limit);
  judge_by("$integrated = yes");
  const auto found = pictures(builder, submitted(builder));
  ASSERT_FALSE(found.empty());
  for (const results::PictureResult& picture : found) {
    EXPECT_EQ(picture.state, results::State::fail) << picture.recipe;
    EXPECT_EQ(picture.text, "too dark") << picture.recipe;
  }
}

}  // namespace
}  // namespace grader::judging
