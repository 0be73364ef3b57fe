#pragma once

#include "grader/check/generators/special.h"
#include "grader/check/language/property.h"

#include <functional>
#include <utility>
#include <vector>

namespace grader::check {

// Cases of one kind, each with the answers that are right for it. A case is drawn as one value, so
// that a failure shows the case that failed.
template <class Case>
struct Cases : rc::Gen<Case> {
  Cases(rc::Gen<Case> made) : rc::Gen<Case>(std::move(made)) {}  // NOLINT: every generator is one

  // The cases after a change, which may draw.
  template <class Change>
  Cases with(const Change& change) const {
    return rc::gen::exec([made = rc::Gen<Case>(*this), change] { return change(*made); });
  }
};

// Judges cases one by one.
template <class Case, class Judge>
void all(const Cases<Case>& cases, const Judge& judge, int count = 100) {
  for_all([&] { judge(*cases); }, count);
}

// The same, each after a call with the case as `other` returns it: that call is forgotten.
template <class Case, class Judge>
void all_after_another(const Cases<Case>& cases, Case (*other)(Case), const Judge& judge,
                       int count = 100) {
  for_all(
      [&] {
        const auto [before, now] = *in_turn(rc::Gen<Case>(cases), other);
        call(before);
        judge(now);
      },
      count);
}

// Changes of a case. Each of them leaves something as it was that a task could remember the case by.
template <class Case>
using OtherCases = std::vector<std::function<void(Case&)>>;

// Judges cases, some of them after a call with the same case after each of the changes.
template <class Case, class Judge>
void all_after_each(const Cases<Case>& cases, const OtherCases<Case>& changes, const Judge& judge,
                    int count = 2) {
  for (const auto& change : changes) {
    if (testing::Test::HasFailure()) return;
    for_all(
        [&] {
          const auto [before, now] = *in_turn(rc::Gen<Case>(cases), [&](Case c) {
            change(c);
            return c;
          });
          call(before);
          judge(now);
        },
        count);
  }
}

}  // namespace grader::check
