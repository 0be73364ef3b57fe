#pragma once

#include "grader/base/printable.h"
#include "grader/report/status_line.h"
#include "grader/results/presentable.h"
#include "grader/results/summary.h"
#include "grader/service/classes/one.h"

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace grader::classes {

// The first few of many names, safe to print.
inline std::string some_of(const std::vector<std::string>& names) {
  constexpr std::size_t kMaxNamed = 5, kMaxBytes = 100;
  std::string text;
  for (std::size_t i = 0; i < std::min(names.size(), kMaxNamed); ++i) {
    text += (i == 0 ? "" : ", ") + base::printable(names[i], kMaxBytes);
  }
  return names.size() > kMaxNamed ? text + ", ..." : text;
}

// Prints each outcome, and shows how long the rest will take.
class OutcomePrinter {
 public:
  OutcomePrinter(std::size_t all, report::StatusLine& line) : all_(all), line_(line) { show(); }

  void print(const Graded& graded) {
    line_.clear();
    fmt::print("{}/{} {}: {}{}\n", ++count_, all_, results::one_line(graded.by.name),
               graded.problem.empty() ? results::verdict(graded.results)
                                      : results::one_line(graded.problem),
               graded.again && graded.problem.empty() ? " (as before)" : "");
    std::fflush(stdout);
    all_judged_ = all_judged_ && (graded.problem.empty() || graded.by.absent);
    if (graded.again) ++known_;
    show();
  }
  bool all_judged() const { return all_judged_; }

 private:
  // A verdict that was known already takes no time, so it predicts nothing.
  void show() const {
    const double part = static_cast<double>(count_ - known_) / static_cast<double>(all_ - known_);
    line_.show(fmt::format("judging: {} of {} submissions", count_, all_), part);
  }

  std::size_t all_, count_ = 0, known_ = 0;
  bool all_judged_ = true;
  report::StatusLine& line_;
};

}  // namespace grader::classes
