// The reports of one run: each follows the rules of its format, and all say the same.
#include "grader/report/autograders.h"
#include "grader/report/csv.h"
#include "grader/report/html.h"
#include "grader/report/terminal.h"
#include "grader/report/write_reports.h"
#include "grader/results/json.h"
#include "grader/results/presentable.h"
#include "grader/results/summary.h"
#include "grader/tasks.h"
#include "pt/error.h"
#include "pt/file.h"
#include "tests/grader/report/example_run.h"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace grader::report {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

class Writers : public ExampleRun {};

TEST_F(Writers, what_is_not_judged_is_named_so) {
  const results::Results results = half_judged();
  EXPECT_THAT(to_csv(results), HasSubstr("direct_lights,not_judged,5,17,0,"));
  EXPECT_THAT(to_csv(results), HasSubstr("adaptive_pixel,not_judged,0,8,0,"));
  const std::string text = to_text(results, {false, true});
  EXPECT_THAT(text, HasSubstr("direct_lights      not judged       5/17\n"));
  EXPECT_THAT(text, HasSubstr("1 of 9 tasks pass, 3 not judged yet. "));
  EXPECT_THAT(text, Not(HasSubstr("penumbra")));
}

TEST_F(Writers, csv_is_a_line_a_task) {
  results::Results results = run;
  results.submission = "a \"b\", c";
  results.tasks.resize(2);
  EXPECT_EQ(to_csv(results),
            std::string(kByteOrderMark) +
                "submission,number,task,state,points,max_points,bonus_points,seconds,complete\r\n"
                "\"a \"\"b\"\", c\",1.1,estimate_pixel,pass,2,2,1,0.80,true\r\n"
                "\"a \"\"b\"\", c\",1.3,hit_triangle,fail,1,2,0,0.80,true\r\n");
  results.complete = false;
  EXPECT_THAT(to_csv(results), HasSubstr("0.80,false\r\n"));
}

// Two promises take .4 seconds, and five pictures .8.
TEST_F(Writers, csv_has_the_time_of_promises_and_pictures) {
  EXPECT_THAT(to_csv(run), HasSubstr(",3.3,direct_lights,fail,6,17,0,4.80,true\r\n"));
}

TEST_F(Writers, csv_holds_no_formula) {
  results::Results results = run;
  for (const char* start : {"=", "+", "-", "@", "\uff1d", "\uff20"}) {
    results.submission = std::string(start) + "SUM(A1)";
    EXPECT_THAT(to_csv(results), HasSubstr("\r\n'" + results.submission + ",")) << start;
  }
  EXPECT_EQ(csv_field("\t=1"), "' =1");
  EXPECT_EQ(csv_field("\r=1"), "\uFFFD=1");
  EXPECT_EQ(csv_field("a\n\"b\""), "\"a \"\"b\"\"\"");
  EXPECT_EQ(csv_field("a;b"), "\"a;b\"");
  EXPECT_EQ(csv_field("1-2"), "1-2");
}

// A name that would begin a new line of the table, or colour it.
TEST_F(Writers, names_stand_in_one_line) {
  results::Results results = run;
  results.submission = "ada\n\x1b[31mgrace\tx\xc2\x9b";
  results.tasks.resize(1);
  EXPECT_EQ(results::presentable(results).submission, "ada \ufffd[31mgrace x\ufffd");
  const std::string table = to_csv(results);
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 2) << table;
  EXPECT_EQ(results::one_line("plain caf\u00e9"), "plain caf\u00e9");
}

