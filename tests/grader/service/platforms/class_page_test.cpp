// The page of a class: its counts and their order.
#include "grader/service/platforms/class_page.h"

#include <regex>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace grader::platforms {
namespace {

using results::State;
using testing::HasSubstr;
using testing::Not;

results::Results run_with(State state, bool first, bool second, int points) {
  results::Results run;
  results::TaskResult task;
  task.slug = "hit_box";
  task.state = state;
  task.points = points;
  task.max_points = 20;
  task.promises.push_back({"first", "the first: promise", false, first, 1, 0, {}});
  task.promises.push_back({"second", "the second: promise", false, second, 1, 0, {}});
  run.tasks.push_back(task);
  run.complete = true;
  run.seconds = 2 * points;
  return run;
}

// Returns the place of the text in the page; fails if it is missing.
std::size_t place(const std::string& page, const std::string& text) {
  EXPECT_THAT(page, HasSubstr(text));
  return page.find(text);
}

TEST(ClassPage, counts_who_kept_a_promise_and_puts_the_hardest_first) {
  ClassPage page;
  page.add({"a", "", "a.html", "", false}, run_with(State::fail, true, false, 10));
  page.add({"b", "", "b.html", "", false}, run_with(State::fail, false, false, 0));
  page.add({"c", "", "c.html", "", false}, run_with(State::pass, true, true, 20));
  page.add({"d", "", "d.html", "", false}, run_with(State::not_attempted, false, false, 0));
  page.add({"e", "", "e.html", "it is a link", false}, run_with(State::fail, false, false, 0));
  const std::string html = page.to_html();
  const std::size_t second =
      place(html, ">1 of 3</td><td><code>hit_box</code></td><td>the second: promise");
  EXPECT_LT(second, place(html, ">2 of 3</td><td><code>hit_box</code></td><td>the first: promise"));
  EXPECT_THAT(html, HasSubstr("5 submissions"));
  EXPECT_THAT(html, HasSubstr("<strong>1</strong> could not be judged"));
  EXPECT_THAT(html, HasSubstr("<strong>10</strong> of 20 points or more"));
  EXPECT_THAT(html, HasSubstr("Judging one took 15 seconds on average."));  // without e
}

TEST(ClassPage, lists_every_promise_with_those_who_read_of_it_first) {
  ClassPage page;
  page.add({"a", "", "a.html", "", false}, run_with(State::fail, false, false, 0));
  page.add({"b", "", "b.html", "", false}, run_with(State::fail, false, true, 10));
  page.add({"c", "", "c.html", "", false}, run_with(State::fail, true, false, 10));
  const std::string html = page.to_html();
  const std::string all = html.substr(place(html, "All 2, task by task"));
  EXPECT_THAT(all, HasSubstr("Read first by"));
  EXPECT_THAT(all, HasSubstr(">1 of 3</td><td class=\"number\">2</td><td><code>hit_box</code></td>"
                             "<td>the first: promise"));
  EXPECT_THAT(all, HasSubstr(">1 of 3</td><td class=\"number\">1</td><td><code>hit_box</code></td>"
                             "<td>the second: promise"));
}

TEST(ClassPage, counts_whose_examples_catch_what_breaks_a_promise) {
  ClassPage page;
  EXPECT_THAT(page.to_html(), Not(HasSubstr("Examples")));
  for (const bool caught : {true, false, false}) {
    // Examples are written before the task.
    results::Results run = run_with(State::not_attempted, false, false, 0);
    run.tasks[0].promises.push_back(
        {"examples:first", "examples catch it", true, caught, 0, 0, {}});
    page.add({"a", "", "a.html", "", false}, run);
  }
  page.add({"d", "", "d.html", "", false}, run_with(State::not_attempted, false, false, 0));
  const std::string html = page.to_html();
  EXPECT_THAT(html, HasSubstr("Mistakes that examples do not catch"));
  EXPECT_THAT(html, HasSubstr(">1 of 3</td><td><code>hit_box</code></td><td>examples catch it"));
}

// Each number of points from 0 on occurs once, 137 in all.
TEST(ClassPage, every_number_of_points_is_in_one_bin) {
  ClassPage page;
  for (int points = 0; points <= 136; ++points) {
    results::Results run = run_with(State::fail, true, true, points);
    run.tasks[0].max_points = 136;
    page.add({std::to_string(points), "", "x.html", "", false}, run);
  }
  const std::string html = page.to_html();
  const std::regex bin(R"(<strong>(\d+)</strong><br>(\d+) to (\d+)</span>)");
  int next = 0, bins = 0;
  for (std::sregex_iterator at(html.begin(), html.end(), bin), end; at != end; ++at, ++bins) {
    const int count = std::stoi((*at)[1]), from = std::stoi((*at)[2]), to = std::stoi((*at)[3]);
    EXPECT_EQ(from, next);
    EXPECT_EQ(count, to - from + 1);
    next = to + 1;
  }
  EXPECT_EQ(bins, 10);
  EXPECT_EQ(next, 137);
}

TEST(ClassPage, leaves_out_what_everybody_has_right) {
  ClassPage page;
  page.add({"a", "", "a.html", "", false}, run_with(State::pass, true, true, 20));
  EXPECT_THAT(page.to_html(), Not(HasSubstr("the first: promise")));
}

TEST(ClassPage, names_mistakes_by_how_many_made_them) {
  ClassPage page;
  for (int i = 0; i < 5; ++i) {
    results::Results run = run_with(State::fail, false, false, 0);
    run.tasks[0].mistake = {"m", i < 2 ? "A rare one." : "A common one.", "battery"};
    page.add({std::to_string(i), "", "x.html", "", false}, run);
  }
  const std::string html = page.to_html();
  EXPECT_LT(place(html, ">3</td><td><code>hit_box</code></td><td>A common one."),
            place(html, ">2</td><td><code>hit_box</code></td><td>A rare one."));
}

TEST(ClassPage, rows_are_in_alphabetical_order_with_ids_and_links) {
  ClassPage page;
  page.add({"zo\xc3\xab & co", "17", "zo\xc3\xab & co.html", "", true},
           run_with(State::pass, true, true, 20));
  page.add({"ada", "4", "ada.html", "it holds two archives", false}, {});
  const std::string html = page.to_html();
  EXPECT_LT(place(html, "it holds two archives"), place(html, "href=\"zo%C3%AB%20%26%20co.html\""));
  EXPECT_THAT(
      html, HasSubstr(">zo\xc3\xab &amp; co</a> <span class=\"note\">late</span></td><td>17</td>"));
  EXPECT_THAT(html, Not(HasSubstr("href=\"ada.html\"")));
}

// The report of a stopped run may have fewer tasks than other reports.
TEST(ClassPage, has_a_column_for_each_task_of_the_longest_report) {
  ClassPage page;
  const results::Results one = run_with(State::pass, true, true, 20);
  results::Results two = one;
  two.tasks.push_back(one.tasks[0]);
  two.tasks[1].slug = "hit_bvh";
  page.add({"a", "", "a.html", "", false}, one);
  page.add({"b", "", "b.html", "", false}, two);
  page.add({"c", "", "c.html", "", false}, one);
  const std::string html = page.to_html();
  EXPECT_LT(place(html, ">hit_box</button></th>"), place(html, ">hit_bvh</button></th>"));
  EXPECT_THAT(html, HasSubstr("title=\"hit_bvh: not asked\""));
  EXPECT_THAT(html, HasSubstr("title=\"hit_bvh: pass\""));
}

TEST(ClassPage, is_there_for_nobody_judged_too) {
  ClassPage page;
  page.add({"ada", "", "ada.html", "it is a link", false}, {});
  EXPECT_THAT(page.to_html(), HasSubstr("<strong>-</strong> of 0 points"));
}

}  // namespace
}  // namespace grader::platforms
