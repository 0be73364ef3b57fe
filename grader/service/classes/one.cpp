#include "grader/service/classes/one.h"

#include "grader/base/files.h"
#include "grader/base/sha256.h"
#include "grader/report/write_reports.h"
#include "grader/results/json.h"
#include "grader/results/points.h"
#include "grader/results/presentable.h"
#include "grader/service/build/cache.h"
#include "grader/service/classes/claim.h"
#include "grader/service/classes/identity.h"
#include "grader/service/judging/name_mistakes.h"
#include "grader/service/process/run_command.h"
#include "grader/service/sandbox/box.h"
#include "pt/end_of_program.h"
#include "pt/error.h"
#include "pt/file.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <sstream>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/wait.h>

namespace grader::classes {

namespace {

namespace fs = std::filesystem;

// Far longer than the slowest submission takes.
constexpr std::chrono::hours kMaxTime{2};
constexpr const char* kNotYet = "it is not judged yet";

// Hashes of all that the reports depend on: the judged files, the way of judging, the points.
struct Key {
  std::string judging, points;
  std::string text() const { return judging + '\n' + points + '\n'; }
  bool operator==(const Key&) const = default;
};

std::string points_file(const Judging& judging) {
  return judging.config.root + "/grader/points.json";
}

// A text that changes with any file in a folder. The folder's own stamp does not.
std::string stamp_of_files(const std::string& folder) {
  std::set<std::string> stamps;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.is_regular_file()) stamps.insert(base::stamp(entry.path()));
  }
  return fmt::format("{}", fmt::join(stamps, "\n"));
}

Key key_of(const Judging& judging, const intake::HandedIn& by) {
  const build::Config& config = judging.config;
  const std::string cache = config.work + "/cache";
  const auto stamp = [&](const std::string& path) { return build::content_stamp(path, cache); };
  std::string key =
      stamp(judging.grade) + stamp(config.picture) + stamp(config.root + "/scenes/recipes.json");
  const std::string golden = config.root + "/golden";
  if (fs::exists(golden)) key += stamp_of_files(golden);
  for (const std::string& word : judging.words) key += word + '\0';
  key += std::to_string(judging.seed);
  if (by.course) key += door::year_of(*by.course);
  const std::string root = base::submission_root(by.folder);
  const results::Points points = results::load_points(points_file(judging));
  for (const build::TaskConfig& task : config.tasks) {
    const base::Submitted file = base::read_submitted(root, task.part, task.slug);
    key += fmt::format("{} {} {}\n", file.present, file.rejected, base::sha256(file.text));
    if (points.at(task.slug).examples > 0)
      key += base::sha256(base::read_submitted(root, task.part, task.slug + ".examples").text);
    if (!task.graded.empty()) key += stamp(task.graded);
    const std::string known = judging::known_path(task);
    if (fs::exists(known)) key += stamp(known);
  }
  return {base::sha256(key), base::sha256(pt::read_file(points_file(judging)))};
}

// The text of the key's file, or an empty one if there are no reports.
std::string key_text_at(const std::string& path) {
  for (const char* ending : {".json", ".html", ".key"}) {
    if (!fs::exists(path + ending)) return "";
  }
  return pt::read_file(path + ".key");
}

// The key of the reports with this path; empty if there are none.
Key key_at(const std::string& path) {
  std::istringstream lines(key_text_at(path));
  Key key;
  std::getline(lines, key.judging);
  std::getline(lines, key.points);
  return key;
}

// Returns whether the page's pictures are still there: the judge may have cleared its cache.
bool has_its_pictures(const results::Results& results) {
  for (const results::TaskResult& task : results.tasks) {
    for (const results::PictureResult& picture : task.pictures) {
      for (const std::string* file : {&picture.render, &picture.evidence, &picture.counts}) {
        if (!file->empty() && !fs::exists(*file)) return false;
      }
    }
  }
  return true;
}

// The results of an earlier run with recounted points, if only the points have changed since.
std::optional<results::Results> counted_anew(const Judging& judging, const std::string& path,
                                             const Key& key) {
  if (key_at(path).judging != key.judging) return std::nullopt;
  results::Results results = results::read_results(path + ".json");
  if (!results.complete || !has_its_pictures(results)) return std::nullopt;
  const results::Points points = results::load_points(points_file(judging));
  for (results::TaskResult& task : results.tasks) results::count_points(points, task);
  return results;
}

// Nobody is at fault, and the next attempt will work.
struct Changed : pt::Error {
  using pt::Error::Error;
};

// A chunk of an earlier plan may still run, here or on another machine. The plan of a large class takes
// long to read, so it is read only if the file has changed.
void check_plan_stays(const Judging& judging) {
  static std::mutex mutex;
  static std::map<std::string, std::string> ids;  // by the stamp of the file
  const std::string stamp = base::stamp(judging.out + "/plan.json");
  const std::lock_guard lock(mutex);
  std::string& id = ids[stamp];
  if (id.empty()) id = read_plan(judging.out).id;
  if (id != judging.plan) throw Changed("another plan of this class has been made meanwhile");
}

// The reason why this plan could not judge it; else empty.
std::string problem_of(const Judging& judging, const std::string& path) {
  const std::string file = path + ".problem", first = judging.plan + '\n';
  if (!fs::exists(file)) return "";
  const std::string text = pt::read_file(file);
  return text.starts_with(first) ? text.substr(first.size()) : "";
}

void note_problem(const Judging& judging, const std::string& path, const std::string& problem) {
  pt::write_file(path + ".problem", judging.plan + '\n' + problem);
}

