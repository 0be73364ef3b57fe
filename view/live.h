#pragma once

#include "view/child.h"

#include <atomic>
#include <filesystem>
#include <future>

namespace view {

// Compiles the tasks again whenever one of their files is saved, and ends the child, so that the next question starts the new program.
class Live {
 public:
  // The files are below `tasks`; the command compiles them.
  Live(std::filesystem::path tasks, std::vector<std::string> command, Child& child);
  ~Live() { is_over_ = true; }

  struct State {
    int saves = 0;      // that have been compiled
    std::string error;  // of the last one: the compiler's first error, or empty
  };
  State state();

 private:
  void watch();
  void compile();

  std::filesystem::path tasks_;
  std::vector<std::string> command_;
  Child& child_;
  std::mutex reading_;
  State state_;
  std::atomic<bool> is_over_ = false;
  std::future<void> watching_;  // waits for its end
};

}  // namespace view
