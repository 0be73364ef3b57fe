#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace pt {

// XML in UTF-16, of either byte order, as UTF-8; nothing for other text. Such a file begins with a
// byte order mark or with "<". A unit that belongs to no character becomes U+FFFD, and half a unit
// at the end is left out.
std::optional<std::string> utf8_from_utf16(std::string_view bytes);

}  // namespace pt