TEST_F(Writers, the_terminal_shows_pictures) {
  const std::string text = to_text(run, {false, true});
  EXPECT_THAT(text, HasSubstr("penumbra         fail              0/3  picture\n"));
  EXPECT_THAT(text, HasSubstr("large_light      too noisy         1/3  picture\n"));
  EXPECT_THAT(text, Not(HasSubstr("two_lights")));
  EXPECT_THAT(text, HasSubstr("direct_lights: picture penumbra, A disc in a gradient (fail, 0 of 3 "
                              "points)\n\n  This block was 21.0 % too dark"));
  EXPECT_THAT(text,
              HasSubstr("  page      ./run grade direct_lights --seed 7 --html report.html\n"));
  EXPECT_THAT(text,
              HasSubstr("27.0 s (properties 5.9 s, pictures 21.0 s). Isolation A: bubblewrap. "
                        "Firstlight 1.2.3.\n"));
  EXPECT_THAT(text, Not(HasSubstr(results::kStopped)));
  EXPECT_THAT(to_text(stopped(), {}), HasSubstr(results::kStopped));
}

// A task that keeps all other promises passes, and the report says which bonus it misses and why.
TEST_F(Writers, a_bonus_that_is_missed_is_named_with_its_reason) {
  results::Results results = run;
  results.tasks.resize(1);
  results::PromiseResult bonus = run.tasks[1].promises[1];
  bonus.name = "extra_bonus";
  bonus.words = "does more (bonus): than it has to.";
  bonus.bonus = true;
  ASSERT_FALSE(bonus.held);
  results.tasks[0].promises.push_back(bonus);
  const std::string text = to_text(results, {});
  EXPECT_THAT(text, HasSubstr("2/2  + 1 bonus\n         without the bonus: does more\n"));
  EXPECT_THAT(text, HasSubstr("estimate_pixel does more (bonus): than it has to.\n"));
  EXPECT_THAT(text, HasSubstr("  got       " + bonus.failures[0].got));
  EXPECT_TRUE(results::passes(results));
  const std::string page = to_html(results);
  EXPECT_THAT(page, HasSubstr("<span class=\"note\">without the bonus: does more</span>"));
  EXPECT_THAT(page, HasSubstr("<details class=\"promise\" open><summary"));
  // If another promise fails too, it comes first.
  results.tasks[0].promises[0].held = false;
  results.tasks[0].state = results::State::fail;
  EXPECT_THAT(to_text(results, {}), Not(HasSubstr("does more")));
}

TEST_F(Writers, the_columns_of_the_terminal_are_as_wide_as_the_longest_name) {
  results::Results results = run;
  results.tasks[6].pictures[1].recipe = "the_penumbra_of_a_large_light";
  const std::string text = table(results, {});
  const std::size_t state = text.find("fail", text.find("the_penumbra_of"));
  const std::size_t line = text.rfind('\n', state);
  EXPECT_EQ(state - line, 1 + 7 + 2 + 29 + 1);
  const std::size_t first = text.find("estimate_pixel");
  EXPECT_EQ(text.find("pass", first) - text.rfind('\n', first), state - line);
}

TEST_F(Writers, the_terminal_shows_the_first_failure) {
  results::Results results = run;
  results.tasks.erase(results.tasks.begin(), results.tasks.begin() + 6);
  const std::string text = to_text(results, {});
  EXPECT_THAT(text, HasSubstr("This block was 21.0 % too dark"));
  EXPECT_THAT(text, Not(HasSubstr("right on average")));
  EXPECT_THAT(text, HasSubstr("4 more; --all shows them.\n"));
}

// The output of a task helps with the failure that is shown.
TEST_F(Writers, the_terminal_shows_what_a_task_printed_below_its_first_failure) {
  results::Results results = run;
  results.tasks.erase(results.tasks.begin(), results.tasks.begin() + 6);
  results.tasks[0].printed = "det is 0\n" + std::string(5000, 'x');
  const std::string text = to_text(results, {});
  const std::size_t printed = text.find("\n  printed\n    det is 0\n    xxx");
  EXPECT_LT(text.find("This block was 21.0 % too dark"), printed);
  EXPECT_LT(printed, text.find("4 more; --all"));
  EXPECT_THAT(text, Not(HasSubstr(std::string(500, 'x'))));
}

TEST_F(Writers, the_table_has_bonus_points_and_what_a_task_waits_for) {
  const std::string text = table(run, {});
  EXPECT_THAT(text, HasSubstr("estimate_pixel     pass              2/2  + 1 bonus\n"));
  EXPECT_THAT(text, HasSubstr("hit_triangle       fail              1/2\n"));
  EXPECT_THAT(text, HasSubstr("hit_bvh            blocked           2/2  by hit_box\n"));
}

