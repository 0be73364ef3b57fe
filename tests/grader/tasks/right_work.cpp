#include "tests/grader/tasks/right_work.h"

#include "grader/base/sha256.h"
#include "grader/base/sources_in.h"
#include "pt/error.h"
#include "pt/file.h"
#include "pt/sampling/sampler.h"
#include "tests/fixtures/task_folder.h"

#include <algorithm>
#include <fstream>
#include <map>
#include <mutex>
#include <sstream>

#include <fmt/format.h>

namespace grader::tests {

namespace fs = std::filesystem;

namespace {

constexpr int kColumns = 9;

// With many busy loops running, a right task takes longer by the clock, but not in its own time.
constexpr int kCallLimit = 2000;

RightJob all_reference(const Choices& choices) {
  RightJob job;
  for (const auto& [slug, files] : choices) job.files[slug] = files.front();
  return job;
}

// Thousands of jobs need the hashes of the same programs, which do not change meanwhile.
const std::string& file_hash(const std::string& path) {
  static std::mutex lock;
  static std::map<std::string, std::string> hashes;
  const std::lock_guard guard(lock);
  std::string& hash = hashes[path];
  if (hash.empty()) hash = base::sha256(pt::read_file(path));
  return hash;
}

std::string judge_hash(const build::Config& config, const RightJob& job) {
  std::string text;
  for (const auto& [slug, file] : job.files) text += slug + '\0' + file_hash(file);
  for (const build::TaskConfig& task : config.tasks) {
    const bool judged = std::count(job.asked.begin(), job.asked.end(), task.slug) > 0;
    if (judged) text += file_hash(task.graded);
  }
  if (job.pictures) {
    text += file_hash(config.picture) + file_hash(config.root + "/scenes/recipes.json");
  }
  return base::sha256(text).substr(0, 12);
}

// A submission may be twelve files without folders.
class Folder {
 public:
  Folder(const std::string& path, const RightJob& job) : path_(path) {
    fs::create_directories(path_);
    for (const auto& [slug, file] : job.files) {
      fs::copy_file(file, path_ / (slug + ".cpp"), fs::copy_options::overwrite_existing);
    }
  }
  ~Folder() { fs::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

 private:
  fs::path path_;
};

// One line without commas, because people open the file in spreadsheets.
std::string one_line(std::string text) {
  for (char& c : text) {
    if (c == '\n' || c == '\r' || c == ',' || c == '"') c = ' ';
  }
  return text;
}

std::string faults_of(const RightJob& job, const results::TaskResult& task) {
  std::string text = fmt::format("{}: {}", task.slug, name(task.state));
  if (!task.reason.empty()) text += ", " + task.reason;
  for (const results::PromiseResult& promise : task.promises) {
    if (promise.held || promise.bonus) continue;
    text += ", " + promise.name;
    for (const results::Failure& failure : promise.failures) {
      text += fmt::format(" ({} got {} expected {})", failure.what, failure.got, failure.expected);
    }
  }
  for (const results::PictureResult& picture : task.pictures) {
    if (picture.state != results::State::pass)
      text += ", picture " + picture.recipe + " " + picture.text;
  }
  const fs::path file = job.files.at(task.slug);
  return one_line(text + " [" + file.stem().string() + "]");
}

}  // namespace

Choices right_choices(const build::Config& config) {
  Choices choices;
  for (const build::TaskConfig& task : config.tasks) {
    const fs::path reference = fs::path(config.root) / "reference" / task.file();
    if (!fs::exists(reference)) {
      throw pt::Error(reference.string() + " is missing: the learners' edition cannot do this");
    }
    choices[task.slug] = {reference};
    const auto variants =
        base::sources_in(fs::path(config.root) / "grader/tasks" / task.slug / "right");
    choices[task.slug].insert(choices[task.slug].end(), variants.begin(), variants.end());
  }
  return choices;
}

RightJob reference_job(const Choices& choices, std::uint64_t seed) {
  RightJob job = all_reference(choices);
  job.kind = job.name = "reference";
  for (const auto& each : choices) job.asked.push_back(each.first);
  job.seed = seed;
  return job;
}

std::vector<RightJob> variant_jobs(const Choices& choices, std::uint64_t seed) {
  std::vector<RightJob> jobs;
  for (const auto& [slug, files] : choices) {
    for (std::size_t i = 1; i < files.size(); ++i) {
      RightJob job = all_reference(choices);
      job.kind = "variant";
      job.name = slug + "." + files[i].stem().string();
      job.files[slug] = files[i];
      job.asked = {slug};
      job.seed = seed;
      jobs.push_back(job);
    }
  }
  return jobs;
}

std::vector<RightJob> whole_jobs(const build::Config& config, std::uint64_t seed) {
  std::vector<RightJob> jobs;
  for (const auto& folder : fs::directory_iterator(config.root + "/tests/fixtures/right")) {
    RightJob job;
    job.kind = "whole";
    job.name = folder.path().filename();
    job.seed = seed;
    for (const build::TaskConfig& task : config.tasks) {
      job.files[task.slug] = folder.path() / (task.slug + ".cpp");
      job.asked.push_back(task.slug);
    }
    jobs.push_back(job);
  }
  std::sort(jobs.begin(), jobs.end(),
            [](const RightJob& a, const RightJob& b) { return a.name < b.name; });
  return jobs;
}

RightJob mixture_job(const Choices& choices, int number) {
  RightJob job;
  job.kind = "mixture";
  job.name = std::to_string(number);
  job.seed = 1000 + static_cast<std::uint64_t>(number);
  pt::Sampler sampler(job.seed);
  for (const auto& [slug, files] : choices) {
    const double place = sampler.next_1d() * static_cast<double>(files.size());
    job.files[slug] = files[static_cast<std::size_t>(place)];
    job.asked.push_back(slug);
  }
  return job;
}

std::string RightRow::key() const {
  return fmt::format("{},{},{},{:d},{},{}", kind, name, seed, pictures, busy, judge);
}

RightRow row_of(const build::Config& config, const RightJob& job, int busy) {
  RightRow row;
  row.kind = job.kind;
  row.name = job.name;
  row.seed = job.seed;
  row.pictures = job.pictures;
  row.busy = busy;
  row.judge = judge_hash(config, job);
  return row;
}

std::string to_line(const RightRow& row) {
  return fmt::format("{},{:d},{:.2f},{}", row.key(), row.passed, row.seconds, row.faults);
}

std::vector<RightRow> read_right_rows(const fs::path& path) {
  std::vector<RightRow> rows;
  std::ifstream file(path);
  int number = 1;
  for (std::string line; std::getline(file, line) && !file.eof(); ++number) {
    std::istringstream in(line);
    std::vector<std::string> words(kColumns);
    for (std::string& word : words) std::getline(in, word, ',');
    try {
      RightRow row;
      row.kind = words[0];
      row.name = words[1];
      row.seed = std::stoull(words[2]);
      row.pictures = words[3] == "1";
      row.busy = std::stoi(words[4]);
      row.judge = words[5];
      row.passed = words[6] == "1";
      row.seconds = std::stod(words[7]);
      row.faults = words[8];
      rows.push_back(row);
    } catch (const std::logic_error&) {
      throw pt::Error(fmt::format("{}:{}: this is not a row of right_work; choose another --out",
                                  path.string(), number));
    }
  }
  return rows;
}

RightRow grade_right(const build::Config& config, const sandbox::Isolation& isolation,
                     const RightJob& job, int busy) {
  RightRow row = row_of(config, job, busy);
  const std::string path = pt::temporary_name(
      fmt::format("{}/right/{}.{}.{}", config.work, job.kind, job.name, job.seed));
  const Folder folder(path, job);
  judging::GradeRequest request;
  request.submission = path;
  request.asked = job.asked;
  request.seed = job.seed;
  request.threads = 1;
  request.call_limit = kCallLimit;
  request.pictures = job.pictures;
  request.isolation = isolation;
  const results::Results results = judging::grade(config, request, [](const results::Results&) {});
  row.passed = results::passes(results);
  row.seconds = results.seconds;
  for (const results::TaskResult& task : results.tasks) {
    if (task.state == results::State::pass) continue;
    row.faults += (row.faults.empty() ? "" : "; ") + faults_of(job, task);
  }
  return row;
}

}  // namespace grader::tests
