#include "grader/watch/fit.h"

#include "grader/base/wrap.h"

#include <algorithm>
#include <cstddef>
#include <vector>

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

namespace grader::watch {

namespace {

constexpr std::size_t kBesideLabel = 12;  // "  expected  "

// The end of the character at i: of all its bytes in UTF-8, or of a colour.
std::size_t end_of_character(const std::string& text, std::size_t i) {
  if (text[i] == '\x1b') {
    const std::size_t end = text.find('m', i);
    return end == std::string::npos ? text.size() : end + 1;
  }
  for (++i; i < text.size() && (static_cast<unsigned char>(text[i]) & 0xC0) == 0x80;) ++i;
  return i;
}

// The place to break a text so that at most `columns` characters come before: after a space, if there is one.
std::size_t break_of(const std::string& text, std::size_t columns) {
  std::size_t width = 0, after_space = 0, i = 0;
  while (i < text.size()) {
    const bool seen = text[i] != '\x1b';
    if (seen && width == columns) return after_space > 0 ? after_space : i;
    if (seen) ++width;
    const bool space = text[i] == ' ' && text.find_first_not_of(' ') < i;
    i = end_of_character(text, i);
    if (space) after_space = i;
  }
  return text.size();
}

std::vector<std::string> broken(std::string line, std::size_t columns) {
  const bool labelled = line.starts_with("  ") && columns > 3 * kBesideLabel;
  const std::string indent(labelled ? kBesideLabel : 0, ' ');
  std::vector<std::string> lines;
  for (std::size_t end; (end = break_of(line, columns)) < line.size();) {
    lines.push_back(line.substr(0, end));
    line = indent + line.substr(end);
  }
  lines.push_back(line);
  return lines;
}

}  // namespace

ScreenSize screen_size() {
  winsize size{};
  if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_row == 0) return {};
  return {size.ws_col, size.ws_row};
}

std::string fit(const std::string& text, const ScreenSize& screen) {
  std::vector<std::string> lines;
  for (const std::string& line : base::lines_of(text)) {
    const auto some = broken(line, static_cast<std::size_t>(std::max(screen.columns, 20)));
    lines.insert(lines.end(), some.begin(), some.end());
  }
  while (!lines.empty() && lines.back().empty()) lines.pop_back();
  const auto room = static_cast<std::size_t>(std::max(screen.rows, 2));
  std::string all;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (i + 1 == room && lines.size() > room) {
      return all + fmt::format("  ... {} more lines: make the window taller, or type ./run grade\n",
                               lines.size() - i);
    }
    all += lines[i] + '\n';
  }
  return all;
}

}  // namespace grader::watch
