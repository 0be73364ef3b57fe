#include "grader/report/side_by_side.h"

#include "grader/report/embedded.h"
#include "grader/report/pictures.h"
#include "grader/results/presentable.h"
#include "pt/image/tone_map.h"

#include <fmt/format.h>

namespace grader::report {

namespace {

constexpr const char* kHead = R"(<meta charset="utf-8">
<meta name="viewport" content="width=device-width">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; img-src data:; style-src 'unsafe-inline'; script-src 'unsafe-inline'">
<style>
:root { color-scheme: light dark; font: 16px/1.5 system-ui, sans-serif; --line: #8886; --good: #0b6b5b; --bad: #a33708; --open: #765600 }
@media (prefers-color-scheme: dark) { :root { --good: #5ec9b3; --bad: #f39a6b; --open: #e0b848 } }
body { margin: 1.5rem auto; max-width: 78rem; padding: 0 1rem; overflow-wrap: anywhere }
h1 { font-size: 1.5rem; margin: 0 } h2 { font-size: 1.1rem; margin: 2rem 0 .3rem }
p, pre { margin: .3rem 0 } pre { font-size: .9rem; overflow-x: auto }
.agrees { color: var(--good) } .wrong { color: var(--bad) } .cannot { color: var(--open) }
.row { display: grid; gap: 1rem; grid-template-columns: repeat(auto-fit, minmax(min(15rem, 100%), 1fr)) }
figure { margin: 0 } figcaption, footer { color: GrayText; font-size: .9rem } img { display: block; image-rendering: pixelated; width: 100% }
.over { display: grid } .over img { grid-area: 1 / 1 } input { margin: .3rem 0; width: 100% }
footer { border-top: 1px solid var(--line); margin-top: 2rem; padding-top: .5rem }
</style>
)";

// The upper picture is cut off at the slider.
constexpr const char* kScript = R"(<script>
for (const slider of document.querySelectorAll("input")) {
  const upper = slider.parentElement.querySelector(".upper");
  const cut = () => { upper.style.clipPath = `inset(0 ${100 - slider.value}% 0 0)`; };
  slider.addEventListener("input", cut);
  cut();
}
</script>
)";

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : results::presentable(text)) {
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

std::string figure(const std::string& picture, const std::string& caption) {
  return fmt::format("<figure><img src=\"{}\" alt=\"{}\"><figcaption>{}</figcaption></figure>\n",
                     picture, escaped(caption), escaped(caption));
}

std::string pair_of(const SideBySide& pair) {
  const double exposure = exposure_for(pair.right);
  const std::string left = png_address(pt::tone_map(pair.left, exposure));
  const std::string right = png_address(pt::tone_map(pair.right, exposure));
  std::string page = fmt::format("<h2>{}</h2>\n", escaped(pair.title));
  if (!pair.verdict.empty()) {
    const std::string tone = pair.verdict.substr(0, pair.verdict.find(' '));
    page += fmt::format("<p class=\"{}\"><strong>{}</strong></p>\n", escaped(tone),
                        escaped(pair.verdict));
  }
  if (!pair.text.empty()) page += fmt::format("<pre>{}</pre>\n", escaped(pair.text));
  const std::string names = pair.left_name + " | " + pair.right_name;
  page += fmt::format(
      "<div class=\"row\">\n<figure><div class=\"over\"><img src=\"{0}\" alt=\"{2}\"><img "
      "class=\"upper\" "
      "src=\"{1}\" alt=\"{3}\"></div><input type=\"range\" value=\"50\" aria-label=\"{4}\">"
      "<figcaption>{4}</figcaption></figure>\n",
      right, left, escaped(pair.right_name), escaped(pair.left_name), escaped(names));
  page += figure(left, pair.left_name) + figure(right, pair.right_name);
  if (pair.map.width > 0) page += figure(png_address(pair.map), pair.map_text);
  return page + "</div>\n";
}

}  // namespace

std::string side_by_side_page(const std::string& title, const std::vector<SideBySide>& pairs,
                              const std::string& foot) {
  std::string page =
      fmt::format("<!DOCTYPE html>\n<html lang=\"en\">\n{}<title>{}</title>\n<h1>{}</h1>\n", kHead,
                  escaped(title), escaped(title));
  for (const SideBySide& pair : pairs) page += pair_of(pair);
  page += fmt::format("<footer>{}</footer>\n{}</html>\n", escaped(foot), kScript);
  return page;
}

}  // namespace grader::report
