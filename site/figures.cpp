#include "site/figures.h"

#include "pt/error.h"
#include "pt/file.h"
#include "writeup/markdown.h"

#include <algorithm>

#include <fmt/format.h>

namespace site {

using writeup::escaped;

namespace {

std::string html_of(const LiveFigure& figure, const std::string& up, bool is_live) {
  const std::string still = fmt::format("<img class=\"still\" src=\"{}{}\" alt=\"{}\">", up,
                                        figure.still, escaped(figure.alt));
  const std::string stage =
      is_live ? fmt::format("<div class=\"stage\"></div><noscript>{}</noscript>", still) : still;
  const std::string note =
      is_live ? "" : " (This copy of the site was built without its live figures.)";
  return fmt::format(
      "<figure class=\"live\" id=\"live-{0}\" data-figure=\"{0}\" data-still=\"{1}{2}\" "
      "data-alt=\"{3}\">\n"
      "<h3 class=\"name\">{4}</h3>\n{5}\n<figcaption>{6}{7}</figcaption></figure>\n",
      figure.name, up, figure.still, escaped(figure.alt), escaped(figure.title), stage,
      escaped(figure.text), note);
}

// Where the section with this heading ends: at the next heading.
std::size_t end_of_section(const std::string& html, const LiveFigure& figure) {
  const std::size_t start = html.find(fmt::format(" id=\"{}\"", figure.section));
  if (start == html.npos) {
    throw pt::Error(fmt::format("site/figures.json: {} has no section '{}' for the figure {}",
                                figure.page, figure.section, figure.name));
  }
  std::size_t end = html.size();
  for (const char* heading : {"<h1 ", "<h2 ", "<h3 "}) {
    end = std::min(end, html.find(heading, start));
  }
  return end;
}

}  // namespace

std::vector<LiveFigure> read_figures(const std::filesystem::path& file) {
  return nlohmann::json::parse(pt::read_file(file)).get<std::vector<LiveFigure>>();
}

std::string with_figures(std::string html, const std::string& page, const std::string& up,
                         const std::vector<LiveFigure>& figures, bool is_live) {
  std::string scripts;
  for (const LiveFigure& figure : figures) {
    if (figure.page != page) continue;
    html.insert(end_of_section(html, figure), html_of(figure, up, is_live));
    scripts += fmt::format("<script src=\"{}site/figures/{}.js\"></script>\n", up, figure.name);
  }
  if (!is_live || scripts.empty()) return html;
  return html +
         fmt::format(
             "<script src=\"{0}site/reference.js\"></script>\n"
             "<script src=\"{0}site/live.js\"></script>\n",
             up) +
         scripts;
}

}  // namespace site
