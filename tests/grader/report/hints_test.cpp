// Hints: their files, the memory between two of them, and the program that gives them.
#include "grader/report/hints.h"

#include "grader/results/promises.h"
#include "grader/service/process/run_command.h"
#include "grader/tasks.h"
#include "pt/error.h"
#include "pt/file.h"
#include "tests/fixtures/grader_fixture.h"

#include <algorithm>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

namespace grader::report {
namespace {

using testing::HasSubstr;

const std::string kTasks = FIRSTLIGHT_ROOT "/grader/tasks";

TEST(hints, every_task_has_three_tiers_about_its_own_promises) {
  std::size_t count = 0;
  for (const auto& folder : std::filesystem::directory_iterator(kTasks)) {
    const std::string slug = folder.path().filename();
    const std::string path = folder.path() / "hints.md";
    Hints hints;
    ASSERT_NO_THROW(hints = parse_hints(pt::read_file(path), path)) << path;
    const auto promises =
        results::promises_of(pt::read_file(FIRSTLIGHT_ROOT "/pt/tasks/" + slug + ".h"));
    for (const HintStep& step : hints) {
      for (const PromiseHint& hint : step.promises) {
        const std::string name = results::property_name(hint.title);
        EXPECT_TRUE(std::any_of(promises.begin(), promises.end(),
                                [&](const results::Promise& promise) {
                                  return promise.name == name || promise.name == name + "_bonus";
                                }))
            << path << ": no promise is called '" << hint.title << "'";
      }
    }
    ++count;
  }
  EXPECT_EQ(count, tasks().size());
}

TEST(hints, are_read_tier_by_tier) {
  const Hints hints = parse_hints(
      "# Title\n\n## Question\n\nWhat?\n\n### keeps t inside the ray\nWhere?\n\n"
      "## Direction\nThere.\nAnd there.\n\n## Usual mistake\n\nNot there.\n",
      "x");
  EXPECT_EQ(about(hints[0], ""), "What?");
  EXPECT_EQ(about(hints[0], "keeps_t_inside_the_ray"), "Where?");
  EXPECT_EQ(about(hints[0], "keeps_t_inside_the_ray_bonus"), "Where?");
  EXPECT_EQ(about(hints[0], "misses_outside"), "What?");
  EXPECT_EQ(about(hints[1], "keeps_t_inside_the_ray"), "There.\nAnd there.");
  EXPECT_EQ(about(hints[2], ""), "Not there.");
}

std::string error_of(const std::string& text) {
  try {
    parse_hints(text, "hints.md");
  } catch (const pt::Error& error) {
    return error.what();
  }
  return "none";
}

TEST(hints, that_are_not_complete_are_refused_with_the_line) {
  EXPECT_EQ(error_of("## Question\na\n## Direction\nb\n"),
            "hints.md:4: the step '## Usual mistake' is missing; write it");
  EXPECT_EQ(error_of("## Question\na\n## Usual mistake\nb\n"),
            "hints.md:3: write the heading '## Direction' here");
  EXPECT_EQ(error_of("## Question\n\n## Direction\nb\n## Usual mistake\nc\n"),
            "hints.md:1: this heading has no text below it; write some");
  EXPECT_EQ(error_of("## Question\na\n### p\n## Direction\nb\n## Usual mistake\nc\n"),
            "hints.md:3: this heading has no text below it; write some");
  EXPECT_EQ(error_of("## Question\na\n## Direction\nb\n## Usual mistake\nc\n## More\nd\n"),
            "hints.md:7: a step too many; leave it out");
  EXPECT_THAT(error_of("### p\na\n"), HasSubstr("hints.md:1: a promise comes below a step"));
  EXPECT_THAT(error_of(""), HasSubstr("'## Question' is missing"));
}

results::PromiseResult failed(const std::string& name, bool bonus = false) {
  results::PromiseResult promise{name, name, bonus, false, 1, 0, {}};
  promise.failures.emplace_back();
  return promise;
}

results::Results results_of(results::State state, std::vector<results::PromiseResult> promises) {
  results::Results results;
  results.seed = 7;
  results::TaskResult& task = results.tasks.emplace_back();
  task.slug = "hit_triangle";
  task.state = state;
  task.promises = std::move(promises);
  return results;
}

TEST(memory, holds_what_failed_last_and_forgets_hints_when_the_task_passes) {
  const GraderFolder folder;
  Memory memory;
  memory.given = {{"", 2}, {"misses_outside", 1}};
  remember(folder.path(), "hit_triangle", memory);
  remember_failures(folder.path(),
                    results_of(results::State::fail,
                               {failed("extra_bonus", true), failed("one"), failed("two")}));
  memory = recall(folder.path(), "hit_triangle");
  EXPECT_EQ(memory.seed, 7u);
  EXPECT_EQ(memory.fails, (std::vector<std::string>{"one", "two", "extra_bonus"}));
  EXPECT_EQ(memory.given, (std::map<std::string, int>{{"", 2}, {"misses_outside", 1}}));

  // The report shows an exact answer before a mean, and a crash before both: the hint is about the first.
  auto mean = failed("mean"), exact = failed("exact"), dead = failed("dead");
  mean.failures[0].statistical = true;
  dead.failures[0].cause = results::Cause::crash;
  results::PromiseResult kept;
  kept.held = true;
  remember_failures(folder.path(), results_of(results::State::crash, {mean, exact, dead, kept}));
  EXPECT_EQ(recall(folder.path(), "hit_triangle").fails,
            (std::vector<std::string>{"dead", "exact", "mean"}));

  results::Results broken = results_of(results::State::rejected, {});
  broken.tasks[0].compiler_output = "error: expected ';'";
  remember_failures(folder.path(), broken);
  EXPECT_EQ(recall(folder.path(), "hit_triangle").fails.size(), 3u);

  remember_failures(folder.path(), results_of(results::State::pass, {}));
  EXPECT_TRUE(recall(folder.path(), "hit_triangle").fails.empty());
  EXPECT_TRUE(recall(folder.path(), "hit_triangle").given.empty());
  EXPECT_TRUE(recall(folder.path(), "hit_sphere").fails.empty());
}

struct Answer {
  int status;
  std::string text;
};

Answer hint(const GraderFolder& folder, std::vector<std::string> arguments) {
  process::Child child{
      {HINT_PROGRAM, "--root", FIRSTLIGHT_ROOT, "--work", folder.path() + "/work"}, {}, {}, "", {}};
  child.command.insert(child.command.end(), arguments.begin(), arguments.end());
  const process::CommandResult result = process::run_command(child, std::chrono::seconds(60));
  return {WEXITSTATUS(result.status), result.output};
}

TEST(hint_program, gives_one_tier_after_the_other_and_then_says_so) {
  const GraderFolder folder;
  EXPECT_THAT(hint(folder, {"hit_sphere"}).text, HasSubstr("Question (1 of 3)"));
  EXPECT_THAT(hint(folder, {"1.4"}).text, HasSubstr("Direction (2 of 3)"));
  EXPECT_THAT(hint(folder, {"hit_sphere"}).text, HasSubstr("Usual mistake (3 of 3)"));
  const Answer spent = hint(folder, {"hit_sphere"});
  EXPECT_EQ(spent.status, 0);
  EXPECT_THAT(spent.text, HasSubstr("There are no more hints"));
  EXPECT_THAT(hint(folder, {"hit_sphere", "--first"}).text, HasSubstr("Question (1 of 3)"));
  EXPECT_THAT(hint(folder, {"hit_triangle"}).text, HasSubstr("Question (1 of 3)"));
}

TEST(hint_program, is_about_the_promise_that_failed_or_was_asked_for) {
  const GraderFolder folder;
  const std::string work = folder.path() + "/work";
  remember_failures(work,
                    results_of(results::State::fail, {failed("interpolates_the_corner_normals")}));
  const std::string text = hint(folder, {"hit_triangle"}).text;
  EXPECT_THAT(text, HasSubstr("hit_triangle interpolates the corner normals\nQuestion (1 of 3)"));
  EXPECT_THAT(text, HasSubstr("At corner 1 itself"));

  const std::string asked = hint(folder, {"hit_triangle", "works", "at", "every", "scale"}).text;
  EXPECT_THAT(asked, HasSubstr("Question (1 of 3)"));
  EXPECT_THAT(asked, HasSubstr("a millionth across"));
  EXPECT_THAT(hint(folder, {"hit_triangle"}).text, HasSubstr("Direction (2 of 3)"));
}

TEST(hint_program, refuses_what_it_does_not_know) {
  const GraderFolder folder;
  const Answer task = hint(folder, {"hit_cone"});
  EXPECT_EQ(task.status, 2);
  // A course may have more tasks than ours (docs/adding_a_task.md).
  std::string slugs;
  for (const Task& each : tasks()) slugs += (slugs.empty() ? "" : ", ") + each.slug;
  EXPECT_EQ(task.text, "'hit_cone' is not a task; choose one of " + slugs + "\n");
  EXPECT_THAT(slugs, HasSubstr("estimate_pixel, camera_ray, hit_triangle"));
  const Answer promise = hint(folder, {"hit_sphere", "is round"});
  EXPECT_EQ(promise.status, 2);
  EXPECT_THAT(promise.text, HasSubstr("hit_sphere does not promise 'is round'; choose one of: "));
}

}  // namespace
}  // namespace grader::report
