#include "grader/service/platforms/class_page.h"

#include "grader/report/filled.h"
#include "grader/report/html_picture.h"
#include "grader/report/page/sources.h"
#include "grader/results/order.h"
#include "grader/results/points.h"
#include "grader/results/presentable.h"
#include "grader/service/platforms/page/sources.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

namespace grader::platforms {

namespace {

using kainjow::mustache::data;

constexpr std::size_t kHardest = 15;  // rows that are listed
constexpr int kBins = 10;             // of the distribution of points

int percent_of(int part, int whole) { return whole > 0 ? (100 * part + whole / 2) / whole : 0; }

data bar(const std::string& key, int part, int whole) {
  data out;
  out.set(key, std::to_string(part));
  out.set("share", std::to_string(percent_of(part, whole)));
  return out;
}

data count_data(const std::string& slug, const ClassPage::Count& count) {
  data out = bar("right", count.right, count.judged);
  out.set("slug", slug);
  out.set("title", count.title);
  out.set("judged", std::to_string(count.judged));
  out.set("first", count.first > 0 ? data(std::to_string(count.first)) : data(false));
  return out;
}

// Sorted by the share of submissions that have it right; left out if all have it right.
data hardest_of(const ClassPage::Counts& counts) {
  std::vector<std::pair<ClassPage::Key, ClassPage::Count>> hard;
  for (const auto& each : counts) {
    if (each.second.right < each.second.judged) hard.push_back(each);
  }
  std::stable_sort(hard.begin(), hard.end(), [](const auto& a, const auto& b) {
    return a.second.right * b.second.judged < b.second.right * a.second.judged;
  });
  if (hard.size() > kHardest) hard.resize(kHardest);
  data list{data::type::list};
  for (const auto& [key, count] : hard) list.push_back(count_data(key.first, count));
  return list;
}

// All promises and pictures, in the order of the course.
data all_of(const ClassPage::Counts& counts, const std::vector<std::string>& tasks) {
  data list{data::type::list};
  for (const std::string& slug : tasks) {
    for (const auto& [key, count] : counts) {
      if (key.first == slug) list.push_back(count_data(slug, count));
    }
  }
  return list;
}

// A table of the hardest and one of all, with headings; empty if everybody has all right.
void add_counts(data& tables, const ClassPage::Counts& counts,
                const std::vector<std::string>& tasks, data table) {
  const data hardest = hardest_of(counts);
  if (hardest.is_empty_list()) return;
  table.set("hardest", hardest);
  table.set("all", all_of(counts, tasks));
  table.set("number", std::to_string(counts.size()));
  tables.push_back(table);
}

data most_common(const std::map<ClassPage::Key, int>& mistakes) {
  std::vector<std::pair<ClassPage::Key, int>> common(mistakes.begin(), mistakes.end());
  std::stable_sort(common.begin(), common.end(),
                   [](const auto& a, const auto& b) { return a.second > b.second; });
  if (common.size() > kHardest) common.resize(kHardest);
  data list{data::type::list};
  for (const auto& [key, count] : common) {
    data mistake;
    mistake.set("count", std::to_string(count));
    mistake.set("slug", key.first);
    mistake.set("sentence", key.second);
    list.push_back(mistake);
  }
  return list;
}

// The points of bin i: from i to i + 1 tenths of the maximum, which is in the last bin.
std::string range_of_bin(int i, int most) {
  const auto first = [&](int bin) { return (most * bin + kBins - 1) / kBins; };
  const int from = first(i), to = i + 1 == kBins ? most : first(i + 1) - 1;
  if (from > to) return "";
  return from == to ? std::to_string(to) : fmt::format("{} to {}", from, to);
}

data distribution(const std::vector<int>& points, int most) {
  std::array<int, kBins> bins{};
  for (const int each : points) ++bins[most > 0 ? std::min(kBins - 1, each * kBins / most) : 0];
  const int tallest = *std::max_element(bins.begin(), bins.end());
  data list{data::type::list};
  for (int i = 0; i < kBins; ++i) {
    data bin = bar("count", bins[i], tallest);
    bin.set("range", range_of_bin(i, most));
    list.push_back(bin);
  }
  return list;
}

// The numbers of submissions and problems, their time, and the distribution of points.
void set_sums(data& out, const std::vector<ClassPage::Entry>& lines) {
  int most = 0;
  double seconds = 0;
  std::vector<int> points;
  for (const ClassPage::Entry& line : lines) {
    if (!line.row.problem.empty()) continue;
    most = std::max(most, line.sums.max_points);
    seconds += line.seconds;
    points.push_back(line.sums.points);
  }
  std::sort(points.begin(), points.end());
  const auto absent =
      std::ranges::count_if(lines, [](const auto& line) { return line.row.absent; });
  const std::size_t handed_in = lines.size() - static_cast<std::size_t>(absent);
  const std::size_t problems = handed_in - points.size();
  out.set("submissions", std::to_string(handed_in));
  out.set("absent", absent > 0 ? data(std::to_string(absent)) : data(false));
  out.set("problems", problems > 0 ? data(std::to_string(problems)) : data(false));
  out.set("max_points", std::to_string(most));
  out.set("median", points.empty() ? "-" : std::to_string(points[points.size() / 2]));
  // The mean, not the sum: submissions run side by side, and equal ones are graded once.
  const double each = points.empty() ? 0 : seconds / static_cast<double>(points.size());
  out.set("seconds", fmt::format("{:.0f}", each));
  out.set("distribution", distribution(points, most));
}

data cell_data(const ClassPage::Entry& line, const std::string& slug) {
  const auto found = line.tasks.find(slug);
  const bool asked = found != line.tasks.end();
  data cell;
  cell.set("slug", slug);
  cell.set("tone", asked ? report::tone(found->second) : "quiet");
  cell.set("symbol", asked ? results::symbol(found->second) : "");
  cell.set("words", asked ? results::words(found->second) : "not asked");
  return cell;
}

data row_data(const ClassPage::Entry& line, const std::vector<std::string>& tasks) {
  const bool judged = line.row.problem.empty();
  const results::Totals& sums = line.sums;
  data row, cells{data::type::list};
  for (const std::string& slug : tasks) cells.push_back(cell_data(line, slug));
  row.set("cells", cells);
  row.set("name", results::one_line(line.row.name));
  row.set("id", results::one_line(line.row.id));
  row.set("late", line.row.late);
  row.set("files", line.row.note.empty() ? data(false) : data(results::one_line(line.row.note)));
  row.set("judged", judged);
  row.set("grade", line.row.grade.empty() ? data(false) : data(results::one_line(line.row.grade)));
  row.set("absent", line.row.absent);
  row.set("all_tasks", std::to_string(tasks.size()));
  row.set("problem",
          judged || line.row.absent ? data(false) : data(results::one_line(line.row.problem)));
  row.set("columns", std::to_string(tasks.size() + 2));
  row.set("address", report::address_of(line.row.page));
  row.set("points", std::to_string(sums.points));
  row.set("bonus", sums.bonus_points > 0 ? data(std::to_string(sums.bonus_points)) : data(false));
  row.set("passed", std::to_string(sums.passed));
  return row;
}

}  // namespace

void ClassPage::add(const ClassRow& row, const results::Results& exact) {
  Entry line{row, {}, {}, 0};
  if (row.problem.empty()) {
    const results::Results results = results::presentable(exact);
    line.sums = results::totals(results.tasks);
    line.seconds = results.seconds;
    if (tasks_.size() < results.tasks.size()) tasks_.clear();
    const bool first = tasks_.empty();
    for (const results::TaskResult& task : results.tasks) {
      if (first) tasks_.push_back(task.slug);
      line.tasks[task.slug] = task.state;
      count(task);
    }
  }
  lines_.push_back(std::move(line));
}

void ClassPage::count(const results::TaskResult& task) {
  const auto enter = [](Count& count, const std::string& title, bool right) {
    count.title = title;
    ++count.judged;
    count.right += right ? 1 : 0;
  };
  for (const results::PromiseResult& promise : task.promises) {
    if (promise.name.starts_with(results::kExamples))
      enter(examples_[{task.slug, promise.name}], promise.words, promise.held);
  }
  // A learner who has not begun does not count: nothing was hard yet.
  if (task.state == results::State::not_attempted) return;
  if (!task.mistake.empty()) ++mistakes_[{task.slug, task.mistake.sentence}];
  for (const results::PromiseResult& promise : task.promises) {
    if (promise.bonus || !results::is_judged(task, promise)) continue;
    enter(promises_[{task.slug, promise.name}],
          promise.words.empty() ? promise.name : promise.words, promise.held);
  }
  const auto broken = results::by_importance(task);
  if (!broken.empty() && !broken[0]->bonus) ++promises_[{task.slug, broken[0]->name}].first;
  for (const results::PictureResult& picture : task.pictures) {
    const bool right = picture.state == results::State::pass;
    if (!right && !results::is_fault(picture.state)) continue;
    enter(pictures_[{task.slug, picture.recipe}], picture.title, right);
  }
}

std::string ClassPage::to_html() const {
  std::vector<Entry> lines = lines_;
  std::sort(lines.begin(), lines.end(),
            [](const Entry& a, const Entry& b) { return a.row.name < b.row.name; });
  data promises, pictures, examples;
  promises.set("anchor", "promises");
  promises.set("heading", "Promises that are hard to keep");
  promises.set("note", "of those who have begun the task");
  promises.set("right_head", "Kept by");
  promises.set("title_head", "Promise");
  promises.set("first_head", "Read first by");
  pictures.set("anchor", "pictures");
  pictures.set("heading", "Pictures that come out wrong");
  pictures.set("note", false);
  pictures.set("right_head", "Right for");
  pictures.set("title_head", "Picture");
  pictures.set("first_head", false);
  examples.set("anchor", "examples");
  examples.set("heading", "Mistakes that examples do not catch");
  examples.set("note", "of those who have handed in examples of the task");
  examples.set("right_head", "Caught by");
  examples.set("title_head", "Examples");
  examples.set("first_head", false);
  data counts{data::type::list};
  add_counts(counts, promises_, tasks_, promises);
  add_counts(counts, pictures_, tasks_, pictures);
  add_counts(counts, examples_, tasks_, examples);
  data out, tasks{data::type::list}, rows{data::type::list};
  for (const std::string& slug : tasks_) tasks.push_back(data{"slug", slug});
  for (const Entry& line : lines) rows.push_back(row_data(line, tasks_));
  out.set("style", std::string(report::page_css));
  out.set("script", std::string(class_js));
  set_sums(out, lines);
  out.set("counts", counts);
  out.set("mistakes", most_common(mistakes_));
  out.set("has_mistakes", !mistakes_.empty());
  out.set("tasks", tasks);
  out.set("rows", rows);
  return report::filled(class_html, out);
}

}  // namespace grader::platforms
