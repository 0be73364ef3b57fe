#include "grader/service/platforms/learner_page.h"

#include "grader/base/printable.h"
#include "grader/results/presentable.h"

#include <algorithm>

#include <fmt/format.h>
#include <kainjow/mustache.hpp>

namespace grader::platforms {

namespace {

using kainjow::mustache::html_escape;

constexpr std::size_t kMaxCode = std::size_t{64} << 10;  // bytes of a file that are shown

// Puts the text between the page's comments for `what`. Texts of a submission hold no comment: they are escaped.
void put(std::string& page, const std::string& what, const std::string& text) {
  const std::string open = "<!--" + what + "-->", close = "<!--/" + what + "-->";
  const std::size_t begin = page.find(open), end = page.find(close);
  if (begin == page.npos || end == page.npos || end < begin) return;
  const std::size_t from = begin + open.size();
  page.replace(from, end - from, text);
}

std::string code_block(const std::string& slug, const std::string& source) {
  const std::string code = base::printable(source, kMaxCode, true);
  const auto lines = std::ranges::count(code, '\n') + (code.ends_with('\n') ? 0 : 1);
  std::string numbers;
  for (std::ptrdiff_t line = 1; line <= lines; ++line) numbers += fmt::format("{}\n", line);
  return fmt::format(
      "<details class=\"fold code\"><summary>What was handed in: {0}.cpp, {1} line{2}</summary>"
      "<div class=\"source\"><pre aria-hidden=\"true\">{3}</pre><pre>{4}</pre></div></details>",
      slug, lines, lines == 1 ? "" : "s", numbers, html_escape(code));
}

}  // namespace

std::string grade_sentence(const std::optional<int>& points, const std::string& reason) {
  if (reason.empty()) return "";
  if (!points) return "Not graded: " + reason;
  return fmt::format("Grade: {} points ({}).", *points, reason);
}

std::string finished_page(std::string page, const std::string& grade,
                          const std::map<std::string, std::string>& files) {
  put(page, "grade",
      grade.empty() ? "" : "<p class=\"notice\">" + html_escape(results::one_line(grade)) + "</p>");
  for (const auto& [slug, text] : files) put(page, "code " + slug, code_block(slug, text));
  return page;
}

}  // namespace grader::platforms
