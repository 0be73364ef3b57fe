#pragma once

#include <exception>
#include <string>

#include <nlohmann/json.hpp>

// JSON that comes from a file which somebody may have edited, or a loss of power cut off.

namespace grader::base {

// Throws pt::Error, with the file, the line and what is wrong there, for text that is not JSON.
nlohmann::json parse_json(const std::string& text, const std::string& file);

// The words of an exception, without the number that nlohmann's have in front.
std::string words_of(const std::exception& error);

}  // namespace grader::base