// If a promise fails in two ways, the first failure is enough, unless all are requested.
TEST_F(Writers, the_terminal_shows_one_failure_of_a_promise) {
  results::Results results = run;
  results.tasks = {run.tasks[1]};
  std::vector<results::Failure>& failures = results.tasks[0].promises[1].failures;
  failures.push_back(failures[0]);
  failures[1].got = "-7";
  EXPECT_THAT(to_text(results, {}), HasSubstr("  got       -1\n"));
  EXPECT_THAT(to_text(results, {}), Not(HasSubstr("  got       -7\n")));
  EXPECT_THAT(to_text(results, {false, true}), HasSubstr("  got       -1\n"));
  EXPECT_THAT(to_text(results, {false, true}), HasSubstr("  got       -7\n"));
}

TEST_F(Writers, the_terminal_says_which_tasks_were_the_submissions) {
  results::Results results = run;
  results.tasks = {run.tasks[1]};
  EXPECT_THAT(to_text(results, {}), Not(HasSubstr("tasks yours")));
  results.tasks[0].promises[1].failures[0].integrated = true;
  EXPECT_THAT(
      to_text(results, {}),
      HasSubstr(fmt::format("  With all {} tasks yours:\n  input     triangle", tasks().size())));
}

// If one command shows a picture and another renders it again, both are given.
TEST_F(Writers, the_terminal_says_how_a_picture_is_made_again) {
  results::Results results = run;
  results.tasks = {run.tasks[6]};
  results.tasks[0].pictures = {run.tasks[6].pictures[1]};
  EXPECT_THAT(to_text(results, {}), Not(HasSubstr("  replay    ")));
  results.tasks[0].pictures[0].replay = "./run render a.dae";
  EXPECT_THAT(to_text(results, {}),
              HasSubstr("  replay    ./run render a.dae\n"
                        "  see it    ./run view penumbra --pixel 52 43 --from reference --from "
                        "direct_lights=student\n"
                        "  page      ./run grade direct_lights --html report.html\n"));
}

// A promise fails; the pixel is one of a picture that is wrong.
TEST_F(Writers, the_terminal_says_where_to_see_a_broken_promise) {
  results::Results results = run;
  results.tasks = {run.tasks[1]};
  EXPECT_THAT(to_text(results, {}), Not(HasSubstr("see it")));
  results.tasks[0].pictures = {run.tasks[6].pictures[4], run.tasks[6].pictures[1]};
  EXPECT_THAT(to_text(results, {}),
              HasSubstr("  hint      ./run hint hit_triangle\n"
                        "  see it    ./run view penumbra --pixel 52 43 --from reference --from "
                        "hit_triangle=student\n"));
}

TEST(HowToLook, names_a_pixel_from_the_bottom_left_and_whose_tasks_there_are) {
  results::PictureResult picture;
  picture.recipe = "bvh_coil";
  picture.height = 72;
  picture.replay = "./run grade hit_bvh --seed 1";
  EXPECT_EQ(results::how_to_look("hit_bvh", picture),
            "./run view bvh_coil --from reference --from hit_bvh=student");
  picture.cells = {{40, 48, 8, 8, "Y", -0.4, 2}, {0, 0, 24, 24, "Y", -0.1, 2}};
  picture.integrated = true;
  picture.replay += " --submission 'a b'";
  EXPECT_EQ(results::how_to_look("hit_bvh", picture),
            "./run view bvh_coil --pixel 44 19 --from student --submission 'a b'");
}

// A task that has not been started contains no mistake.
TEST_F(Writers, the_terminal_shows_no_failure_of_what_is_not_written) {
  results::Results results = run;
  results.tasks = {run.tasks[0], run.tasks[7]};
  results.tasks[1].reason = "it is not written yet";
  for (const bool all : {false, true}) {
    EXPECT_THAT(to_text(results, {false, all}), Not(HasSubstr("it is not written yet")));
    EXPECT_THAT(to_text(results, {false, all}), Not(HasSubstr("--all")));
  }
}

