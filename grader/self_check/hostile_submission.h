#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace grader {

// What came of grading a submission.
struct Outcome {
  int exit_status = -1;
  std::string output;
  nlohmann::json results;  // null if there are none

  const nlohmann::json& task(const std::string& slug) const;
  std::string state(const std::string& slug) const;
};

// A submission in a folder of its own: the reference, with other files put over it. Everything goes
// with this object.
class Submission {
 public:
  explicit Submission(const std::string& name);
  ~Submission();
  Submission(const Submission&) = delete;
  Submission& operator=(const Submission&) = delete;

  std::filesystem::path operator/(const std::string& path) const { return folder_ / path; }

  // The files of hostile/<batch>, in which @ROOT@, @SUBMISSION@ and @WORK@ are the places where the
  // project, the submission and the judge's own files are, and @RAW@ is hostile/raw.h. Returns the
  // slugs.
  std::vector<std::string> put(const std::string& batch);

  // `words` for grade: tasks and options. It is given two minutes.
  Outcome grade(std::vector<std::string> words = {}) const;

  // The same with a folder of its own for what the judge builds and knows, new and empty.
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

}  // namespace grader
