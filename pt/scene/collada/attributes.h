#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace pt {

// The line, counted from 1, of the first tag with more than `most` attributes, if there is one. tinyxml2 compares
// the attributes of a tag in pairs, and would read a tag of a megabyte for minutes.
std::optional<std::size_t> line_of_too_many_attributes(std::string_view xml, std::size_t most);

}  // namespace pt
