#pragma once

#include "pt/math/rgb.h"
#include "pt/math/vec3.h"
#include "pt/scene/collada/document.h"

#include <optional>
#include <vector>

namespace pt {

// The numbers in elements, separated by white space. All functions throw Error, with the element's
// line, for text that is not a number, for numbers that are not finite, and for too few or too many
// numbers.

std::vector<double> read_numbers(const Document& document, const XMLElement& element);
std::vector<double> read_numbers(const Document& document, const XMLElement& element,
                                 std::size_t count);
std::vector<int> read_integers(const Document& document, const XMLElement& element);

double read_number(const Document& document, const XMLElement& element);

// The number in a child of the element; nothing if it is missing.
std::optional<double> child_number(const Document& document, const XMLElement& parent,
                                   const char* name);

// Three or four numbers, none negative. The fourth (alpha) is ignored.
Rgb read_color(const Document& document, const XMLElement& element);

// An attribute that is an integer >= 0; nothing if it is missing.
std::optional<std::size_t> read_count(const Document& document, const XMLElement& element,
                                      const char* name);

// A number as a message shows it: 0.8, 10, 1e-07; and three of them.
std::string shown(double value);
std::string shown(Rgb color);

}  // namespace pt