// Returns why the submission could not be judged; empty if it was judged.
std::string run_grade(const Judging& judging, const intake::HandedIn& by, const std::string& path) {
  std::vector<std::string> command{judging.grade,
                                   "--submission=" + by.folder,
                                   "--name=" + by.name,
                                   "--json=" + path + ".json",
                                   "--html=" + path + ".html",
                                   "--small-page",
                                   "--quiet",
                                   "--seed=" + std::to_string(judging.seed)};
  if (std::ranges::none_of(judging.words,
                           [](const auto& word) { return word.starts_with("--threads"); })) {
    command.push_back("--threads=" + std::to_string(judging.threads));
  }
  if (!by.note.empty()) command.push_back("--note=" + by.note);
  if (by.course) command.push_back("--course=" + door::year_of(*by.course));
  if (!judging.work.empty()) command.push_back("--work=" + judging.work);
  command.insert(command.end(), judging.words.begin(), judging.words.end());
  const auto run = [&] {
    return process::run_command({command, sandbox::judges_environment(), {}, "", {}}, kMaxTime);
  };
  process::CommandResult result = run();
  // Somebody, or a lack of memory, killed the process. Its results so far are kept.
  if (!result.timed_out && WIFSIGNALED(result.status)) result = run();
  if (!result.timed_out && WIFEXITED(result.status) && WEXITSTATUS(result.status) <= 1) return "";
  return process::fault_of(result);
}

// Makes the reports. `equal`: results of a submission with equal files, if there are any.
results::Results make_reports(const Judging& judging, const intake::HandedIn& by, const Key& key,
                              const std::optional<results::Results>& equal) {
  const std::string path = judging.out + "/" + by.name;
  std::optional<results::Results> known = equal;
  if (known && !has_its_pictures(*known)) known.reset();
  if (!known) known = counted_anew(judging, path, key);
  const auto former = judging.former_names.find(by.name);
  if (!known && former != judging.former_names.end()) {
    known = counted_anew(judging, judging.former + "/" + former->second, key);
  }
  fs::remove(path + ".key");  // in case this run ends before the reports are complete
  if (known) {
    known->submission = results::one_line(by.name);
    report::write_reports(*known, {path + ".json", path + ".html", "", {}, "", true});
  } else if (const std::string problem = run_grade(judging, by, path); !problem.empty()) {
    throw pt::Error(problem);
  }
  results::Results results = results::read_results(path + ".json");
  if (!results.complete) throw pt::Error("the run was stopped before it ended");
  if (key_of(judging, by) != key) {
    throw Changed("its files, or the grader's, have changed while it was judged");
  }
  pt::write_file(path + ".key", key.text());
  return results;
}

Graded grade_one(const Judging& judging, const intake::HandedIn& by,
                 const std::optional<results::Results>& equal) {
  const std::string path = judging.out + "/" + by.name;
  Graded graded{by};
  try {
    const Claim claim(judging.out, by.name);
    check_plan_stays(judging);
    const Key key = key_of(judging, by);
    graded.again = key_at(path) == key;
    graded.results = graded.again ? results::read_results(path + ".json")
                                  : make_reports(judging, by, key, equal);
    fs::remove(path + ".problem");
  } catch (const Changed& changed) {
    graded.problem = changed.what();
    graded.changed = true;
  } catch (const std::exception& error) {
    graded.problem = pt::sentence_of(error);
    if (judging.anonymous) graded.problem = without_names(graded.problem, by.folder);
    note_problem(judging, path, graded.problem);
  }
  return graded;
}

}  // namespace

void forget_outcomes(const std::string& out, const std::vector<intake::HandedIn>& everybody) {
  for (const intake::HandedIn& by : everybody) {
    const std::string path = out + "/" + by.name;
    fs::remove(path + ".problem");
    if (by.problem.empty()) continue;
    for (const char* ending : {".json", ".html", ".key"}) fs::remove(path + ending);
  }
}

Graded graded_before(const Judging& judging, const intake::HandedIn& by) {
  const std::string path = judging.out + "/" + by.name;
  Graded graded{by, {}, by.problem, true};
  if (!by.problem.empty()) return graded;
  try {
    if (key_at(path) == key_of(judging, by)) {
      graded.results = results::read_results(path + ".json");
    } else {
      graded.problem = problem_of(judging, path);
      if (graded.problem.empty()) graded.problem = kNotYet;
    }
  } catch (const std::exception& error) {
    graded.problem = pt::sentence_of(error);
  }
  return graded;
}

std::string outcome_so_far(const Judging& judging, const intake::HandedIn& by) {
  const std::string path = judging.out + "/" + by.name;
  return problem_of(judging, path) + key_text_at(path);
}

bool is_done(const Judging& judging, const intake::HandedIn& by) {
  if (!by.problem.empty()) return true;
  const std::string path = judging.out + "/" + by.name;
  if (!problem_of(judging, path).empty()) return true;
  const Key known = key_at(path);
  if (known == Key{}) return false;  // most are in this state: saves reading their files
  try {
    return known == key_of(judging, by);
  } catch (const std::exception&) {
    return false;  // the process that judges it reports the fault
  }
}

void grade_equal(const Judging& judging, const std::vector<intake::HandedIn>& equal,
                 const std::function<void(std::size_t, const Graded&)>& report) {
  std::optional<results::Results> known;
  for (std::size_t i = 0; i < equal.size(); ++i) {
    const Graded last = grade_one(judging, equal[i], known);
    report(i, last);
    // Pictures that were removed from the cache are rendered again.
    if (!known && last.problem.empty() && has_its_pictures(last.results)) known = last.results;
  }
}

}  // namespace grader::classes
