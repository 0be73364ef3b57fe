#include "writeup/figure_html.h"

#include "pt/error.h"
#include "pt/file.h"
#include "writeup/markdown.h"
#include "writeup/page/sources.h"

#include <algorithm>
#include <regex>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <kainjow/mustache.hpp>

namespace writeup {

namespace fs = std::filesystem;
using kainjow::mustache::data;

namespace {

constexpr std::size_t kMaxChart = std::size_t{1} << 24;

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

// The size that the file of a chart states, as attributes: a page that is loading keeps its places.
std::string stated_size(const std::string& chart) {
  static const std::regex size(R"re(viewBox="0 0 ([0-9.]+) ([0-9.]+)")re");
  const std::string head = chart.substr(0, 2000);
  std::smatch stated;
  if (!std::regex_search(head, stated, size)) return "";
  return fmt::format(" width=\"{}\" height=\"{}\"", stated.str(1), stated.str(2));
}

data charts_data(const Drawn& drawn, const fs::path& folder) {
  data charts{data::type::list};
  for (const std::string& chart : drawn.charts) {
    data item;
    item.set("text", chart);
    const fs::path file = folder / "figures" / chart;
    const std::string source = fs::exists(file) ? pt::read_file(file, kMaxChart) : "";
    const std::size_t svg = source.find("<svg");
    const bool is_photo = source.find("<image") != source.npos;
    item.set("size", stated_size(source));
    item.set("photo", is_photo);
    // Only a drawing that is part of the page shows its values under the pointer.
    item.set("drawing",
             is_photo || svg == source.npos ? data(false) : data(source.substr(svg + 4)));
    charts.push_back(item);
  }
  return charts;
}

}  // namespace

std::string render(std::string_view source, const data& values) {
  kainjow::mustache::mustache page{std::string(source)};
  std::string text = page.render(values);
  if (!page.is_valid()) throw pt::Error("a page cannot be made: " + page.error_message());
  return text;
}

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

std::string html_of(const Site& site, const Figure& figure, const fs::path& folder) {
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
  out.set("charts", charts_data(drawn, folder));
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

}  // namespace writeup
