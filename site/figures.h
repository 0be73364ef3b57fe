#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace site {

// A figure that calls the reference while it is read (site/page/figures/<name>.js). It stands at the end of a section.
struct LiveFigure {
  std::string name, page, section;  // the page's path in the project, and the id of a heading
  std::string title, text;          // what to try, and what to see
  std::string still, alt;  // a picture for browsers without WebAssembly: its path in the project
};
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(LiveFigure, name, page, section, title, text, still, alt)

std::vector<LiveFigure> read_figures(const std::filesystem::path& file);

// The page's HTML with the figures of this page, and their scripts at its end. `up` leads from the page to the site's root. Without
// `is_live` each figure is its still picture. Throws pt::Error if a page has no such section.
std::string with_figures(std::string html, const std::string& page, const std::string& up,
                         const std::vector<LiveFigure>& figures, bool is_live);

}  // namespace site