TEST_F(Writers, all_files_are_written_or_none) {
  const std::string& here = folder.path();
  ReportFiles files{here + "/a.json", here + "/a.html", here + "/a.xml", {}, here + "/a.csv"};
  for (const Autograder& each : kAutograders) files.autograders[each.name] = here + "/" + each.name;
  check_targets(files);
  write_reports(stopped(), files);
  EXPECT_EQ(results::read_results(files.json), results::presentable(stopped()));
  std::vector<std::string> said{files.html, files.junit};
  for (const auto& [name, path] : files.autograders) said.push_back(path);
  EXPECT_EQ(said.size(), 6);
  for (const std::string& path : said) {
    EXPECT_THAT(pt::read_file(path, 1 << 24), HasSubstr("This run was stopped before it ended"));
  }
  EXPECT_THAT(pt::read_file(files.csv, 1 << 24), HasSubstr(",false\r\n"));
  files.autograders["artemis"] = here + "/nowhere/a.xml";
  EXPECT_THROW(check_targets(files), pt::Error);
  files.autograders.clear();
  files.html = here + "/nowhere/a.html";
  EXPECT_THROW(check_targets(files), pt::Error);
}

// Each section and each contract is where the page says, seen from its folder.
TEST_F(Writers, a_page_in_the_project_has_links_that_lead_somewhere) {
  namespace fs = std::filesystem;
  const std::string& root = folder.path();
  ReportFiles files;
  files.root = root;
  const auto page_at = [&](const std::string& path) {
    fs::create_directories(fs::path(path).parent_path());
    files.html = path;
    write_reports(run, files);
    return pt::read_file(path, 1 << 24);
  };
  EXPECT_THAT(page_at(root + "/a.html"), Not(HasSubstr("README.md#")));
  fs::create_directories(root + "/student/1_rays");
  pt::write_file(root + "/student/1_rays/README.md", "# Rays\n");
  EXPECT_THAT(page_at(root + "/a.html"), HasSubstr("<a href=\"./student/1_rays/README.md#14-"));
  const std::string below = page_at(root + "/build/b c/a.html");
  EXPECT_THAT(below, HasSubstr("<a href=\"../../student/1_rays/README.md#14-hit_sphere\">"));
  EXPECT_THAT(below, HasSubstr("<code>pt/tasks/hit_sphere.h</code>"));
  EXPECT_THAT(below, HasSubstr("<code>student/2_bvh/README.md</code>"));
  const TemporaryFolder elsewhere;
  EXPECT_THAT(page_at(elsewhere.path() + "/a.html"), Not(HasSubstr("README.md#")));
  files.root.clear();
  EXPECT_THAT(page_at(root + "/a.html"), Not(HasSubstr("README.md#")));
}

TEST(Handbook, has_a_section_for_each_task) {
  for (const Task& task : tasks()) {
    const std::string page = pt::read_file(FIRSTLIGHT_ROOT "/student/" + task.part + "/README.md");
    EXPECT_THAT(page, HasSubstr("\n## " + task.number + " " + task.slug + "\n"));
  }
}

TEST_F(Writers, a_run_leaves_the_page_of_its_end) {
  ReportFiles files;
  files.html = folder.path() + "/a.html";
  files.csv = folder.path() + "/a.csv";
  ProgressReports reports(files);
  results::Results so_far = stopped();
  reports.write(so_far);
  EXPECT_THAT(pt::read_file(files.html, 1 << 24), HasSubstr(results::kStopped));
  so_far.tasks.resize(1);
  reports.write(so_far);
  EXPECT_EQ(pt::read_file(files.csv, 1 << 24), to_csv(so_far));
  reports.write(run);
  EXPECT_THAT(pt::read_file(files.html, 1 << 24), Not(HasSubstr(results::kStopped)));
}

}  // namespace
}  // namespace grader::report
