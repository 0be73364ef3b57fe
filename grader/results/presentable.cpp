#include "grader/results/presentable.h"

#include "grader/results/members.h"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace grader::results {

namespace {

using nlohmann::json;

constexpr const char* kReplacement = "\xef\xbf\xbd";

// Every sequence that is not UTF-8 replaced, which the JSON library does.
std::string valid_utf8(const std::string& text) {
  return json::parse(json(text).dump(-1, ' ', false, json::error_handler_t::replace));
}

std::size_t sequence_length(unsigned char first) {
  return first < 0x80 ? 1 : first < 0xe0 ? 2 : first < 0xf0 ? 3 : 4;
}

bool is_shown(std::string_view sequence) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(sequence[i]); };
  if (sequence.size() == 1) {
    return sequence == "\n" || sequence == "\t" || (byte(0) >= 0x20 && byte(0) != 0x7f);
  }
  if (sequence.size() == 2) return byte(0) != 0xc2 || byte(1) >= 0xa0;  // U+0080..U+009F
  if (sequence.size() == 3) {
    const int code = (byte(0) & 15) << 12 | (byte(1) & 63) << 6 | (byte(2) & 63);
    const bool turns = (code >= 0x202a && code <= 0x202e) || (code >= 0x2066 && code <= 0x2069);
    return !turns && code < 0xfffe;
  }
  return true;
}

// With room for the words that say what is missing.
std::string beginning(const std::string& text) {
  std::size_t end = kMaxText - 64;
  while ((static_cast<unsigned char>(text[end]) & 0xc0) == 0x80) --end;
  return text.substr(0, end) + fmt::format(" ... ({} bytes more)", text.size() - end);
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
  const std::string valid = valid_utf8(text);
  std::string shown;
  shown.reserve(valid.size());
  for (std::size_t i = 0; i < valid.size();) {
    const std::size_t length = sequence_length(static_cast<unsigned char>(valid[i]));
    const std::string_view sequence = std::string_view(valid).substr(i, length);
    shown += is_shown(sequence) ? sequence : kReplacement;
    i += length;
  }
  return shown.size() > kMaxText ? beginning(shown) : shown;
}

std::string one_line(const std::string& text) {
  std::string line = presentable(text);
  std::ranges::replace_if(
      line, [](char c) { return c == '\n' || c == '\t'; }, ' ');
  return line;
}

Results presentable(Results results) {
  tidy(results);
  for (std::string* name : {&results.submission, &results.command, &results.isolation}) {
    *name = one_line(*name);
  }
  for (TaskResult& task : results.tasks) {
    for (std::string* name : {&task.part, &task.number, &task.slug}) *name = one_line(*name);
    for (PromiseResult& promise : task.promises) promise.name = one_line(promise.name);
    for (PictureResult& picture : task.pictures) picture.recipe = one_line(picture.recipe);
  }
  return results;
}

}  // namespace grader::results
