#include "view/page.h"

#include "grader/report/filled.h"
#include "grader/report/page/sources.h"

namespace view {

std::string page_with(const nlohmann::json& data) {
  std::string text = data.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
  // No text in the data can end the script that it is in.
  for (std::size_t at = text.find('<'); at != std::string::npos; at = text.find('<', at)) {
    text.replace(at, 1, "\\u003c");
  }
  std::string script;
  for (const std::string_view part : {picture_js, scene_js, paths_js, view_js}) script += part;
  kainjow::mustache::data fields;
  fields.set("css", std::string(grader::report::page_css) + std::string(view_css));
  fields.set("script", script);
  fields.set("data", text);
  return grader::report::filled(view_html, std::move(fields));
}

}  // namespace view
