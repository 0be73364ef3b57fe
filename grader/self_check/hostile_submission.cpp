#include "grader/self_check/hostile_submission.h"

#include "grader/process/run_command.h"
#include "grader/sandbox/box.h"
#include "grader/sandbox/users.h"

#include <algorithm>
#include <fstream>
#include <iterator>

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

namespace grader::self_check {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

void replace_all(std::string& text, const std::string& word, const std::string& by) {
  for (std::size_t at = text.find(word); at != text.npos; at = text.find(word, at + by.size())) {
    text.replace(at, word.size(), by);
  }
}

}  // namespace

std::string text_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  EXPECT_TRUE(file) << path;
  return {std::istreambuf_iterator<char>(file), {}};
}

std::vector<std::string> environment() {
  std::vector<std::string> words = sandbox::judges_environment();
  words.emplace_back("FIRSTLIGHT_SECRET=1");  // what an attack looks for
  return words;
}

const json& Outcome::task(const std::string& slug) const {
  static const json none;
  if (results.is_null()) return none;
  for (const json& each : results.at("tasks")) {
    if (each.at("slug") == slug) return each;
  }
  return none;
}

std::string Outcome::state(const std::string& slug) const {
  return task(slug).is_null() ? "missing" : task(slug).at("state").get<std::string>();
}

Submission::Submission(const std::string& name)
    : folder_(fs::path(testing::TempDir()) / ("firstlight_" + name + std::to_string(getpid()))) {
  fs::copy(FIRSTLIGHT_ROOT "/reference", folder_, fs::copy_options::recursive);
}

Submission::~Submission() {
  fs::remove_all(folder_);
  fs::remove_all(work());
}

fs::path Submission::file_of(const std::string& slug) const {
  for (const auto& part : fs::directory_iterator(folder_)) {
    fs::path file = part.path() / (slug + ".cpp");
    if (fs::exists(file)) return file;
  }
  ADD_FAILURE() << slug << " is not a task";
  return folder_ / slug;
}

void Submission::replace(const std::string& slug, const fs::path& solution) const {
  fs::copy_file(solution, file_of(slug), fs::copy_options::overwrite_existing);
}

std::vector<std::string> Submission::put(const std::string& batch) {
  const fs::path hostile = FIRSTLIGHT_ROOT "/grader/self_check/hostile";
  std::vector<std::string> slugs;
  for (const auto& entry : fs::recursive_directory_iterator(hostile / batch)) {
    if (!entry.is_regular_file()) continue;
    fs::path file = fs::relative(entry.path(), hostile / batch);
    if (file.extension() == ".in") file.replace_extension();
    std::string text = text_of(entry.path());
    replace_all(text, "@RAW@\n", text_of(hostile / "raw.h"));
    replace_all(text, "@ROOT@", FIRSTLIGHT_ROOT);
    replace_all(text, "@SUBMISSION@", folder_);
    replace_all(text, "@WORK@", work());
    // The number of root where the judge is root, and else of nobody: in a user namespace, 0 says nothing.
    replace_all(text, "@JUDGES_ROOT@", sandbox::is_root_of_the_machine() ? "0" : "-1");
    std::ofstream(folder_ / file) << text;
    slugs.push_back(file.stem());
  }
  std::sort(slugs.begin(), slugs.end());
  return slugs;
}

Outcome Submission::run(const std::vector<std::string>& command) const {
  const fs::path json_path = folder_ / "results.json";
  fs::remove(json_path);
  const process::CommandResult run =
      process::run_command({command, environment(), {}, "", {}}, std::chrono::seconds(900));
  EXPECT_FALSE(run.timed_out);
  EXPECT_TRUE(WIFEXITED(run.status)) << process::describe_status(run.status);
  Outcome outcome{WEXITSTATUS(run.status), run.output, {}};
  if (fs::exists(json_path)) outcome.results = json::parse(text_of(json_path));
  return outcome;
}

Outcome Submission::grade(std::vector<std::string> words, int call_limit) const {
  words.insert(words.begin(),
               {FIRSTLIGHT_GRADE, "--submission", folder_, "--json", folder_ / "results.json",
                "--call-limit", std::to_string(call_limit)});
  return run(words);
}

std::vector<std::string> Submission::command(std::vector<std::string> words) const {
  fs::remove_all(work());
  fs::create_directories(work());
  json config = json::parse(text_of(fs::path(FIRSTLIGHT_GRADE).parent_path() / "grade.json"));
  // Headers that are compiled already take seconds to compile again, and no attack is on them.
  const fs::path headers = fs::path(config["work"].get<std::string>()) / "headers";
  if (fs::exists(headers)) fs::copy(headers, work() / "headers", fs::copy_options::recursive);
  config["work"] = work();
  std::ofstream(work() / "grade.json") << config;
  words.insert(words.begin(), {FIRSTLIGHT_GRADE, "--submission", folder_, "--json",
                               folder_ / "results.json", "--config", work() / "grade.json"});
  return words;
}

Outcome Submission::grade_afresh(std::vector<std::string> words) const {
  words.insert(words.begin(), {"--call-limit", "300"});
  return run(command(std::move(words)));
}

}  // namespace grader::self_check
