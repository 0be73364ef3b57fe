#pragma once

#include "grader/door/dialect.h"
#include "grader/programs/grade_options.h"
#include "grader/service/build/config.h"
#include "grader/service/intake/prepare_submission.h"

#include <optional>
#include <string>

namespace grader::programs {

// The files of a submission that was named, wherever they are in it: as for a class. The folder
// student/ is read as it is.
class Intake {
 public:
  // Throws pt::Error if the machine is at fault.
  Intake(const build::Config& config, const GradeOptions& options);
  ~Intake();  // removes the copies
  Intake(const Intake&) = delete;
  Intake& operator=(const Intake&) = delete;

  const intake::Prepared& found() const { return found_; }
  bool is_copied() const { return folders_ > 0; }
  // Of a clone of the course: what the course asks for.
  const std::optional<door::Dialect>& dialect() const { return dialect_; }

 private:
  explicit Intake(std::string work) : work_(std::move(work)) {}
  void take_clone(const build::Config& config, const GradeOptions& options);
  std::string next_folder() { return work_ + "/" + std::to_string(++folders_); }

  std::string work_;
  int folders_ = 0;
  intake::Prepared found_;
  std::optional<door::Dialect> dialect_;
};

}  // namespace grader::programs
