#include "view/page.h"

#include "grader/report/filled.h"
#include "grader/report/page/sources.h"
#include "pt/error.h"
#include "pt/image/exr.h"

#include <cstring>
#include <vector>

namespace view {

pt::Film film_of(const Reply& reply) {
  const int width = reply.state.at("width"), height = reply.state.at("height");
  std::vector<float> values(reply.bytes.size() / sizeof(float));
  const bool is_whole = width > 0 && height > 0 && reply.bytes.size() % (3 * sizeof(float)) == 0 &&
                        values.size() / 3 == static_cast<std::size_t>(width) * height;
  if (!is_whole) throw pt::Error("the picture of the tasks is not whole");
  pt::Film film(width, height);
  std::memcpy(values.data(), reply.bytes.data(), reply.bytes.size());
  for (std::size_t i = 0; i < film.pixels.size(); ++i) {
    film.pixels[i].mean = {values[3 * i], values[3 * i + 1], values[3 * i + 2]};
  }
  return film;
}

std::string exr_of(const Reply& reply) { return encode_exr(film_of(reply)); }

std::string page_with(const nlohmann::json& data) {
  std::string text = data.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
  // No text in the data can end the script that it is in.
  for (std::size_t at = text.find('<'); at != std::string::npos; at = text.find('<', at)) {
    text.replace(at, 1, "\\u003c");
  }
  std::string script;
  for (const std::string_view part : {picture_js, scene_js, paths_js, tree_js, samples_js, disk_js,
                                      zoom_js, asking_js, keys_js, view_js}) {
    script += part;
  }
  kainjow::mustache::data fields;
  fields.set("css", std::string(grader::report::page_css) + std::string(view_css));
  fields.set("script", script);
  fields.set("data", text);
  return grader::report::filled(view_html, std::move(fields));
}

}  // namespace view
