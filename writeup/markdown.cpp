#include "writeup/markdown.h"

#include "pt/error.h"

#include <regex>
#include <sstream>
#include <vector>

#include <fmt/format.h>
#include <md4c-html.h>

namespace writeup {

namespace {

// The mark of a figure's place: its number between two characters that no script uses (Unicode,
// private use).
std::string mark(std::size_t figure) { return fmt::format("\uE000{}\uE001", figure); }

// The names in one line, replaced by numbers.
std::string with_numbers(const std::string& line, const Names& names, const std::string& place) {
  static const std::regex name(R"(\{\{\s*([^{}]*?)\s*\}\})");
  std::string out;
  std::size_t end = 0;
  for (std::sregex_iterator it(line.begin(), line.end(), name), last; it != last; ++it) {
    const std::string number = names.number((*it)[1]);
    if (number.empty()) {
      throw pt::Error(fmt::format("{}: there is no number '{}'", place, (*it)[1].str()));
    }
    const auto at = static_cast<std::size_t>(it->position());
    out += line.substr(end, at - end);
    out += number;
    end = at + it->length();
  }
  return out + line.substr(end);
}

}  // namespace

std::string html_from_markdown(const std::string& text) {
  std::string html;
  const auto append = [](const MD_CHAR* part, MD_SIZE size, void* into) {
    static_cast<std::string*>(into)->append(part, size);
  };
  const unsigned flags = MD_FLAG_TABLES | MD_FLAG_NOHTML | MD_FLAG_PERMISSIVEAUTOLINKS;
  if (md_html(text.data(), static_cast<MD_SIZE>(text.size()), append, &html, flags, 0) != 0) {
    throw pt::Error("the text cannot be read as Markdown");
  }
  return html;
}

std::string page_from_text(const std::string& file, const std::string& text, const Names& names) {
  static const std::regex figure_line(R"(^\s*\{\{\s*figure\s+([^{}\s]*)\s*\}\}\s*$)");
  std::istringstream lines(text);
  std::string markdown;
  std::vector<std::string> figures;
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    const std::string place = fmt::format("{}:{}", file, ++number);
    std::smatch found;
    if (!std::regex_match(line, found, figure_line)) {
      markdown += with_numbers(line, names, place) + "\n";
      continue;
    }
    const std::string html = names.figure(found[1]);
    if (html.empty()) {
      throw pt::Error(fmt::format("{}: there is no figure '{}'", place, found[1].str()));
    }
    markdown += fmt::format("\n{}\n\n", mark(figures.size()));
    figures.push_back(html);
  }
  std::string html = html_from_markdown(markdown);
  for (std::size_t i = 0; i < figures.size(); ++i) {
    const std::string paragraph = fmt::format("<p>{}</p>", mark(i));
    const std::size_t at = html.find(paragraph);
    if (at == std::string::npos) throw pt::Error(file + ": a figure stands inside a paragraph");
    html.replace(at, paragraph.size(), figures[i]);
  }
  return html;
}

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:
        out += c;
    }
  }
  return out;
}

}  // namespace writeup
