#include "grader/service/audit/may_call.h"

#include <algorithm>

namespace grader::audit {

namespace {

bool is_of(const Task& task, std::string_view function) {
  return std::ranges::any_of(task.functions,
                             [&](const std::string& name) { return function == "pt::" + name; });
}

}  // namespace

// Functions that a stub calls are allowed too: a finished file may keep the call.
bool may_call(const Task& task, std::string_view function) {
  return function == "pt::todo" || std::ranges::count(task.framework, function) > 0 ||
         std::ranges::any_of(
             task.calls, [&](const std::string& slug) { return is_of(task_of(slug), function); });
}

std::string may_call_in_words(const Task& task) {
  std::vector<std::string> all = task.calls;
  all.insert(all.end(), task.framework.begin(), task.framework.end());
  if (all.empty()) {
    return task.slug + " may call no other task and no function of the renderer";
  }
  std::string text = task.slug + " may only call ";
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (i > 0) text += i + 1 == all.size() ? " and " : ", ";
    text += all[i];
  }
  return text;
}

}  // namespace grader::audit
