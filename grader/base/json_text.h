#pragma once

#include <exception>
#include <string>

#include <nlohmann/json.hpp>

// Reads JSON from files that somebody may have edited, or that a loss of power may have cut off.

namespace grader::base {

// Throws pt::Error, with the file, the line and what is wrong there, for text that is not JSON.
nlohmann::json parse_json(const std::string& text, const std::string& file);

// The message of an exception, without the error number with which nlohmann's messages begin.
std::string words_of(const std::exception& error);

}  // namespace grader::base
