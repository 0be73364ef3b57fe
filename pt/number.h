#pragma once

#include <charconv>
#include <locale>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <system_error>
#include <type_traits>

namespace pt {

// The number that is written in the text, with a point whatever the language of the system; nothing if there is more in the text, or
// if the number does not fit.
template <class Number>
std::optional<Number> number_in(std::string_view text) {
  Number number{};
#ifndef __cpp_lib_to_chars  // the library of clang before 20, and so Xcode: from_chars reads integers only
  if constexpr (std::is_floating_point_v<Number>) {
    std::istringstream in{std::string(text)};
    in.imbue(std::locale::classic());
    const bool is_plain = !text.empty() && text.find_first_of("+ \t\r\n") != 0 &&
                          text.find_first_of("xX") == text.npos;
    const bool is_number = is_plain && in >> number && in.peek() == std::char_traits<char>::eof();
    return is_number ? std::optional(number) : std::nullopt;
  } else
#endif
  {
    const char* const end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, number);
    return error == std::errc{} && rest == end ? std::optional(number) : std::nullopt;
  }
}

}  // namespace pt
