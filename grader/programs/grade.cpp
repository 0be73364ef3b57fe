// grade: judges a submission, and never runs a line of it itself. Exit status 0 if all that was
// asked for passes, 1 if something that was judged does not, 2 if nothing could be judged.
#include "grader/service/judging/grade.h"

#include "grader/base/files.h"
#include "grader/programs/examples_in_results.h"
#include "grader/programs/grade_options.h"
#include "grader/report/hints.h"
#include "grader/report/status_line.h"
#include "grader/report/terminal.h"
#include "grader/results/json.h"
#include "grader/results/points.h"
#include "grader/results/presentable.h"
#include "grader/results/summary.h"
#include "grader/service/intake/taken_in.h"
#include "grader/service/process/spawn.h"
#include "grader/tasks.h"
#include "pt/end_of_program.h"
#include "pt/error.h"
#include "pt/file.h"

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <set>
#include <sstream>

#include <fmt/format.h>
#include <unistd.h>

namespace {

using namespace grader;
using namespace grader::programs;
using Words = std::vector<std::string>;

build::Config config_for(const GradeOptions& options) {
  build::Config config =
      build::load_config(options.config.empty() ? build::default_config_path() : options.config);
  if (!options.work.empty()) config.work = std::filesystem::absolute(options.work);
  return config;
}

sandbox::Isolation isolation(const build::Config& config, const GradeOptions& options) {
  std::optional<sandbox::Tier> forced;
  if (!options.isolation.empty()) forced = sandbox::tier_of(options.isolation);
  sandbox::Isolation found = sandbox::probe_isolation(config.root, config.work, forced);
  if (options.require_isolation && found.tier == sandbox::Tier::limits) {
    throw pt::Error("--require-isolation refuses to grade in C" +
                    (forced ? ", which --isolation chose" : ": " + found.why_not_better));
  }
  return found;
}

int show(const results::Results& results, const GradeOptions& options) {
  const std::string text =
      report::to_text(results::presentable(results), {report::terminal_has_color(), options.all});
  std::fputs(text.c_str(), stdout);
  return results.complete && results::passes(results) ? 0 : 1;
}

// A small page is one for a class, and will be passed on.
report::ReportFiles files_of(const build::Config& config, const GradeOptions& options) {
  report::ReportFiles files = options.files;
  if (!files.small_page) files.root = config.root;
  return files;
}

int report_again(const build::Config& config, const GradeOptions& options) {
  const results::Results results = results::read_results(options.from_results);
  report::write_reports(results, files_of(config, options));
  return show(results, options);
}

// The folder and the arguments of a run that has not ended, each followed by a zero byte, so that it
// can be resumed. Its results so far are in the cache. Runs without pictures are too short for this.
class Unfinished {
 public:
  explicit Unfinished(const build::Config& config) : path_(config.work + "/unfinished") {}

  void begin(const Words& words) const {
    std::string all = std::filesystem::current_path().string() + '\0';
    for (const std::string& word : words) all += word + '\0';
    std::filesystem::create_directories(std::filesystem::path(path_).parent_path());
    pt::write_file(path_, all);
  }
  void end() const { std::filesystem::remove(path_); }

  // Goes to the folder of that run, so that its paths are right again.
  Words resume() const {
    if (!std::filesystem::exists(path_)) {
      throw pt::Error("no run was interrupted: there is nothing to --resume");
    }
    std::istringstream all(pt::read_file(path_));
    std::string folder;
    std::getline(all, folder, '\0');
    if (folder.empty() || all.eof()) {
      throw pt::Error(path_ + " does not say which run was interrupted; grade again");
    }
    std::error_code error;
    std::filesystem::current_path(folder, error);
    if (error) {
      throw pt::Error("the run was started in " + folder +
                      ", which does not exist any more; grade again");
    }
    Words words;
    for (std::string word; std::getline(all, word, '\0');) words.push_back(word);
    return words;
  }

