// The numbers of ./run measure: intervals, the front, and the report on wrong answers; and its charts.
#include "grader/tasks.h"
#include "measure/calls/print.h"
#include "measure/calls/results.h"
#include "measure/charts/gnuplot.h"
#include "measure/charts/labels.h"
#include "pt/error.h"
#include "pt/file.h"
#include "pt/sampling/sampler.h"
#include "tests/fixtures/temporary_folder.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

namespace measure::calls {
namespace {

namespace fs = std::filesystem;

TEST(measure, knows_every_task_of_the_table) {
  ASSERT_EQ(tasks().size(), grader::tasks().size());
  for (std::size_t i = 0; i < tasks().size(); ++i) {
    EXPECT_EQ(tasks()[i].slug, grader::tasks()[i].slug);
    EXPECT_FALSE(tasks()[i].cases.empty()) << tasks()[i].slug;
    EXPECT_TRUE(tasks()[i].inputs.ends_with('.')) << tasks()[i].slug;
    EXPECT_EQ(tasks()[i].errors.empty(),
              tasks()[i].kind != Kind::exact && tasks()[i].slug != "diffuse_bsdf");
  }
}

const About& about_of(const std::string& slug) {
  for (const About& about : tasks()) {
    if (about.slug == slug) return about;
  }
  throw std::runtime_error(slug);
}

Row row(const std::string& name, double nanoseconds, double error) {
  Row row;
  row.name = name;
  row.nanoseconds = {nanoseconds, nanoseconds, nanoseconds};
  row.found.errors[0] = error;
  return row;
}

// A crash of somebody's own code, or a wrong answer, is told by the exit status; those of others are not.
TEST(measure, own_code_fails_if_it_has_no_numbers_or_is_wrong) {
  const About& about = about_of("hit_sphere");
  Row good = row("mine", 10, 1e-12), crashed = row("mine", 10, 1e-12), other = crashed;
  good.is_own = crashed.is_own = true;
  crashed.problem = other.problem = "signal 11";
  Row wrong = good;
  wrong.found.wrong = .5;
  EXPECT_FALSE(own_code_fails({&about, {{"", {good, other}}}}));
  EXPECT_TRUE(own_code_fails({&about, {{"", {good}}, {"", {crashed}}}}));
  EXPECT_TRUE(own_code_fails({&about, {{"", {wrong}}}}));
}

TEST(measure, median_and_mean_of_known_numbers) {
  EXPECT_EQ(median_of({3, 1, 2}).value, 2);
  EXPECT_EQ(median_of({4, 1, 2, 3}).value, 2.5);
  EXPECT_EQ(median_of({5, 1, 3}).low, 1);
  EXPECT_EQ(median_of({5, 1, 3}).high, 5);
  // The mean of 1, 2, 3 is 2, its standard error 1 / sqrt(3).
  EXPECT_NEAR(mean_of({1, 2, 3}).high, 2 + 1.96 / std::sqrt(3), 1e-12);
}

// The rate at which the interval contains the true median, in 3000 runs: 95 % within five standard
// deviations of 0.4 %. The interval may be a little too wide, because it ends at measured values.
TEST(measure, intervals_hold_the_median_as_often_as_they_say) {
  pt::Sampler sampler(1);
  for (const int n : {15, 40, 301}) {
    int holds = 0;
    constexpr int kRuns = 3000;
    for (int run = 0; run < kRuns; ++run) {
      std::vector<double> values;
      values.reserve(static_cast<std::size_t>(n));
      for (int i = 0; i < n; ++i) values.push_back(-std::log(1 - sampler.next_1d()));
      const Ranged median = median_of(values);
      if (median.low <= std::log(2) && std::log(2) <= median.high) ++holds;
    }
    EXPECT_GT(holds, 0.925 * kRuns) << n;
    EXPECT_LT(holds, 0.985 * kRuns) << n;
  }
}

TEST(measure, the_front_is_what_nobody_beats_in_both) {
  const About& about = about_of("hit_sphere");
  Row wrong = row("wrong", 1, 0), broken = row("broken", 0, 0);
  wrong.found.wrong = 0.1;
  broken.problem = "it crashes";
  const std::vector<Table> tables{
      {"",
       {row("reference", 10, 1e-12), row("faster", 5, 1e-9), row("slower", 20, 1e-12),
        row("worse", 10, 1e-11), row("best", 12, 1e-13), wrong, broken}}};
  const std::vector<bool> front{true, true, false, false, true, false, false};
  EXPECT_EQ(pareto_fronts(about, tables)[0], front);
}

// 5.1 does not differ from 5.0 +- .2. All leaf sizes share a front; other inputs have their own.
TEST(measure, fronts_keep_what_is_not_clearly_worse) {
  Row even = row("even", 5.1, 1e-9);
  const Row reference = row("reference", 5.0, 1.3e-9);
  even.nanoseconds = {5.1, 4.9, 5.3};
  EXPECT_EQ(pareto_fronts(about_of("hit_sphere"), {{"", {reference, even}}})[0],
            (std::vector<bool>{true, true}));
  Row fast = row("reference", 1, 0), slow = row("reference", 2, 0);
  for (Row* each : {&fast, &slow}) each->found.boxes = 10;
  const std::vector<Table> tables{{"a", {fast}}, {"b", {slow}}};
  EXPECT_FALSE(pareto_fronts(about_of("build_bvh"), tables)[1][0]);
  EXPECT_TRUE(pareto_fronts(about_of("hit_bvh"), tables)[1][0]);
}

TEST(measure, a_wrong_mean_is_named) {
  const About& about = about_of("direct_lights");
  Row each = row("own", 1, 0);
  each.mean = {1.001, 0.999, 1.003};
  EXPECT_EQ(mistake(about, each), "");
  each.mean = {0.5, 0.498, 0.502};
  EXPECT_EQ(mistake(about, each), "its mean is 0.5 of the right one");
  each.mean = {std::nan(""), 0, 0};
  EXPECT_NE(mistake(about, each), "");
}

TEST(measure, wrong_answers_are_told_in_percent) {
  Row each = row("own", 1, 0);
  each.found.wrong = 0.25;
  EXPECT_EQ(mistake(about_of("hit_sphere"), each), "wrong for 25 % of the inputs");
}

TEST(measure, units_are_what_their_names_say) {
  const auto in_nanoseconds = [](const std::string& name) {
    return name == "ns" ? 1 : name == "us" ? 1e3 : name == "ms" ? 1e6 : 0;
  };
  for (int power = 0; power < 18; ++power) {
    const double time = std::pow(3, power);
    const Unit unit = unit_of(time);
    EXPECT_EQ(unit.nanoseconds, in_nanoseconds(unit.name)) << unit.name;
    EXPECT_GE(time / unit.nanoseconds, 1) << unit.name;
  }
}

// 20 microseconds, from 19.8 to 20.2.
TEST(measure, the_terminal_has_the_time_and_half_its_interval) {
  Row reference = row("reference", 20000, 1e-12);
  reference.nanoseconds = {20000, 19800, 20200};
  reference.ratio = {1, 1, 1};
  const std::string text = to_text(Results{&about_of("hit_sphere"), {{"", {reference}}}});
  EXPECT_NE(text.find("us per call"), std::string::npos) << text;
  EXPECT_NE(text.find(" 20.0 \u00b1 0.2 "), std::string::npos) << text;
}

// Half the time and a quarter of the variance: an eighth.
TEST(measure, work_is_time_times_variance) {
  Row reference = row("reference", 10, 0), own = row("own", 5, 0);
  reference.variance = {4, 3.9, 4.1};
  own.variance = {1, 0.9, 1.1};
  own.ratio = {0.5, 0.49, 0.51};
  const Ranged result = work(own, reference);
  EXPECT_NEAR(result.value, 0.125, 1e-12);
  // Errors of 2 %, 2.5 % and 10 %.
  EXPECT_NEAR(result.high / result.value, std::exp(std::sqrt(.02 * .02 + .025 * .025 + .1 * .1)),
              1e-3);
}

// Each line has as many columns as the header.
TEST(measure, csv_has_all_columns) {
  Row broken = row("\"broken\"", 0, 0);
  broken.problem = "it threw \"x\"";
  std::vector<Results> all;
  for (const About& about : tasks()) {
    Row good = row("reference", 3, 1e-9);
    good.variance = {1, .9, 1.1};
    all.push_back({&about, {{"", {good, broken}}}});
  }
  const std::string csv = to_csv(all);
  std::size_t lines = 0, columns = 0;
  for (std::size_t at = 0; at < csv.size(); ++lines) {
    const std::size_t end = csv.find('\n', at);
    const std::string line = csv.substr(at, end - at);
    const auto commas = static_cast<std::size_t>(std::count(line.begin(), line.end(), ','));
    if (lines == 0) columns = commas;
    EXPECT_EQ(commas, columns) << line;
    at = end + 1;
  }
  EXPECT_EQ(lines, 1 + 2 * tasks().size());
  EXPECT_NE(csv.find("\"it threw \"\"x\"\"\""), std::string::npos);
}

TEST(charts, a_method_keeps_its_colour_unless_it_is_taken) {
  const std::string own = ink_of("half_b", {});
  EXPECT_EQ(ink_of("half_b", {ink::kBlack}), own);
  EXPECT_EQ(ink_of("half b", {}), own);
  EXPECT_NE(ink_of("half_b", {own}), own);
  std::vector<std::string> taken;
  for (int i = 0; i < 5; ++i) taken.push_back(ink_of("half_b", taken));
  std::ranges::sort(taken);
  EXPECT_EQ(std::unique(taken.begin(), taken.end()), taken.end());
  EXPECT_EQ(ink_of("half_b", taken), own);
}

TEST(labels, are_names_of_folders_and_tell_them_apart) {
  using Words = std::vector<std::string>;
  EXPECT_EQ(labels_of({"class/anna", "/home/ben/"}), (Words{"anna", "ben"}));
  EXPECT_EQ(labels_of({"anna/code", "ben/code", "c"}), (Words{"anna_code", "ben_code", "c"}));
  EXPECT_EQ(labels_of({"objects/hit_bvh.first_child_that_hits.o"}), Words{"first_child_that_hits"});
  EXPECT_EQ(labels_of({"x/anna", "x/anna"}), (Words{"anna", "anna_2"})) << "the same one twice";
  EXPECT_EQ(labels_of({"old/reference"}), Words{"old_reference"});
  EXPECT_EQ(labels_of({"x/`a b`\"$\\"}), Words{"_a_b____"}) << "signs that are commands elsewhere";
  const TemporaryFolder folder;
  pt::write_file(folder.path() + "/anna.tar.gz", "");
  EXPECT_EQ(labels_of({folder.path() + "/anna.tar.gz"}), Words{"anna"});
  EXPECT_THROW(labels_of({"a", "b", "c", "d", "e"}), pt::Error);
}

TEST(charts, have_their_caption_in_the_svg_and_for_latex) {
  const TemporaryFolder folder;
  draw(folder.path(), "a", "plot x\n", "50 % of a_b & <c>, ± 1 {x}");
  const fs::path svg = folder.path() + "/a.svg";
  if (!fs::exists(svg)) GTEST_SKIP() << "gnuplot is missing";
  EXPECT_NE(pt::read_file(svg).find("<desc>50 % of a_b &amp; &lt;c&gt;, ± 1 {x}</desc>"),
            std::string::npos);
  const std::string tex = pt::read_file(folder.path() + "/a.tex");
  EXPECT_NE(tex.find("\\includegraphics[width=0.99\\linewidth]{a.pdf}"), tex.npos) << tex;
  EXPECT_NE(tex.find("\\caption{50 \\% of a\\_b \\& $<$c$>$, $\\pm$ 1 \\{x\\}}"), tex.npos) << tex;
  draw(folder.path(), "b", "plot x\n");
  EXPECT_FALSE(fs::exists(folder.path() + "/b.tex")) << "no caption";
}

TEST(charts, a_point_shows_its_values_under_the_pointer) {
  const TemporaryFolder folder;
  pt::write_file(folder.path() + "/points.csv", "1,20,3\n");
  const std::string plot = "plot \"points.csv\" using 1:2 with points";
  draw(folder.path(), "points",
       plot + under_the_pointer({"\"points.csv\"", "50 % of \"<b>\"", "$1", "$2", "$2", "$3"}) +
           "\n");
  const std::string file = folder.path() + "/points.svg";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "gnuplot is missing";
  const std::string svg = pt::read_file(file);
  EXPECT_NE(svg.find("<title>50 % of '&lt;b>': 20 ± 3 at 1</title>"), std::string::npos) << svg;
  EXPECT_EQ(svg.find("<title>"), svg.rfind("<title>"));
  EXPECT_EQ(svg.find("onmouse"), std::string::npos);
}

TEST(charts, have_no_line_of_what_has_no_finite_error) {
  const TemporaryFolder folder;
  const std::string file = folder.path() + "/hit_sphere.svg";
  const auto draw_with = [&](double error) {
    const Table table{"",
                      {row("reference", 10, 1e-12), row("other", 5, error), row("kept", 20, 1e-9)}};
    draw_charts({&about_of("hit_sphere"), {table}}, folder.path());
  };
  draw_with(1e-6);
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "gnuplot is missing";
  EXPECT_NE(pt::read_file(file).find("other"), std::string::npos);
  std::filesystem::remove(file);
  draw_with(std::numeric_limits<double>::infinity());
  const std::string svg = pt::read_file(file);
  EXPECT_NE(svg.find("kept"), std::string::npos);
  EXPECT_EQ(svg.find("other"), std::string::npos);
}

}  // namespace
}  // namespace measure::calls
