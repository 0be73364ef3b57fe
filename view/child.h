#pragma once

#include "grader/base/descriptor.h"
#include "grader/service/sandbox/box.h"
#include "pt/error.h"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>
#include <sys/types.h>

namespace view {

struct Reply {
  nlohmann::json state;
  std::string bytes;
};

// The child crashed, or did not answer in time. The message is one sentence for the page.
struct ChildEnded : pt::Error {
  using pt::Error::Error;
};

// The program that runs the tasks (view/worker/main.cpp).
struct Program {
  std::vector<std::string> command{};
  // For the tasks of a submission: the box, in which it sees the scene. What it prints is not shown, because it can contain
  // anything.
  std::optional<grader::sandbox::Tier> box{};
  std::string scene{};
};

// A lock that is given in the order in which it was asked for. On a busy machine a std::mutex would give it to the next question about
// the picture, again and again, while a click waits.
class InTurn {
 public:
  void lock() {
    std::unique_lock lock(changing_);
    const long mine = last_++;
    changed_.wait(lock, [&] { return now_ == mine; });
  }
  bool try_lock() {
    const std::lock_guard lock(changing_);
    if (now_ != last_) return false;
    ++last_;
    return true;
  }
  void unlock() {
    const std::lock_guard lock(changing_);
    ++now_;
    changed_.notify_all();
  }

 private:
  std::mutex changing_;
  std::condition_variable changed_;
  long now_ = 0, last_ = 0;
};

// Its process. It starts with the first question; if it ends, the next question starts another one.
class Child {
 public:
  // An answer takes a fraction of a second, because pictures come in slices. After `patience` it is not waited for any longer.
  explicit Child(Program program, std::chrono::milliseconds patience = std::chrono::seconds(20))
      : program_(std::move(program)), patience_(patience) {}
  ~Child();
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  // One question at a time; others wait. Throws pt::Error with the child's sentence if the question cannot be answered.
  Reply ask(const std::string& what, const std::map<std::string, std::string>& query);

  // Ends the process, because its program has changed. A question that waits for its answer, perhaps in an endless loop, is
  // answered by the new program.
  void restart();

  // Ends it, even while a question waits for its answer.
  void stop();

 private:
  Reply ask_once(const std::string& question);
  void start();
  int end();
  std::string read_line();
  std::string read_bytes(std::size_t size);
  void fill();

  Program program_;
  std::shared_ptr<const void> held_;  // the user of its box
  std::chrono::milliseconds patience_;
  InTurn one_at_a_time_;
  std::atomic<pid_t> pid_ = -1;
  std::atomic<bool> is_renewed_ = false;  // while a question waited
  grader::base::Descriptor questions_, answers_;
  std::string read_;  // and not used yet
};

}  // namespace view
