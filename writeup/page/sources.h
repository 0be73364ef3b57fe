#pragma once

#include <string_view>

// The files of this folder, which the build puts into the program.

namespace writeup {

extern const std::string_view page_html, figure_html;  // templates in Mustache
extern const std::string_view values_js, writeup_css, writeup_js;

}  // namespace writeup
