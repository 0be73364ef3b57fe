#pragma once

#include "grader/service/build/config.h"
#include "grader/service/intake/prepare_submission.h"

#include <string>

namespace grader::intake {

// The task files of a submission that a command names: a folder or an archive, in which they may be
// anywhere, or a clone of the course's skeleton. They are copied where that is needed, and the copies
// live as long as this object.
class TakenIn {
 public:
  // Throws pt::Error if the machine is at fault.
  TakenIn(const build::Config& config, const std::string& submission);
  ~TakenIn();
  TakenIn(const TakenIn&) = delete;
  TakenIn& operator=(const TakenIn&) = delete;

  const Prepared& found() const { return found_; }
  bool is_copied() const { return folders_ > 0; }
  // The folder in which the judge finds the files. Throws pt::Error if there is none, with the reason.
  const std::string& folder() const;

 private:
  explicit TakenIn(std::string work) : work_(std::move(work)) {}

  std::string work_;
  int folders_ = 0;
  Prepared found_;
};

}  // namespace grader::intake
