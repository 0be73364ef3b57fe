#include "writeup/markdown.h"

#include "pt/error.h"

#include <cctype>
#include <cstdlib>
#include <optional>
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

// Marks in a sentence, from the same range: a number that is not measured, and an untrue condition.
const std::string kUnmeasured = "\uE002", kUntrue = "\uE003";

std::string number_of(const std::string& name, const Names& names, const std::string& place) {
  std::string number = names.number(name);
  if (number.empty()) throw pt::Error(fmt::format("{}: there is no number '{}'", place, name));
  return number;
}

// The value of "0.5", "NAME" or "2*NAME"; nothing if it is not measured.
std::optional<double> value_of(const std::string& words, const Names& names,
                               const std::string& place) {
  char* end = nullptr;
  const double factor = std::strtod(words.c_str(), &end);
  if (*end == '\0') return factor;
  const bool has_factor = end != words.c_str() && *end == '*';
  const std::string text = number_of(has_factor ? end + 1 : words, names, place);
  const double value = std::strtod(text.c_str(), &end);
  if (end == text.c_str()) return {};
  return has_factor ? factor * value : value;
}

// "A < B" or "A > B": nothing if it is true, else a mark.
std::string judged(const std::string& condition, const Names& names, const std::string& place) {
  static const std::regex form(R"((\S+)\s*([<>])\s*(\S+))");
  std::smatch found;
  if (!std::regex_match(condition, found, form)) {
    throw pt::Error(fmt::format("{}: '{}' is not a condition like A < B", place, condition));
  }
  const std::optional<double> a = value_of(found[1], names, place);
  const std::optional<double> b = value_of(found[3], names, place);
  if (!a || !b) return kUnmeasured;
  return (found[2] == "<" ? *a < *b : *a > *b) ? "" : kUntrue;
}

// The names in one line, replaced by numbers.
std::string with_numbers(const std::string& line, const Names& names, const std::string& place) {
  static const std::regex name(R"(\{\{\s*([^{}]*?)\s*\}\})");
  std::string out;
  std::size_t end = 0;
  for (std::sregex_iterator it(line.begin(), line.end(), name), last; it != last; ++it) {
    const std::string word = (*it)[1];
    std::string number = word.starts_with("if ") ? judged(word.substr(3), names, place)
                                                 : number_of(word, names, place);
    if (number == kDash) number = kUnmeasured;
    const auto at = static_cast<std::size_t>(it->position());
    out += line.substr(end, at - end);
    out += number;
    end = at + it->length();
  }
  return out + line.substr(end);
}

bool has(const std::string& text, const std::string& mark) {
  return text.find(mark) != std::string::npos;
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != text.npos; at += to.size()) {
    text.replace(at, from.size(), to);
  }
  return text;
}

// Bold words and brackets close behind a full stop, and a condition stands there.
std::size_t end_of_closing(const std::string& text, std::size_t at) {
  while (at < text.size()) {
    if (text[at] == '*' || text[at] == ')') {
      ++at;
    } else if (text.compare(at, kUntrue.size(), kUntrue) == 0 ||
               text.compare(at, kUnmeasured.size(), kUnmeasured) == 0) {
      at += kUntrue.size();
    } else {
      break;
    }
  }
  return at;
}

// The end of the sentence that begins here, with the space behind it. Bold words with a full stop are
// a sentence of their own.
std::size_t end_of_sentence(const std::string& text, std::size_t at) {
  for (; at < text.size(); ++at) {
    if (std::string(".?!:").find(text[at]) == std::string::npos) continue;
    std::size_t next = at + 1;
    next = end_of_closing(text, next);
    if (next >= text.size() || std::isspace(static_cast<unsigned char>(text[next])) == 0) continue;
    while (next < text.size() && std::isspace(static_cast<unsigned char>(text[next])) != 0) ++next;
    const auto letter = static_cast<unsigned char>(next < text.size() ? text[next] : 'A');
    if (text[at] == ':' || (std::islower(letter) != 0)) continue;
    return next;
  }
  return text.size();
}

bool is_bold(const std::string& sentence) {
  const std::size_t last = sentence.find_last_not_of(" \n");
  return sentence.starts_with("**") && last != sentence.npos && last > 2 && sentence[last] == '*';
}

