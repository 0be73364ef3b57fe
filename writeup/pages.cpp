#include "writeup/pages.h"

#include "pt/error.h"
#include "pt/file.h"
#include "pt/image/sample_map.h"
#include "writeup/figure_html.h"
#include "writeup/markdown.h"
#include "writeup/page/sources.h"

#include <algorithm>
#include <chrono>
#include <set>

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <kainjow/mustache.hpp>

namespace writeup {

namespace fs = std::filesystem;
using kainjow::mustache::data;

namespace {

constexpr std::size_t kMaxPage = std::size_t{1} << 22;
constexpr int kStops = 9;  // of the colours of a map

std::string style() {
  std::string colors, css(writeup_css);
  for (int i = 0; i < kStops; ++i) {
    const pt::Color8 color = pt::sample_color(i, 0, kStops - 1);
    colors += fmt::format("{}#{:02x}{:02x}{:02x}", i > 0 ? ", " : "", color[0], color[1], color[2]);
  }
  const std::string mark = "COLORS";
  return css.replace(css.find(mark), mark.size(), colors);
}

struct Page {
  std::string name, title, content;
};

// The first heading of a text.
std::string title_of(const std::string& text, const std::string& name) {
  const std::size_t start = text.find("# ");
  if (start == std::string::npos) return name;
  return text.substr(start + 2, text.find('\n', start) - start - 2);
}

constexpr std::string_view kDrawings = "student/drawings/";  // of the handbook

// Texts link to files of texts and to drawings of the handbook; pages have to link to pages, and to drawings beside them.
std::string with_page_links(std::string html) {
  const std::string drawings = fmt::format("../{}", kDrawings);
  for (std::size_t at = html.find(drawings); at != html.npos; at = html.find(drawings, at)) {
    html.replace(at, drawings.size(), "drawings/");
  }
  for (const std::string& name : page_names()) {
    const std::string text = fmt::format("href=\"{}.md\"", name);
    const std::string page = fmt::format("href=\"{}.html\"", name);
    for (std::size_t at = html.find(text); at != html.npos; at = html.find(text, at + 1)) {
      html.replace(at, text.size(), page);
    }
  }
  return html;
}

// A page of many charts begins with all of them, small; each opens its own place on the page.
std::string contents(const Site& site, const std::set<std::string>& shown) {
  constexpr std::size_t kMany = 12;
  data charts{data::type::list};
  for (const Figure& figure : site.catalogue.figures) {
    const auto found = site.figures.find(figure.id);
    if (!shown.contains(figure.id) || found == site.figures.end()) continue;
    if (found->second.charts.empty()) continue;
    data item;
    item.set("id", figure.id);
    item.set("title", figure.title);
    item.set("chart", found->second.charts[0]);
    charts.push_back(item);
  }
  if (charts.list_value().size() < kMany) return "";
  data out;
  out.set("charts", charts);
  return render(
      "<nav class=\"contents\" aria-label=\"Charts\">{{#charts}}<a href=\"#{{id}}\">"
      "<img src=\"figures/{{chart}}\" alt=\"\" loading=\"lazy\">{{title}}</a>\n{{/charts}}</nav>\n",
      out);
}

Page make_page(const Site& site, const std::string& name, const fs::path& folder) {
  const fs::path file = site.texts / (name + ".md");
  const std::string text = pt::read_file(file, kMaxPage);
  std::set<std::string> shown;
  const Names names{[&](const std::string& id) {
                      const Figure* figure = site.catalogue.find(id);
                      if (figure == nullptr) return std::string();
                      shown.insert(id);
                      return html_of(site, *figure, folder);
                    },
                    [&](const std::string& id) { return number(site, id); }};
  Page page{name, title_of(text, name),
            with_page_links(page_from_text(file.string(), text, names))};
  const std::string part = name.starts_with("part") ? name.substr(4) : name;
  for (const Figure& figure : site.catalogue.figures) {
    if (figure.part == part && !shown.contains(figure.id))
      page.content += html_of(site, figure, folder);
  }
  const std::size_t first = page.content.find("<h2");
  if (first != std::string::npos) page.content.insert(first, contents(site, shown));
  return page;
}

// The command, who ran it where, and the date of the newest figure.
std::string foot(const Site& site, const fs::path& folder) {
  std::string text = "Made by: " + site.command + (site.by.empty() ? "" : " · " + site.by);
  if (!fs::exists(folder / "figures")) return text;
  constexpr fs::file_time_type kNever = fs::file_time_type::min();
  fs::file_time_type newest = kNever;
  for (const fs::directory_entry& file : fs::directory_iterator(folder / "figures")) {
    newest = std::max(newest, file.last_write_time());
  }
  if (newest == kNever) return text;
  const auto time = std::chrono::file_clock::to_sys(newest);
  return text + fmt::format(" · {:%F}", std::chrono::time_point_cast<std::chrono::seconds>(time));
}

std::string short_name(const Page& page) {
  if (page.name == "index") return "Overview";
  const std::size_t colon = page.title.find(": ");
  return colon == std::string::npos ? page.title : page.title.substr(0, colon);
}

}  // namespace

const std::vector<std::string>& page_names() {
  static const std::vector<std::string> names{"index", "part1",    "part2", "part3",     "part4",
                                              "part5", "accuracy", "needs", "stability", "bugs"};
  return names;
}

void write_pages(const Site& site, const fs::path& folder) {
  std::vector<Page> pages;
  for (const std::string& name : page_names()) pages.push_back(make_page(site, name, folder));
  const std::string made = foot(site, folder);
  for (const Page& page : pages) {
    data links{data::type::list};
    for (const Page& other : pages) {
      data item;
      item.set("href", other.name + ".html");
      item.set("name", short_name(other));
      item.set("current", other.name == page.name);
      links.push_back(item);
    }
    data out;
    out.set("title", page.title);
    out.set("pages", links);
    out.set("draft", site.draft);
    out.set("content", page.content);
    out.set("made", made);
    pt::write_file(folder / (page.name + ".html"), render(page_html, out));
  }
  fs::copy(kDrawings, folder / "drawings",
           fs::copy_options::recursive | fs::copy_options::overwrite_existing);
  pt::write_file(folder / "writeup.css", style());
  pt::write_file(folder / "values.js", values_js);
  pt::write_file(folder / "writeup.js", writeup_js);
}

}  // namespace writeup
