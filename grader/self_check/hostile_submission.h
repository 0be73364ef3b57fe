#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace grader::self_check {

// The outcome of grading a submission.
struct Outcome {
  int exit_status = -1;
  std::string output;
  nlohmann::json results;  // null if there are none

  const nlohmann::json& task(const std::string& slug) const;
  std::string state(const std::string& slug) const;
};

// The environment of the judge in these tests.
std::vector<std::string> environment();

// A limit for calls that take long only on a busy machine, in milliseconds.
inline constexpr int kCallLimit = 10000;

// A submission in a folder of its own: the reference, with other files put over it. Everything goes
// with this object.
class Submission {
 public:
  explicit Submission(const std::string& name);
  ~Submission();
  Submission(const Submission&) = delete;
  Submission& operator=(const Submission&) = delete;

  std::filesystem::path operator/(const std::string& path) const { return folder_ / path; }

  // The path of a task's file.
  std::filesystem::path file_of(const std::string& slug) const;
  // Puts the solution, a file, in the place of the task's.
  void replace(const std::string& slug, const std::filesystem::path& solution) const;

  // The files of hostile/<batch>, in which @ROOT@, @SUBMISSION@ and @WORK@ are the places where the
  // project, the submission and the judge's own files are, and @RAW@ is hostile/raw.h. Returns the
  // slugs.
  std::vector<std::string> put(const std::string& batch);

  // `words` for grade: tasks and options; milliseconds that a call may take.
  Outcome grade(std::vector<std::string> words = {}, int call_limit = 1000) const;

  // The same with a folder of its own for what the judge builds and knows, new and empty but for
  // compiled headers.
  Outcome grade_afresh(std::vector<std::string> words) const;
  // The command for that, not run.
  std::vector<std::string> command(std::vector<std::string> words) const;
  std::filesystem::path work() const { return folder_.string() + ".work"; }
  // Runs it, or the same with more words before it.
  Outcome run(const std::vector<std::string>& command) const;

 private:
  std::filesystem::path folder_;
};

// The whole file.
std::string text_of(const std::filesystem::path& path);

}  // namespace grader::self_check
