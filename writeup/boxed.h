#pragma once

#include "pt/error.h"

#include <chrono>
#include <map>
#include <string>

// A submission that is measured by the write-up: compiled in the box, linked into a worker, and called
// there. No line of it runs in this process.

namespace writeup {

struct Boxed {
  std::string worker;                           // the program
  std::string tier;                             // of the box: a letter
  std::map<std::string, std::string> hash;      // of the content, by task and "framework"
  std::map<std::string, std::string> unusable;  // tasks that do not compile, each with the reason
};

// The fault of a submission: a crash, an endless loop, words that are not those of the protocol.
struct SubmissionFailed : pt::Error {
  using pt::Error::Error;
};

// Throws pt::Error where a submission cannot be built.
Boxed build_submission(const std::string& submission);
void write_boxed(const Boxed& boxed, const std::string& file);  // as JSON
Boxed read_boxed(const std::string& file);

// Opens the session of this program with the worker. Calls throw SubmissionFailed from then on.
void open_worker(const std::string& worker, const std::string& tier,
                 std::chrono::milliseconds call_limit);

// Processor seconds of this process and the worker, so far.
double worker_seconds();

}  // namespace writeup
