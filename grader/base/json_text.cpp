#include "grader/base/json_text.h"

#include "grader/base/printable.h"
#include "pt/error.h"

#include <algorithm>
#include <string_view>

#include <fmt/format.h>

namespace grader::base {

nlohmann::json parse_json(const std::string& text, const std::string& file) {
  try {
    return nlohmann::json::parse(text);
  } catch (const nlohmann::json::parse_error& error) {
    const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(error.byte, text.size()));
    const std::string words = words_of(error);
    const std::size_t reason = words.find("syntax error");
    throw pt::Error(fmt::format("{}:{}: this is not JSON ({}); correct it here or just before",
                                file, 1 + std::count(text.begin(), end, '\n'),
                                reason == std::string::npos ? words : words.substr(reason)));
  } catch (const nlohmann::json::exception& error) {  // a number that no double holds
    throw pt::Error(fmt::format("{}: {}; write another number", file, words_of(error)));
  }
}

std::string words_of(const std::exception& error) {
  const std::string_view what = error.what();
  const std::size_t end = what.starts_with("[json.") ? what.find("] ") : what.npos;
  return printable(end == what.npos ? what : what.substr(end + 2), 300);
}

}  // namespace grader::base
