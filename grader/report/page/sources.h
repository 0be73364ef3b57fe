#pragma once

#include <string_view>

// The files of this folder, as the build embeds them (cmake/embed.cmake).

namespace grader::report {

extern const std::string_view head_html;  // the beginning of every page
extern const std::string_view page_html;  // a template in Mustache
extern const std::string_view page_css;
extern const std::string_view page_js;

}  // namespace grader::report
