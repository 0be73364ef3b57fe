#include "writeup/pages.h"

#include "pt/error.h"
#include "pt/file.h"
#include "pt/image/sample_map.h"
#include "writeup/figure_html.h"
#include "writeup/markdown.h"
#include "writeup/page/sources.h"

#include <algorithm>
#include <chrono>
#include <regex>
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

// The part of the catalogue that stands on a page.
std::string part_of(const std::string& page) {
  return page.starts_with("part") ? page.substr(4) : page;
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

// Small pictures with a title below, each of which opens its place.
struct Entry {
  std::string href, image, title;
};
std::string contents(const std::string& about, const std::vector<Entry>& entries) {
  data list{data::type::list}, out;
  for (const Entry& entry : entries) {
    data item;
    item.set("href", entry.href);
    item.set("image", entry.image);
    item.set("title", entry.title);
    list.push_back(item);
  }
  out.set("about", about);
  out.set("entries", list);
  return render(
      "<nav class=\"contents\" aria-label=\"{{about}}\">{{#entries}}<a href=\"{{href}}\">"
      "<img src=\"figures/{{image}}\" alt=\"\" "
      "loading=\"lazy\">{{title}}</a>\n{{/entries}}</nav>\n",
      out);
}

// A page of many charts begins with all of them.
std::string charts_of(const Site& site, const std::set<std::string>& shown) {
  constexpr std::size_t kMany = 12;
  std::vector<Entry> charts;
  for (const Figure& figure : site.catalogue.figures) {
    const auto found = site.figures.find(figure.id);
    if (!shown.contains(figure.id) || found == site.figures.end()) continue;
    if (found->second.charts.empty()) continue;
    charts.push_back({"#" + figure.id, found->second.charts[0], figure.title});
  }
  return charts.size() < kMany ? "" : contents("Charts", charts);
}

// The first chart or picture of a page's first figure that has one.
std::string image_of(const Site& site, const std::string& page) {
  for (const Figure& figure : site.catalogue.figures) {
    const auto found = site.figures.find(figure.id);
    if (part_of(page) != figure.part || found == site.figures.end()) continue;
    const Drawn& drawn = found->second;
    if (!drawn.charts.empty()) return drawn.charts[0];
    for (const Shown& shown : drawn.pictures) {
      if (!shown.file.empty()) return shown.file + ".png";
    }
  }
  return "";
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
  const std::string part = part_of(name);
  for (const Figure& figure : site.catalogue.figures) {
    if (figure.part == part && !shown.contains(figure.id))
      page.content += html_of(site, figure, folder);
  }
  const std::size_t first = page.content.find("<h2");
  if (first != std::string::npos) page.content.insert(first, charts_of(site, shown));
  return page;
}

// "To cite: ...", by CITATION.cff, which a handout does not have.
std::string citation() {
  const fs::path file = "CITATION.cff";
  if (!fs::exists(file)) return "";
  const std::string text = pt::read_file(file, kMaxPage);
  const auto field = [&](const char* name) {
    const std::regex line(fmt::format("\n *(?:- )?{}: \"?([^\"\n]*)", name));
    std::smatch found;
    return std::regex_search(text, found, line) ? found.str(1) : std::string();
  };
  return fmt::format(" · To cite: {}, {}, version {} (CITATION.cff)", field("name"), field("title"),
                     field("version"));
}

// " · " and the date of the newest figure; empty if there is none.
std::string date_of(const fs::path& figures) {
  if (!fs::exists(figures)) return "";
  constexpr fs::file_time_type kNever = fs::file_time_type::min();
  fs::file_time_type newest = kNever;
  for (const fs::directory_entry& file : fs::directory_iterator(figures)) {
    newest = std::max(newest, file.last_write_time());
  }
  if (newest == kNever) return "";
  const auto time = std::chrono::file_clock::to_sys(newest);
  return fmt::format(" · {:%F}", std::chrono::time_point_cast<std::chrono::seconds>(time));
}

// The command, who ran it where, when, and what to cite.
std::string foot(const Site& site, const fs::path& folder) {
  return "Made by: " + site.command + (site.by.empty() ? "" : " · " + site.by) +
         date_of(folder / "figures") + citation();
}

// The front page has a picture of each page, above its table.
void add_pictures(const Site& site, std::vector<Page>& pages) {
  std::vector<Entry> entries;
  for (const Page& page : pages) {
    const std::string image = image_of(site, page.name);
    if (!image.empty()) entries.push_back({page.name + ".html", image, page.title});
  }
  std::string& front = pages[0].content;
  if (!entries.empty()) {
    front.insert(std::min(front.find("<table"), front.size()), contents("Pages", entries));
  }
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
  add_pictures(site, pages);
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
