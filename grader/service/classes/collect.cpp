#include "grader/service/classes/collect.h"

#include "grader/base/files.h"
#include "grader/report/csv.h"
#include "grader/results/presentable.h"
#include "grader/results/summary.h"
#include "grader/service/classes/compare.h"
#include "grader/service/classes/outcome_printer.h"
#include "grader/service/intake/unpack.h"
#include "grader/service/platforms/learner_page.h"
#include "grader/service/platforms/worksheet.h"
#include "pt/file.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <numeric>
#include <set>

#include <fmt/format.h>

namespace grader::classes {

namespace {

namespace fs = std::filesystem;

constexpr std::chrono::seconds kBetweenTables{2};
constexpr const char* kLikeness = "/likeness";

using platforms::Likeness;
using report::csv_field;

// The parts, such as "1_rays", in the order of the course.
std::vector<std::string> parts_of(const build::Config& config) {
  std::vector<std::string> parts;
  for (const build::TaskConfig& task : config.tasks) {
    if (parts.empty() || parts.back() != task.part) parts.push_back(task.part);
  }
  return parts;
}

std::string header(const build::Config& config) {
  std::string text = std::string(report::kByteOrderMark) +
                     "submission,id,late,tasks_passed,points,max_points,bonus_points";
  for (const std::string& part : parts_of(config)) text += fmt::format(",{}_points", part);
  for (const build::TaskConfig& task : config.tasks)
    text += fmt::format(",{0},{0}_points", task.slug);
  return text + ",problem,note,days_late,grade,grade_reason,version\r\n";
}

// The tasks whose part or slug is this name.
std::vector<results::TaskResult> tasks_of(const results::Results& results,
                                          const std::string results::TaskResult::*member,
                                          const std::string& name) {
  std::vector<results::TaskResult> tasks;
  for (const results::TaskResult& task : results.tasks) {
    if (task.*member == name) tasks.push_back(task);
  }
  return tasks;
}

// Returns the points with bonus points, or an empty text if there are no tasks.
std::string points_of(const std::vector<results::TaskResult>& tasks) {
  const results::Totals sums = results::totals(tasks);
  return tasks.empty() ? "" : std::to_string(sums.points + sums.bonus_points);
}

std::string line(const build::Config& config, const Graded& graded, bool anonymous,
                 const std::string& note, const Grade& grade) {
  const bool judged = graded.problem.empty();
  const results::Results& results = graded.results;
  const results::Totals sums = results::totals(results.tasks);
  std::string text =
      fmt::format("{},{},{}", csv_field(graded.by.name), anonymous ? "" : csv_field(graded.by.id),
                  graded.by.late ? "late" : "");
  text += judged ? fmt::format(",{},{},{},{}", sums.passed, sums.points, sums.max_points,
                               sums.bonus_points)
          : graded.by.absent ? ",0,0,,0"
                             : ",,,,";
  for (const std::string& part : parts_of(config)) {
    text += "," + points_of(tasks_of(results, &results::TaskResult::part, part));
  }
  for (const build::TaskConfig& task : config.tasks) {
    const auto found = tasks_of(results, &results::TaskResult::slug, task.slug);
    text += fmt::format(",{},{}", found.empty() ? "" : results::words(found[0].state),
                        points_of(found));
  }
  return text + fmt::format(",{},{},{},{},{},{}\r\n", csv_field(graded.problem), csv_field(note),
                            graded.by.days_late > 0 ? std::to_string(graded.by.days_late) : "",
                            grade.points ? std::to_string(*grade.points) : "",
                            csv_field(grade.reason), csv_field(results::version(results)));
}

// The task files that were judged, by slug.
std::map<std::string, std::string> files_of(const build::Config& config,
                                            const intake::HandedIn& by) {
  std::map<std::string, std::string> files;
  const std::string root = base::submission_root(by.folder);
  for (const build::TaskConfig& task : config.tasks) {
    const base::Submitted file = base::read_submitted(root, task.part, task.slug);
    if (file.present && file.rejected.empty()) files[task.slug] = file.text;
  }
  return files;
}

// The stubs, and the solutions that are in the repository.
std::map<std::string, Likeness::Known> known_files(const build::Config& config) {
  std::map<std::string, Likeness::Known> all;
  const auto text_of = [&](const std::string& path) {
    const std::string file = config.root + "/" + path;
    return fs::exists(file) ? pt::read_file(file) : "";
  };
  for (const build::TaskConfig& task : config.tasks) {
    const std::string file = task.part + "/" + task.slug + ".cpp";
    Likeness::Known& known = all[task.slug];
    known.stub = text_of("student/" + file);
    std::vector<std::string> paths{"reference/" + file, "fast/" + file};
    const std::string right = "grader/tasks/" + task.slug + "/right";
    if (fs::is_directory(config.root + "/" + right)) {
      for (const auto& entry : fs::directory_iterator(config.root + "/" + right))
        paths.push_back(right + "/" + entry.path().filename().string());
    }
    for (const std::string& path : paths) {
      if (const std::string text = text_of(path); !text.empty()) known.others[path] = text;
    }
  }
  return all;
}

// "handed_in" for handed_in.tar.gz. A folder's name may contain points.
std::string export_name(const std::string& input) {
  fs::path name = fs::path(input).filename();
  if (fs::is_directory(input)) return name;
  name = name.stem();
  return name.extension() == ".tar" ? name.stem() : name;
}

}  // namespace

Collector::Collector(const build::Config& config, const ClassPlan& plan, std::string out)
    : config_(config),
      plan_(plan),
      out_(std::move(out)),
      lines_(plan.everybody.size()),
      for_platforms_(plan.everybody.size()),
      likeness_(plan.likeness ? known_files(config) : std::map<std::string, Likeness::Known>()),
      overrides_(read_overrides(plan.rules.overrides, with_real_names(plan))) {
  fs::remove_all(out_ + kLikeness);  // of an earlier call
  fs::remove(out_ + kLikeness + ".html");
  for (const Chunk& chunk : plan.chunks) {
    for (const Equal& equal : chunk) {
      std::vector<std::string> names;
      for (const std::size_t i : equal) names.push_back(plan.everybody[i].name);
      if (equal.size() == 1) continue;
      for (const std::size_t i : equal) equals_[i] = "the same files: " + some_of(names);
    }
  }
}

// The note says which files were judged, and who handed in the same ones. Of stubs, which earn
// nothing, everybody has the same.
std::string Collector::note_on(std::size_t i, const Graded& graded) const {
  const auto equal = equals_.find(i);
  const bool has_points = results::totals(graded.results.tasks).points > 0;
  if (equal == equals_.end() || !has_points) return graded.by.note;
  return graded.by.note + (graded.by.note.empty() ? "" : "; ") + equal->second;
}

Grade Collector::grade(std::size_t i, const Graded& graded) const {
  const results::Totals sums = results::totals(graded.results.tasks);
  const auto judged =
      graded.problem.empty() ? std::optional(sums.points + sums.bonus_points) : std::nullopt;
  const auto by_hand = overrides_.find(i);
  return grade_of(graded.by, judged, plan_.rules.penalty,
                  by_hand == overrides_.end() ? Override() : by_hand->second);
}

// A file in an anonymous class may name its author.
void Collector::finish_page(const Graded& graded, const Grade& grade) const {
  const std::string path = out_ + "/" + graded.by.name + ".html";
  if (!fs::exists(path)) return;
  const std::string page = pt::read_file(path);
  std::map<std::string, std::string> files;
  if (plan_.real_names.empty()) files = files_of(config_, graded.by);
  // A file that is as it was handed out tells nobody anything.
  for (const results::TaskResult& task : graded.results.tasks) {
    if (task.state == results::State::not_attempted) files.erase(task.slug);
  }
  const std::string finished =
      platforms::finished_page(page, platforms::grade_sentence(grade.points, grade.reason), files);
  if (finished != page) pt::write_file(path, finished);
}

void Collector::add(std::size_t i, const Graded& graded) {
  const bool judged = graded.problem.empty(), anonymous = !plan_.real_names.empty();
  const results::Totals sums = results::totals(graded.results.tasks);
  max_points_ = std::max(max_points_, sums.max_points);
  const Grade grade = this->grade(i, graded);
  const std::string sentence = platforms::grade_sentence(grade.points, grade.reason);
  for_platforms_[i] = {anonymous ? plan_.real_names[i] : graded.by.name, graded.by.id,
                       grade.points.has_value(), grade.points.value_or(0),
                       (judged ? results::verdict(graded.results) : graded.by.problem) +
                           (sentence.empty() ? "" : (judged ? " " : ". ") + sentence)};
  const std::string note = note_on(i, graded);
  page_.add({graded.by.name, anonymous ? "" : graded.by.id, graded.by.name + ".html",
             graded.problem, graded.by.late, note, graded.by.absent, sentence},
            graded.results);
  if (judged) finish_page(graded, grade);
  if (judged && plan_.likeness) add_files(graded);
  lines_[i] = line(config_, graded, anonymous, note, grade);
  if (std::chrono::steady_clock::now() >= next_table_) write_table();
}

// Compares the task files of a submission, and keeps them for JPlag.
void Collector::add_files(const Graded& graded) {
  const std::map<std::string, std::string> files = files_of(config_, graded.by);
  const std::string folder = out_ + kLikeness + "/" + graded.by.name;
  if (!files.empty()) fs::create_directories(folder);
  for (const auto& [slug, text] : files) pt::write_file(folder + "/" + slug + ".cpp", text);
  likeness_.add(graded.by.name, files, graded.results);
}

void Collector::write_table() {
  pt::write_file(out_ + "/class.csv",
                 std::accumulate(lines_.begin(), lines_.end(), header(config_)));
  next_table_ = std::chrono::steady_clock::now() + kBetweenTables;
}

std::vector<std::string> Collector::write() {
  write_table();
  std::vector<std::string> written{out_ + "/class.csv", out_ + "/class.html"};
  pt::write_file(written[1], page_.to_html());
  if (plan_.likeness) {
    written.push_back(out_ + kLikeness + ".html");
    pt::write_file(written.back(),
                   likeness_.to_html([this](const std::string& slug, const std::string& name) {
                     // Code may name its author.
                     if (!plan_.real_names.empty())
                       return std::string("// left out: the class is anonymous");
                     const std::string own = out_ + kLikeness + "/" + name + "/" + slug + ".cpp";
                     return pt::read_file(fs::exists(own) ? own : config_.root + "/" + name);
                   }));
  }
  if (!plan_.former.empty()) {
    const platforms::Comparison comparison = compare(plan_, plan_.former, out_);
    for (const char* name : {"/compare.csv", "/compare.html"}) written.push_back(out_ + name);
    pt::write_file(out_ + "/compare.csv", platforms::comparison_csv(comparison));
    pt::write_file(out_ + "/compare.html", platforms::comparison_html(comparison));
    remarks_.push_back(platforms::comparison_sentence(comparison));
  }
  if (!plan_.real_names.empty()) {
    std::string names = std::string(report::kByteOrderMark) + "submission,name,id\r\n";
    for (std::size_t i = 0; i < plan_.everybody.size(); ++i) {
      const intake::HandedIn& by = plan_.everybody[i];
      names +=
          fmt::format("{},{},{}\r\n", by.name, csv_field(plan_.real_names[i]), csv_field(by.id));
    }
    written.push_back(out_ + "/names.csv");
    pt::write_file(written.back(), names);
  }
  for (const std::string& path : write_returns()) written.push_back(path);
  return written;
}

// The worksheet filled in, if there is one.
std::string Collector::moodle_table(const std::vector<platforms::GradeRow>& rows) {
  if (plan_.worksheet.empty()) {
    remarks_.emplace_back(
        "moodle.csv and feedback.zip go by the numbers in the names of the files; where groups "
        "hand in, these are not the participants': write --worksheet and Moodle's grading "
        "worksheet");
    return platforms::moodle_csv(rows, max_points_);
  }
  platforms::Worksheet::Filled filled =
      platforms::read_worksheet(plan_.worksheet).filled(rows, max_points_);
  if (filled.locked > 0) {
    remarks_.push_back(
        fmt::format("{} says of {} of the submissions that Moodle lets their grade "
                    "not be changed: it stays",
                    plan_.worksheet, filled.locked));
  }
  if (!filled.unclear.empty()) {
    remarks_.push_back(
        fmt::format("{}: nobody knows which submission is that of {}: two have such a name, or two "
                    "groups; their members get no "
                    "grade here. Give the groups other names in Moodle, and download both again",
                    plan_.worksheet, some_of(filled.unclear)));
  }
  if (!filled.strays.empty()) {
    const std::string names = plan_.real_names.empty() ? ": " + some_of(filled.strays) : "";
    remarks_.push_back(fmt::format("{} has no row for {} of the submissions{}", plan_.worksheet,
                                   filled.strays.size(), names));
  }
  return filled.text;
}

// The paths under which learners get their pages, if Moodle's worksheet tells who is who.
std::map<std::string, std::vector<std::string>> Collector::pages_of_moodle() const {
  if (plan_.worksheet.empty()) return {};
  std::vector<platforms::GradeRow> rows;
  std::map<std::string, std::string> paths;
  for (std::size_t i = 0; i < plan_.everybody.size(); ++i) {
    if (plan_.everybody[i].platform != intake::Platform::moodle) continue;
    rows.push_back(for_platforms_[i]);
    paths[rows.back().name] = plan_.everybody[i].feedback;
  }
  return platforms::read_worksheet(plan_.worksheet)
      .pages(rows, [&](const platforms::GradeRow& row) { return paths.at(row.name); });
}

std::vector<std::string> Collector::write_returns() {
  std::vector<platforms::GradeRow> canvas, moodle, gradescope;
  std::vector<intake::Packed> pages;
  const auto of_moodle = pages_of_moodle();
  for (std::size_t i = 0; i < plan_.everybody.size(); ++i) {
    const intake::HandedIn& by = plan_.everybody[i];
    const platforms::GradeRow& row = for_platforms_[i];
    if (by.platform == intake::Platform::canvas) canvas.push_back(row);
    if (by.platform == intake::Platform::moodle) moodle.push_back(row);
    const bool listed = by.platform == intake::Platform::gradescope;
    if (listed) gradescope.push_back(row);
    std::vector<std::string> paths{listed ? row.name + ".html" : by.feedback};
    if (by.platform == intake::Platform::moodle && !plan_.worksheet.empty()) {
      const auto found = of_moodle.find(row.name);
      paths = found == of_moodle.end() ? std::vector<std::string>() : found->second;
    }
    for (const std::string& path : paths) {
      const std::string page = out_ + "/" + by.name + ".html";
      if (row.judged && !path.empty() && fs::exists(page)) pages.push_back({path, page});
    }
  }
  std::vector<std::string> written;
  const auto write_text = [&](const std::string& name, const std::string& text) {
    written.push_back(out_ + "/" + name);
    pt::write_file(written.back(), text);
  };
  if (!canvas.empty()) {
    const std::string column =
        plan_.assignment.empty() ? export_name(plan_.input) : plan_.assignment;
    write_text("canvas.csv", platforms::canvas_csv(canvas, column, max_points_));
  }
  if (!gradescope.empty()) {
    write_text("gradescope.csv", platforms::gradescope_csv(gradescope, max_points_));
  }
  if (!pages.empty()) {
    written.push_back(out_ + "/feedback.zip");
    intake::pack(written.back(), pages);
  }
  fs::remove(out_ + "/moodle.csv");  // of an earlier call: the worksheet may be unusable now
  if (!moodle.empty()) write_text("moodle.csv", moodle_table(moodle));
  return written;
}

}  // namespace grader::classes
