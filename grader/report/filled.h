#pragma once

#include <string>
#include <string_view>

#include <kainjow/mustache.hpp>

namespace grader::report {

// A template of page/, filled with the data; {{>head}} is head.html. Throws pt::Error if it is not a
// template.
std::string filled(std::string_view page, kainjow::mustache::data data);

// A file's name as a relative address in a page: "a%2C%20flat.html".
std::string address_of(const std::string& file);

}  // namespace grader::report
