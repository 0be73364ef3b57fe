#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace pt {

// The line of the first tag with more than `most` attributes, counted from 1; nothing where there is none. tinyxml2
// compares the attributes of a tag in pairs, and would read one of a megabyte for minutes.
std::optional<std::size_t> line_of_too_many_attributes(std::string_view xml, std::size_t most);

}  // namespace pt
