// The page: its content, and no more than it should contain.
#include "grader/report/html.h"
#include "grader/results/summary.h"
#include "pt/image/image_io.h"
#include "tests/grader/report/example_run.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace grader::report {
namespace {

using testing::HasSubstr;
using testing::Not;

int count(const std::string& text, const std::string& part) {
  int found = 0;
  for (std::size_t i = text.find(part); i != std::string::npos; i = text.find(part, i + 1)) ++found;
  return found;
}

class Page : public ExampleRun {};

TEST_F(Page, says_all_that_there_is_to_say) {
  const std::string text = to_html(run);
  for (const char* part :
       {"1 of 9 tasks pass", "<strong>18</strong> of 39 points, and\n1 bonus", "A: bubblewrap",
        "27.0 s (properties 5.9 s, pictures 21.0 s)", "g++ 12.2.0", "bubblewrap 0.8.0",
        "This block was 21.0 % too dark in three independent renders.", "\u221221.0 %",
        "ray {o (0.25, 0.25, 1), d (0, 0, -1)}", "<dd>7</dd>", "is a link",
        "./run grade hit_triangle --seed 7", "4.1 times the variance", "Part 3 <span>direct</span>",
        "The first of 2 blocks that fail (8x8 at 48, 24) is off by \u221221.0 %: 2.4 times"}) {
    EXPECT_THAT(text, HasSubstr(part));
  }
  for (const results::State state : results::kStates)
    EXPECT_THAT(text, HasSubstr(results::words(state) + "</span>"));
  EXPECT_THAT(text, Not(HasSubstr(results::kStopped)));
}

TEST_F(Page, folds_long_inputs) {
  EXPECT_THAT(to_html(run), Not(HasSubstr("more lines</summary>")));
  results::Results long_inputs = run;
  for (results::TaskResult& task : long_inputs.tasks) {
    for (results::PromiseResult& promise : task.promises) {
      for (results::Failure& failure : promise.failures) {
        failure.input.clear();
        for (int i = 0; i < 30; ++i) failure.input.push_back("box " + std::to_string(i));
      }
    }
  }
  const std::string text = to_html(long_inputs);
  EXPECT_THAT(
      text,
      HasSubstr("<code>box 9</code><details><summary>20 more lines</summary><code>box 10</code>"));
  EXPECT_THAT(text, HasSubstr("<code>box 29</code></details>"));
  EXPECT_THAT(text, Not(HasSubstr("--json writes")));
}

// hit_sphere crashes, which is the most telling failure of the run.
TEST_F(Page, begins_with_the_task_to_work_on_and_folds_the_others) {
  const std::string text = to_html(run);
  EXPECT_THAT(text, HasSubstr("<h2>Work on this first"));
  EXPECT_EQ(count(text, "class=\"task\" id=\""), 9);
  EXPECT_EQ(count(text, "class=\"task\" id=\"hit_sphere\""), 1);
  EXPECT_LT(text.find("id=\"hit_sphere\""), text.find("Part 1 <span>"));
  EXPECT_THAT(text, HasSubstr("<a href=\"#hit_sphere\">hit_sphere</a>"));
  for (const results::TaskResult& task : run.tasks) {
    const bool leads = task.slug == "hit_sphere";
    EXPECT_THAT(text, HasSubstr("id=\"" + task.slug + (leads ? "\" open>" : "\">")));
  }
  results::Results results = run;
  std::erase_if(results.tasks, [](const auto& task) { return results::is_fault(task.state); });
  EXPECT_THAT(to_html(results), HasSubstr("<h2>Write this next"));
  EXPECT_THAT(to_html(results), HasSubstr("id=\"trace_path\" open"));
  results.tasks.resize(1);
  EXPECT_THAT(to_html(results), Not(HasSubstr("Write this next")));
}

// A task with five broken promises, each at three inputs, and one that is kept.
results::TaskResult broken_task(const results::Results& run) {
  results::TaskResult task = run.tasks[1];
  task.promises[1].failures.resize(3, task.promises[1].failures[0]);
  for (int i = 0; i < 4; ++i) task.promises.push_back(task.promises[1]);
  for (std::size_t i = 1; i < task.promises.size(); ++i) {
    task.promises[i].words = "promise " + std::to_string(i);
    for (results::Failure& failure : task.promises[i].failures)
      failure.got = std::to_string(10 * i);
  }
  return task;
}

// The text without what is inside closed folds: each <details> that is not open, but for its summary.
std::string in_sight(const std::string& text) {
  std::string seen;
  std::vector<bool> hides;
  for (std::size_t i = 0; i < text.size();) {
    const bool hidden = std::ranges::count(hides, true) > 0;
    if (text.compare(i, 8, "<details") == 0) {
      const std::size_t end = text.find('>', i);
      const bool open = text.substr(i, end - i).ends_with(" open");
      const std::size_t summary = text.find("</summary>", i);
      if (!hidden) seen += text.substr(end, summary - end);
      hides.push_back(!open);
      i = summary;
    } else if (text.compare(i, 10, "</details>") == 0) {
      if (hides.empty()) return "a fold ends that has not begun";
      hides.pop_back();
      i += 10;
    } else {
      if (!hidden) seen += text[i];
      ++i;
    }
  }
  EXPECT_TRUE(hides.empty());
  return seen;
}

TEST_F(Page, shows_one_input_of_one_promise) {
  results::Results results = run;
  results.tasks = {broken_task(run)};
  const std::string text = to_html(results), seen = in_sight(text);
  EXPECT_EQ(count(text, "<dt>got</dt>"), 15);
  EXPECT_EQ(count(seen, "<dt>got</dt>"), 1);
  EXPECT_EQ(count(text, "<dt>replay</dt>"), 1);
  EXPECT_THAT(seen, HasSubstr("<code class=\"got\">10</code>"));
  EXPECT_THAT(seen, HasSubstr("2 more inputs"));
  EXPECT_THAT(seen, HasSubstr("4 more promises fail; work on this one"));
  EXPECT_THAT(seen, HasSubstr("1 promise is kept"));
  EXPECT_THAT(seen, Not(HasSubstr("promise 2")));
  results.tasks[0].promises.resize(3);
  EXPECT_THAT(to_html(results), HasSubstr("1 more promise fails; work on this one"));
  results.tasks[0].promises.resize(2);
  EXPECT_THAT(to_html(results), Not(HasSubstr("work on this one")));
}

// A file that does not compile keeps no promise, and there is no input to show.
TEST_F(Page, leads_with_no_promise_if_none_failed_at_an_input) {
  results::Results results = run;
  results.tasks = {run.tasks[1]};
  for (results::PromiseResult& promise : results.tasks[0].promises) {
    promise.held = false;
    promise.failures.clear();
  }
  results.tasks[0].compiler_output = "error: expected ';'";
  const std::string seen = in_sight(to_html(results));
  EXPECT_THAT(seen, HasSubstr("error: expected &apos;;&apos;"));
  EXPECT_THAT(seen, HasSubstr("2 promises are not kept yet"));
  EXPECT_THAT(seen, Not(HasSubstr("returns the interpolated normal")));
}

// The reason stands once, and not with each promise.
TEST_F(Page, says_once_why_a_task_is_not_judged) {
  results::Results results = run;
  results.tasks = {run.tasks[1]};
  for (results::PromiseResult& promise : results.tasks[0].promises) {
    promise.held = false;
    promise.failures.clear();
  }
  results.tasks[0].state = results::State::not_attempted;
  results.tasks[0].reason = "there is no hit_triangle.cpp";
  const std::string text = to_html(results);
  EXPECT_EQ(count(text, "there is no hit_triangle.cpp"), 1);
  EXPECT_EQ(count(text, "<p class=\"promise"), static_cast<int>(results.tasks[0].promises.size()));
  EXPECT_EQ(count(text, "<details class=\"promise"), 0);
}

TEST_F(Page, shows_one_wrong_picture_and_folds_the_rest) {
  results::Results results = run;
  results.tasks = {run.tasks[6]};
  const std::string seen = in_sight(to_html(results));
  EXPECT_EQ(count(seen, "class=\"viewer\""), 1);
  EXPECT_THAT(seen, HasSubstr("This block was 21.0 % too dark"));
  EXPECT_THAT(seen, HasSubstr("4 more pictures, 3 wrong"));
  EXPECT_THAT(seen, HasSubstr("Where it differs, and how sure that is"));
  EXPECT_EQ(count(seen, "class=\"map\""), 0);
  EXPECT_EQ(count(seen, "class=\"cells\""), 0);
}

// A picture of the task shows where to look for a promise too; the command stands there once.
TEST_F(Page, says_where_to_see_a_failure) {
  results::Results results = run;
  results.tasks = {run.tasks[6]};
  const std::string command =
      "./run view penumbra --pixel 52 43 --from reference --from direct_lights=student";
  EXPECT_EQ(count(in_sight(to_html(results)), command), 1);
  results.tasks[0].promises[1] = run.tasks[1].promises[1];
  const std::string seen = in_sight(to_html(results));
  EXPECT_THAT(seen, HasSubstr("<dt>see it</dt><dd><code class=\"command\">" + command));
  EXPECT_EQ(count(seen, command), 1);
  results.tasks[0].pictures.clear();
  EXPECT_EQ(count(to_html(results), "see it"), 0);
}

TEST_F(Page, a_known_mistake_is_the_headline) {
  results::Results results = run;
  results.tasks = {run.tasks[1]};
  EXPECT_THAT(to_html(results), Not(HasSubstr("known mistake")));
  results.tasks[0].mistake = {"no_edge", "An edge is left out.", "battery", "Which edge?", false};
  const std::string seen = in_sight(to_html(results));
  EXPECT_THAT(seen,
              HasSubstr("This is a known mistake</span> <strong>An edge is left out.</strong>"));
  EXPECT_LT(seen.find("Which edge?"), seen.find("returns the interpolated normal"));
}

TEST_F(Page, leads_to_the_handbook_the_contract_and_the_hint) {
  results::Results results = run;
  results.tasks = {run.tasks[1]};
  const std::string named = to_html(results);
  for (const char* part : {"<code>student/1_rays/README.md</code>",
                           "<code>pt/tasks/hit_triangle.h</code>", "./run hint hit_triangle"}) {
    EXPECT_THAT(named, HasSubstr(part));
  }
  EXPECT_EQ(count(named, "<a href"), 1);  // to the task itself
  const std::string linked =
      to_html(results, PageSize::full, [](const std::string& file) { return "../" + file; });
  EXPECT_THAT(linked, HasSubstr("<a href=\"../student/1_rays/README.md#13-hit_triangle\">"
                                "1.3 hit_triangle</a>"));
  EXPECT_THAT(linked, HasSubstr("<a href=\"../pt/tasks/hit_triangle.h\">hit_triangle.h</a>"));
}

// 18 of 39 points are 46 %. Part 3 has 6 of 17 points.
TEST_F(Page, has_the_points_of_all_and_of_each_part) {
  const std::string text = to_html(run);
  EXPECT_THAT(text, HasSubstr("<span style=\"width:46%\">"));
  EXPECT_THAT(text, HasSubstr("Part 3 <span>direct</span> <span class=\"points\">6/17</span>"));
}

TEST_F(Page, a_bonus_that_is_not_earned_is_no_fault) {
  results::Results results = run;
  const std::string words = "</span>returns the interpolated normal";
  EXPECT_THAT(to_html(results), HasSubstr("not kept: " + words));
  for (results::TaskResult& task : results.tasks) {
    for (results::PromiseResult& promise : task.promises) promise.bonus = true;
  }
  EXPECT_THAT(to_html(results), HasSubstr("not kept yet: " + words));
  EXPECT_THAT(to_html(results), Not(HasSubstr("not kept: " + words)));
}

TEST_F(Page, says_how_a_picture_was_made) {
  results::Results results = run;
  results.tasks[6].pictures[1].noise = 0.5;
  const std::string text = to_html(results);
  EXPECT_THAT(text, HasSubstr("; 64 samples per pixel in 1 round; 1.02 times the variance of the "
                              "reference; 0.8 s."));
  EXPECT_THAT(text, HasSubstr("; 448 samples per pixel in 3 rounds; 0.50 times the variance of the "
                              "reference; 0.8 s."));
}

// A cell's button leads to its middle. Errors above ten times the radiance are not numbers.
TEST_F(Page, lists_the_cells_that_fail) {
  results::Results results = run;
  std::vector<results::FailingCell>& cells = results.tasks[6].pictures[1].cells;
  cells = {{48, 24, 8, 4, "Y", 12, 2.4}, {56, 24, 4, 4, "R", 9.5, 1.3}};
  const std::string text = to_html(results);
  EXPECT_THAT(text, HasSubstr("data-x=\"52\" data-y=\"26\">x 48, y 24, 8 &times; 4</button>"));
  EXPECT_THAT(text, HasSubstr(">&gt; +1000 %</td><td class=\"number\">2.4</td>"));
  EXPECT_THAT(text, HasSubstr(">+950.0 %</td><td class=\"number\">1.3</td>"));
}

TEST_F(Page, fetches_nothing) {
  const std::string text = to_html(run);
  EXPECT_THAT(text, HasSubstr("default-src 'none'; img-src data:;"));
  EXPECT_EQ(count(text, "src=\""), count(text, "src=\"data:image/png;base64,iVBORw0KGgo"));
  for (const char* part : {"http:", "https:", "url(", "@import", "fetch("}) {
    EXPECT_THAT(text, Not(HasSubstr(part)));
  }
}

TEST_F(Page, texts_stay_texts) {
  results::Results results = run;
  results.isolation = results.versions[0] = kHostile;
  results.phases[0].name = kHostile;
  for (results::TaskResult& task : results.tasks) {
    task.reason = task.compiler_output = task.warnings = task.printed = kHostile;
    task.slug = task.part = task.number = kHostile;
    task.blamed = task.blocked_by = {kHostile};
    for (results::PromiseResult& promise : task.promises) {
      promise.words = promise.name = kHostile;
      for (results::Failure& failure : promise.failures) {
        failure.input = {kHostile};
        failure.what = failure.got = failure.expected = failure.off_by = kHostile;
        failure.replay = kHostile;
      }
    }
    for (results::PictureResult& picture : task.pictures) {
      picture.recipe = picture.title = picture.text = picture.replay = kHostile;
      picture.evidence += kHostile;
      for (results::FailingCell& cell : picture.cells) cell.channel = kHostile;
    }
  }
  const std::string text = to_html(results);
  EXPECT_EQ(count(text, "<script"), 1);
  EXPECT_EQ(count(text, "</script"), 1);
  EXPECT_EQ(count(text, "</style"), 1);
  EXPECT_EQ(count(text, "<img src=x"), 0);
  EXPECT_EQ(count(text, "onerror='"), 0);
  EXPECT_EQ(count(text, "\x1b"), 0);
  EXPECT_EQ(count(text, "\xff"), 0);
  EXPECT_GT(count(text, "{{verdict}}"), 100);
  EXPECT_GT(count(text, "&lt;script&gt;window.harmed"), 100);
}

TEST_F(Page, shows_the_pictures_that_there_are) {
  const std::string text = to_html(run);
  EXPECT_EQ(count(text, "data-kind=\"film\""), 4);  // three of direct_lights, one adaptive
  EXPECT_EQ(count(text, "data-kind=\"counts\""), 1);
  EXPECT_EQ(count(text, "<rect class=\"over\""), 2);
  EXPECT_THAT(text, HasSubstr("It cannot be shown. cannot read &apos;" + folder.path() +
                              "/lost.exr&apos;: there is no such file"));
  results::Results results = run;
  for (results::PictureResult& picture : results.tasks[6].pictures) picture.golden += "x";
  results.tasks[8].pictures.resize(1);
  EXPECT_EQ(count(to_html(results), "data-kind=\"film\""), 1);
}

TEST_F(Page, that_is_small_has_all_pictures_and_no_numbers) {
  const std::string full = to_html(run), small = to_html(run, PageSize::small);
  for (const char* shown : {"data-kind=\"film\"", "data-kind=\"counts\"", "<rect class=\"over\"",
                            "class=\"layer render\"", "class=\"layer golden\""}) {
    EXPECT_GT(count(small, shown), 0) << shown;
    EXPECT_EQ(count(small, shown), count(full, shown)) << shown;
  }
  EXPECT_EQ(count(full, "data-render=\"\""), 0);
  EXPECT_EQ(count(small, "data-render=\"\""), count(full, "data-render="));
  EXPECT_EQ(count(small, "Point at a picture"), 0);
  EXPECT_LT(small.size(), full.size());
  // Maps show where a picture is wrong.
  results::Results right = run;
  for (results::TaskResult& task : right.tasks) {
    for (results::PictureResult& picture : task.pictures) picture.state = results::State::pass;
  }
  EXPECT_EQ(count(to_html(right, PageSize::small), "class=\"map\""), 0);
  EXPECT_GT(count(small, "class=\"map\""), 0);
  EXPECT_GT(count(to_html(right), "class=\"map\""), 0);
}

TEST_F(Page, a_picture_of_two_tasks_is_in_it_once) {
  const std::string text = to_html(run);
  EXPECT_EQ(count(text, "id=\"direct_lights.two_lights\""), 1);
  EXPECT_EQ(count(text, "id=\"adaptive_pixel.two_lights\""), 1);
  EXPECT_EQ(count(text, "data-place=\"direct_lights.two_lights\""), 1);
  EXPECT_EQ(count(text, "alt=\"The submission&apos;s render of two_lights\""), 1);
  // A result that differs in any shown value is another picture.
  results::Results results = run;
  results::PictureResult& other = results.tasks[8].pictures[1];
  other.cells = {{8, 8, 8, 8, "Y", 0.1, 1.2}};
  EXPECT_EQ(count(to_html(results), "data-kind=\"film\""), 5);
  other = run.tasks[6].pictures[0];
  other.render = run.tasks[6].pictures[1].render;
  EXPECT_EQ(count(to_html(results), "data-kind=\"film\""), 5);
}

TEST_F(Page, pictures_of_two_sizes_are_not_compared) {
  pt::write_exr(run.tasks[6].pictures[1].render, pt::Film(95, 71));
  EXPECT_THAT(to_html(run), HasSubstr("The render has 95 x 71 pixels, the golden 96 x 72."));
}

TEST_F(Page, a_picture_that_is_not_finite_is_shown) {
  pt::Film film = pt::read_exr(run.tasks[6].pictures[1].render);
  const double nan = std::nan("");
  film.set(3, 3, {{nan, nan, nan}, {nan, nan, nan}, nan, 64});
  film.set(4, 3, {{-1, 1e30, std::numeric_limits<double>::infinity()}, {}, 1e30, 64});
  pt::write_exr(run.tasks[6].pictures[1].render, film);
  EXPECT_EQ(count(to_html(run), "data-kind=\"film\""), 4);
}

TEST_F(Page, an_unfinished_run_says_so) {
  results::Results results = run;
  results.complete = false;
  EXPECT_THAT(to_html(results), HasSubstr(results::kStopped));
  EXPECT_THAT(to_html({}), HasSubstr("0 of 0 tasks pass"));
}

TEST_F(Page, what_is_not_judged_is_named_so) {
  const std::string text = to_html(half_judged());
  EXPECT_THAT(text, HasSubstr("<h1>1 of 9 tasks pass, 3 not judged yet</h1>"));
  EXPECT_THAT(text, HasSubstr("title=\"penumbra: not judged\""));
  EXPECT_THAT(text, HasSubstr("title=\"two_lights: pass\""));
  EXPECT_EQ(count(text, "<p class=\"promise quiet"), 4);  // two promises of two tasks
  EXPECT_EQ(count(text, "data-kind="), 1);
}

TEST_F(Page, twenty_five_pictures_stay_below_eight_megabytes) {
  results::Results results = run;
  std::vector<results::PictureResult>& pictures = results.tasks[6].pictures;
  pictures.assign(25, pictures[1]);
  for (std::size_t i = 0; i < 25; ++i) pictures[i].cells[0].evidence += static_cast<double>(i);
  const std::string text = to_html(results);
  EXPECT_EQ(count(text, "data-kind=\"film\""), 27);  // two of adaptive_pixel
  EXPECT_LT(text.size(), 8U << 20);
}

}  // namespace
}  // namespace grader::report
