#pragma once

#include <string>

namespace grader::report {

// A file's name as a relative address in a page: "a%2C%20flat.html".
std::string address_of(const std::string& file);

}  // namespace grader::report
