#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <kainjow/mustache.hpp>

namespace grader::report {

// A template of page/, filled with the data; {{>head}} is head.html. Throws pt::Error if it is not a
// template.
std::string filled(std::string_view page, kainjow::mustache::data data);

// Sets a text, and whether there is any: has_<key>.
void set_text(kainjow::mustache::data& out, const std::string& key, const std::string& text);

// Sets a list of objects with one member, `key`. `list` is its name in the template.
void set_texts(kainjow::mustache::data& out, const std::string& list, const std::string& key,
               const std::vector<std::string>& texts);

// A file's name as a relative address in a page: "a%2C%20flat.html".
std::string address_of(const std::string& file);

}  // namespace grader::report