// A paragraph or an item of a list without the sentences that have a mark. The bold words before a
// sentence stay while any sentence of theirs does. `left_out` counts the sentences without a number.
struct Kept {
  std::string text;
  int left_out = 0;
};
Kept true_sentences(const std::string& unit) {
  if (unit.starts_with("|")) return {replaced(unit, kUnmeasured, kDash)};
  Kept kept;
  bool any = false, lost = false;
  std::size_t bold = unit.npos;  // where bold words begin that have no sentence yet
  for (std::size_t at = 0; at < unit.size();) {
    const std::size_t end = end_of_sentence(unit, at);
    const std::string sentence = unit.substr(at, end - at);
    at = end;
    const bool unmeasured = has(sentence, kUnmeasured);
    if (unmeasured && !has(sentence, kUntrue)) ++kept.left_out;
    if (!unmeasured && !has(sentence, kUntrue)) {
      if (is_bold(sentence) && bold != unit.npos && lost) kept.text.resize(bold);
      bold = is_bold(sentence) ? kept.text.size() : unit.npos;
      lost = false;
      kept.text += sentence;
      any = true;
      continue;
    }
    lost = true;
    if (sentence.starts_with("- ")) {
      kept.text += "- ";
    }
  }
  if (bold != unit.npos && lost) kept.text.resize(bold);
  if (!any) kept.text.clear();
  if (!kept.text.empty() && kept.text.back() != '\n') kept.text += '\n';
  return kept;
}

// All paragraphs and items, without the sentences that have a mark.
Kept true_text(const std::string& markdown) {
  Kept kept;
  std::string unit;
  const auto finish = [&] {
    const Kept part = true_sentences(unit);
    kept.text += part.text;
    kept.left_out += part.left_out;
    unit.clear();
  };
  std::istringstream lines(markdown);
  for (std::string line; std::getline(lines, line);) {
    if (line.empty() || line.starts_with("- ") || line.starts_with("|")) finish();
    line.empty() ? kept.text += '\n' : unit += line + '\n';
  }
  finish();
  return kept;
}

// The element of a formula stands for itself in a block of code whose language is mathml. Everything else stays
// text.
std::string with_formulas(std::string html) {
  static const std::string open = "<pre><code class=\"language-mathml\">", close = "</code></pre>";
  for (std::size_t at = 0; (at = html.find(open, at)) != html.npos;) {
    const std::size_t end = html.find(close, at);
    std::string formula = html.substr(at + open.size(), end - at - open.size());
    for (const char* name : {"mi", "mn", "mo", "mrow", "mfrac", "msup", "msub", "msqrt", "mtext"}) {
      for (const char* slash : {"", "/"}) {
        formula = replaced(formula, fmt::format("&lt;{}{}&gt;", slash, name),
                           fmt::format("<{}{}>", slash, name));
      }
    }
    formula = "<p class=\"formula\"><math display=\"block\">" + formula + "</math></p>";
    html.replace(at, end + close.size() - at, formula);
    at += formula.size();
  }
  return html;
}

}  // namespace

std::string html_from_markdown(const std::string& text, Tags tags) {
  std::string html;
  const auto append = [](const MD_CHAR* part, MD_SIZE size, void* into) {
    static_cast<std::string*>(into)->append(part, size);
  };
  const unsigned flags =
      MD_FLAG_TABLES | MD_FLAG_PERMISSIVEAUTOLINKS | (tags == Tags::shown ? MD_FLAG_NOHTML : 0U);
  if (md_html(text.data(), static_cast<MD_SIZE>(text.size()), append, &html, flags, 0) != 0) {
    throw pt::Error("the text cannot be read as Markdown");
  }
  return with_formulas(html);
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
  const Kept kept = true_text(markdown);
  std::string html = html_from_markdown(kept.text);
  if (kept.left_out > 0) {
    html += fmt::format(
        "<p class=\"note\">{} of this text {} left out here, because {} numbers were not measured "
        "for these pages.</p>\n",
        kept.left_out == 1 ? "A sentence" : fmt::format("{} sentences", kept.left_out),
        kept.left_out == 1 ? "is" : "are", kept.left_out == 1 ? "its" : "their");
  }
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
