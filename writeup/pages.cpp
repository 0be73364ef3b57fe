#include "writeup/pages.h"

#include "pt/error.h"
#include "pt/file.h"
#include "pt/image/sample_map.h"
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
using kainjow::mustache::mustache;

namespace {

constexpr std::size_t kMaxPage = std::size_t{1} << 22;
constexpr std::size_t kMaxChart = std::size_t{1} << 24;
constexpr int kStops = 9;  // of the colours of a map

std::string render(std::string_view source, const data& values) {
  mustache page{std::string(source)};
  std::string text = page.render(values);
  if (!page.is_valid()) throw pt::Error("a page cannot be made: " + page.error_message());
  return text;
}

std::string style() {
  std::string colors, css(writeup_css);
  for (int i = 0; i < kStops; ++i) {
    const pt::Color8 color = pt::sample_color(i, 0, kStops - 1);
    colors += fmt::format("{}#{:02x}{:02x}{:02x}", i > 0 ? ", " : "", color[0], color[1], color[2]);
  }
  const std::string mark = "COLORS";
  return css.replace(css.find(mark), mark.size(), colors);
}

data texts(const std::vector<std::string>& words) {
  data list{data::type::list};
  for (const std::string& word : words) {
    data item;
    item.set("text", word);
    list.push_back(item);
  }
  return list;
}

data picture_data(const Shown& shown) {
  data out;
  out.set("file", shown.file.empty() ? data(false) : data(shown.file));
  out.set("kind", shown.kind);
  out.set("width", std::to_string(shown.width));
  out.set("height", std::to_string(shown.height));
  out.set("label", shown.label);
  out.set("facts", shown.facts);
  out.set("note", shown.note);
  out.set("warn", !shown.note.empty() && !shown.file.empty());
  out.set("legend", shown.kind == "map");
  out.set("low", shown.low);
  out.set("high", shown.high);
  return out;
}

data link(const std::string& file, const char* ending) {
  data out;
  out.set("link", file + ending);
  out.set("ending", ending);
  return out;
}

data files_data(const Drawn& drawn) {
  data files{data::type::list};
  for (const Shown& shown : drawn.pictures) {
    data links{data::type::list};
    if (!shown.file.empty()) {
      links.push_back(link(shown.file, ".png"));
      links.push_back(link(shown.file, shown.kind == "film" ? ".exr" : ".csv"));
    }
    data file;
    file.set("label", shown.label);
    file.set("links", links);
    file.set("alone", shown.command.empty() ? data(false) : data(shown.command));
    files.push_back(file);
  }
  if (!drawn.tables.empty()) {
    data links{data::type::list}, file;
    for (const std::string& table : drawn.tables) links.push_back(link(table, ""));
    for (const std::string& chart : drawn.charts) links.push_back(link(chart, ""));
    file.set("label", "numbers");
    file.set("links", links);
    file.set("alone", false);
    files.push_back(file);
  }
  return files;
}

data rows_data(const Drawn& drawn) {
  data rows{data::type::list};
  for (const std::vector<std::string>& row : drawn.rows) {
    data out;
    out.set("head", row.at(0));
    out.set("cells", texts({row.begin() + 1, row.end()}));
    rows.push_back(out);
  }
  return rows;
}

std::string scenes_text(const Site& site, const Figure& figure) {
  if (figure.scenes.size() > 1) return "";
  std::vector<std::string> names;
  for (const std::string& scene : figure.scenes) names.push_back(site.scenes.description(scene));
  for (const Picture& picture : figure.pictures) {
    const std::string name = site.scenes.description(picture.scene);
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
  if (names.empty()) return "";
  std::string text = names.size() == 1 ? "Scene: " : "Scenes: ";
  for (std::size_t i = 0; i < names.size(); ++i) text += (i > 0 ? "; " : "") + names[i];
  return text + ".";
}

// The number FIGURE.NAME: as measured, a dash if it was not measured, "" if there is no such name.
std::string number(const Site& site, const std::string& name) {
  const std::size_t dot = name.find('.');
  if (dot == std::string::npos) return "";
  const Figure* figure = site.catalogue.find(name.substr(0, dot));
  if (figure == nullptr) return "";
  const std::string rest = name.substr(dot + 1);
  const std::vector<std::string> names = number_names(*figure);
  if (std::find(names.begin(), names.end(), rest) == names.end()) return "";
  const auto found = site.figures.find(figure->id);
  if (found == site.figures.end() || !found->second.numbers.contains(rest)) return kDash;
  return found->second.numbers.at(rest);
}

std::string html_of(const Site& site, const Figure& figure) {
  const auto found = site.figures.find(figure.id);
  const Drawn drawn = found == site.figures.end() ? Drawn{} : found->second;
  data pictures{data::type::list};
  for (const Shown& shown : drawn.pictures) pictures.push_back(picture_data(shown));
  data out;
  out.set("id", figure.id);
  out.set("title", figure.title);
  out.set("small", figure.small);
  out.set("flip", figure.flip ? "true" : "false");
  out.set("draft", site.draft);
  out.set("count", std::to_string(drawn.pictures.size()));
  out.set("has_pictures", !drawn.pictures.empty());
  out.set("pictures", pictures);
  out.set("charts", texts(drawn.charts));
  out.set("has_table", !drawn.rows.empty());
  out.set("columns", texts(drawn.columns));
  out.set("rows", rows_data(drawn));
  out.set("has_anything", found != site.figures.end());
  out.set("caption", page_from_text("the caption of " + figure.id, figure.caption,
                                    {[](const std::string&) { return std::string(); },
                                     [&](const std::string& name) { return number(site, name); }}));
  out.set("scenes", scenes_text(site, figure));
  out.set("seconds", drawn.seconds > 0 ? fmt::format("{:.{}f} s of processor time.", drawn.seconds,
                                                     drawn.seconds < 10 ? 1 : 0)
                                       : "");
  out.set("command", site.command + " " + figure.id);
  const data files = files_data(drawn);
  out.set("has_files", files.is_non_empty_list());
  out.set("files", files);
  return render(figure_html, out);
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

Page make_page(const Site& site, const std::string& name) {
  const fs::path file = site.texts / (name + ".md");
  const std::string text = pt::read_file(file, kMaxPage);
  std::set<std::string> shown;
  const Names names{[&](const std::string& id) {
                      const Figure* figure = site.catalogue.find(id);
                      if (figure == nullptr) return std::string();
                      shown.insert(id);
                      return html_of(site, *figure);
                    },
                    [&](const std::string& id) { return number(site, id); }};
  Page page{name, title_of(text, name),
            with_page_links(page_from_text(file.string(), text, names))};
  const std::string part = name.starts_with("part") ? name.substr(4) : name;
  for (const Figure& figure : site.catalogue.figures) {
    if (figure.part == part && !shown.contains(figure.id)) page.content += html_of(site, figure);
  }
  const std::size_t first = page.content.find("<h2");
  if (first != std::string::npos) page.content.insert(first, contents(site, shown));
  return page;
}

// Gives each chart the size that its file states, so that a page that is loading keeps its places.
std::string with_chart_sizes(const std::string& html, const fs::path& folder) {
  static const std::regex chart(R"re(<img class="chart" src="(figures/[^"]*\.svg)")re");
  static const std::regex size(R"re(viewBox="0 0 ([0-9.]+) ([0-9.]+)")re");
  std::string text;
  std::smatch found, stated;
  auto from = html.cbegin();
  for (; std::regex_search(from, html.cend(), found, chart); from = found[0].second) {
    text.append(from, found[0].second);
    const fs::path file = folder / found.str(1);
    if (!fs::exists(file)) continue;
    const std::string head = pt::read_file(file, kMaxChart).substr(0, 2000);
    if (std::regex_search(head, stated, size)) {
      text += fmt::format(" width=\"{}\" height=\"{}\"", stated.str(1), stated.str(2));
    }
  }
  return text.append(from, html.cend());
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
  for (const std::string& name : page_names()) pages.push_back(make_page(site, name));
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
    out.set("content", with_chart_sizes(page.content, folder));
    out.set("made", made);
    pt::write_file(folder / (page.name + ".html"), render(page_html, out));
  }
  fs::copy(kDrawings, folder / "drawings",
           fs::copy_options::recursive | fs::copy_options::overwrite_existing);
  pt::write_file(folder / "writeup.css", style());
  pt::write_file(folder / "writeup.js", writeup_js);
}

}  // namespace writeup
