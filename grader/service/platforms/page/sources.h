#pragma once

#include <string_view>

// The files of this folder, as the build embeds them (cmake/embed.cmake).

namespace grader::platforms {

extern const std::string_view class_html;  // a template, with page_css of grader/report/page
extern const std::string_view class_js;
extern const std::string_view compare_html;   // a template, with page_css of grader/report/page
extern const std::string_view likeness_html;  // the same

}  // namespace grader::platforms