 private:
  std::string path_;
};

// The slugs of the tasks that were named; without a name, of all tasks that earn a point.
std::vector<std::string> asked_for(const build::Config& config, const GradeOptions& options) {
  std::set<std::string> named;
  for (const std::string& word : options.what) {
    for (const std::string& slug : judging::tasks_meant(config, word)) named.insert(slug);
  }
  const std::string points_file = config.root + "/grader/points.json";
  const results::Points points = results::load_points(points_file);
  std::vector<std::string> asked;
  for (const build::TaskConfig& task : config.tasks) {
    const bool meant = options.what.empty() && !results::is_left_out(points, task.slug);
    if (meant || named.contains(task.slug)) asked.push_back(task.slug);
  }
  if (asked.empty()) throw pt::Error(points_file + ": nothing earns a point");
  return asked;
}

// Writes the task files of a submission to a folder; what is there already stays as it is, so that it need not
// be compiled again.
int take_to(const build::Config& config, const GradeOptions& options) {
  const intake::TakenIn taken(config, options.submission);
  for (const build::TaskConfig& task : config.tasks) {
    const base::Submitted file = base::read_submitted(taken.folder(), task.part, task.slug);
    const std::string problem = file.present ? file.rejected : "it is not in the submission";
    const std::string text =
        problem.empty() ? file.text : fmt::format("#error \"{}: {}\"\n", task.file(), problem);
    const std::filesystem::path path = std::filesystem::path(options.take_to) / task.file();
    std::filesystem::create_directories(path.parent_path());
    if (!std::filesystem::exists(path) || pt::read_file(path) != text) pt::write_file(path, text);
  }
  return 0;
}

// Returns whether each function of the task begins with todo, as it was handed out. In doubt it does not: a comment
// or a condition of the preprocessor can contain another version of the function.
bool is_unwritten(const Task& task, const std::string& text) {
  if (text.find("/*") != text.npos || text.find("#if") != text.npos) return false;
  const std::string begin = "{\n  todo(\"" + task.slug + "\");\n";
  std::size_t found = 0;
  for (std::size_t at = text.find(begin); at != text.npos; at = text.find(begin, at + 1)) ++found;
  return found == std::max<std::size_t>(1, task.functions.size());
}

// Tasks that are not written get no pictures. A file that is not accepted now can be corrected before it is
// judged.
bool may_be_rendered(const std::vector<std::string>& asked, const std::string& submission) {
  return std::ranges::any_of(asked, [&](const std::string& slug) {
    const Task& task = task_of(slug);
    const base::Submitted file = base::read_submitted(submission, task.part, slug);
    return file.present && (!file.rejected.empty() || !is_unwritten(task, file.text));
  });
}

// The files of a submission that was named, wherever they are in it: as for a class. The folder student/ is read as
// it is.
std::optional<intake::TakenIn> taken_in(const build::Config& config, const GradeOptions& options) {
  if (!options.is_named) return std::nullopt;
  return std::optional<intake::TakenIn>(std::in_place, config, options.submission);
}

// Prints the names of the programs, one per line, for ./run, which builds only these.
int name_programs(const build::Config& config, const GradeOptions& options) {
  const std::vector<std::string> asked = asked_for(config, options);
  for (const std::string& slug : judging::tasks_judged(config, asked)) {
    fmt::print("graded.{0}\nknown.{0}\n", slug);
  }
  const results::Points points = results::load_points(config.root + "/grader/points.json");
  for (const std::string& slug : with_points_for_examples(points, asked)) {
    fmt::print("grade_examples\nexamples.{}\n", slug);
  }
  if (options.no_pictures) return 0;
  const auto taken = taken_in(config, options);
  const bool is_refused = taken && !taken->found().problem.empty();
  const std::string folder =
      taken ? taken->found().folder : base::submission_root(options.submission);
  if (!is_refused && may_be_rendered(asked, folder)) {
    fmt::print("graded_picture\n");
  }
  return 0;
}

// The dialect of the course in whose skeleton the work is; nothing if it is in ours.
std::optional<door::Dialect> dialect_of(const build::Config& config, const GradeOptions& options,
                                        const std::optional<intake::TakenIn>& taken) {
  const auto course = options.course.empty() ? taken ? taken->found().course : std::nullopt
                                             : door::course_since(options.course);
  if (!course) return std::nullopt;
  const std::string texts = config.root + "/grader/door";
  return options.dialect == "none" ? door::no_dialect(texts, *course)
                                   : door::load_dialect(texts, *course);
}

judging::GradeRequest request_for(const build::Config& config, const GradeOptions& options,
                                  const std::optional<intake::TakenIn>& taken) {
  judging::GradeRequest request;
  request.dialect = dialect_of(config, options, taken);
  request.note = options.note;
  if (taken) {
    request.submission = taken->found().folder;
    request.refused = taken->found().problem;
    if (request.note.empty()) request.note = taken->found().note;
    if (taken->is_copied() || !request.refused.empty()) request.shown = options.submission;
  } else {
    request.submission = base::submission_root(options.submission);
  }
  request.name = results::one_line(options.name);
  request.seed = options.seed;
  request.call_limit = options.call_limit;
  request.compile_limit = options.compile_limit;
  request.threads = options.threads;
  request.isolation = isolation(config, options);
  request.pictures = !options.no_pictures;
  request.command = programs::command(options);
  request.asked = asked_for(config, options);
  return request;
}

// Shows how many verdicts there are, of how many in the end. Compiling is the first phase that ends.
void show_progress(report::StatusLine& line, const results::Results& so_far) {
  const results::Counts verdicts = results::verdicts(so_far);
  const double part = static_cast<double>(verdicts.judged) / static_cast<double>(verdicts.all);
  line.show(so_far.phases.empty()
                ? "judging: compiling the submission"
                : fmt::format("judging: {} of {} verdicts", verdicts.judged, verdicts.all),
            part);
}

int run(Words words) {
  programs::GradeOptions options = parse_options(words);
  report::check_targets(options.files);
  const build::Config config = config_for(options);
  if (!options.from_results.empty()) return options.programs ? 0 : report_again(config, options);
  const Unfinished unfinished(config);
  if (options.resume) {
    const bool only_named = options.programs;
    words = unfinished.resume();
    options = programs::parse_options(words);
    options.programs = only_named;
    report::check_targets(options.files);
  }
  if (options.require_isolation) isolation(config, options);  // it refuses before anything is read
  if (options.programs) return name_programs(config, options);
  if (!options.take_to.empty()) return take_to(config, options);
  const auto taken = taken_in(config, options);
  const judging::GradeRequest request = request_for(config, options, taken);
  if (request.pictures) unfinished.begin(words);
  report::ProgressReports reports(files_of(config, options));
  std::optional<report::StatusLine> line(std::in_place, options.quiet
                                                            ? report::StatusLine::Output::none
                                                            : report::StatusLine::standard());
  results::Results results = judging::grade(config, request, [&](const results::Results& so_far) {
    reports.write(so_far);
    show_progress(*line, so_far);
  });
  line.reset();
  if (request.refused.empty()) {
    add_examples(config, options.config.empty() ? build::default_config_path() : options.config,
                 request.submission, results);
    reports.write(results);
  }
  if (request.pictures) unfinished.end();
  report::remember_failures(config.work, results);
  if (!request.note.empty()) fmt::print("Of the files, {}.\n", results::one_line(request.note));
  return show(results, options);
}

}  // namespace

int main(int argc, char** argv) {
  process::hide_process();
  std::signal(SIGPIPE, SIG_IGN);
  return pt::run_program([&] { return run(Words(argv + 1, argv + argc)); });
}
