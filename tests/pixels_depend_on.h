#pragma once

#include "grader/tasks.h"

#include <algorithm>
#include <string>

// A task of the course has a part in making pictures: it calls other tasks, is called by one, or traces rays. One
// that does neither is judged by its properties alone.

namespace grader {

inline bool pixels_depend_on(const std::string& slug) {
  const auto calls = [&](const Task& task) {
    return std::ranges::count(needs(task.slug), slug) > 0;
  };
  return !needs(slug).empty() || std::ranges::any_of(tasks(), calls);
}

}  // namespace grader
