#include "grader/results/presentable.h"

#include "grader/results/members.h"
#include "pt/printable.h"

#include <algorithm>
#include <string_view>

#include <fmt/format.h>

namespace grader::results {

namespace {

// Leaves room for the words about the missing bytes.
std::string cut(const std::string& text) {
  const std::string_view kept = pt::beginning(text, kMaxText - 64);
  return std::string(kept) + fmt::format(" ... ({} bytes more)", text.size() - kept.size());
}

template <class T>
void tidy(T&) {}

void tidy(std::string& text) { text = presentable(text); }

template <class T>
void tidy(std::vector<T>& values);

template <class T>
requires requires(T& value) {
  members(value, [](auto&&...) {});
}
void tidy(T& value) {
  members(value, [](const char*, auto& each) { tidy(each); });
}

template <class T>
void tidy(std::vector<T>& values) {
  if (values.size() > kMaxList) values.resize(kMaxList);
  for (T& value : values) tidy(value);
}

}  // namespace

std::string presentable(const std::string& text) {
  const std::string shown = pt::printable(text, true, pt::kReplacement);
  return shown.size() > kMaxText ? cut(shown) : shown;
}

std::string one_line(const std::string& text) {
  std::string line = presentable(text);
  std::ranges::replace_if(
      line, [](char c) { return c == '\n' || c == '\t'; }, ' ');
  return line;
}

Results presentable(Results results) {
  tidy(results);
  for (std::string* name :
       {&results.submission, &results.command, &results.isolation, &results.dialect}) {
    *name = one_line(*name);
  }
  for (TaskResult& task : results.tasks) {
    for (std::string* name : {&task.part, &task.number, &task.slug, &task.called})
      *name = one_line(*name);
    for (PromiseResult& promise : task.promises) promise.name = one_line(promise.name);
    for (PictureResult& picture : task.pictures) picture.recipe = one_line(picture.recipe);
  }
  return results;
}

}  // namespace grader::results
