#pragma once

#include "pt/image/film.h"
#include "view/child.h"

#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

namespace view {

// The files of page/, as the build embeds them (cmake/embed.cmake).
extern const std::string_view view_html;
extern const std::string_view view_css;
extern const std::string_view picture_js;
extern const std::string_view scene_js;
extern const std::string_view paths_js;
extern const std::string_view tree_js;
extern const std::string_view samples_js;
extern const std::string_view disk_js;
extern const std::string_view zoom_js;
extern const std::string_view asking_js;
extern const std::string_view keys_js;
extern const std::string_view view_js;

// The floats of a picture's reply, as they are or as the bytes of an EXR file. Throws pt::Error if they are not whole.
pt::Film film_of(const Reply& reply);
std::string exr_of(const Reply& reply);

// The page as one file. `data` says what it shows (view/page/view.js): with `live`, it asks the server; else it holds the answers.
std::string page_with(const nlohmann::json& data);

}  // namespace view
