#pragma once

#include "writeup/pages.h"

#include <filesystem>
#include <string>
#include <string_view>

#include <kainjow/mustache.hpp>

namespace writeup {

// Fills in a template of page/. Throws pt::Error if the template is wrong.
std::string render(std::string_view source, const kainjow::mustache::data& values);

// The number FIGURE.NAME: as measured, a dash if it was not measured, "" if no figure has it.
std::string number(const Site& site, const std::string& name);

// A figure of a page in the folder, with its pictures, charts, table and files. In the place of
// a part that has not been made stands a sentence.
std::string html_of(const Site& site, const Figure& figure, const std::filesystem::path& folder);

}  // namespace writeup
