#pragma once

#include "pt/error.h"

#include <chrono>
#include <map>
#include <string>
#include <vector>

// A submission for the write-up: compiled in the box, linked into a worker, and called there. None
// of its code runs in this process.

namespace measure {

struct Boxed {
  std::string worker;                           // the program
  std::string tier;                             // of the box, a letter
  std::map<std::string, std::string> hash;      // of the content, per task and for "framework"
  std::map<std::string, std::string> unusable;  // tasks that do not compile, each with the reason
};

// A fault of a submission: a crash, an endless loop, messages that break the protocol.
struct SubmissionFailed : pt::Error {
  using pt::Error::Error;
};

// Throws pt::Error if a submission cannot be built. "" is the reference, built like a submission. `parts` is the file with the other parts of the worker
// (worker_config.h). With `only`, it has only these tasks of the submission, which have to compile.
Boxed build_submission(const std::string& submission,
                       const std::string& parts = "writeup_boxed.json",
                       const std::vector<std::string>& only = {});
void write_boxed(const Boxed& boxed, const std::string& file);  // as JSON
Boxed read_boxed(const std::string& file);

// Opens the session of this program with the worker, which renders the rows from then on (rows.h). Its
// calls throw SubmissionFailed. A worker that was opened before is still there, and goes on.
void open_worker(const Boxed& boxed, std::chrono::milliseconds call_limit);

}  // namespace measure
