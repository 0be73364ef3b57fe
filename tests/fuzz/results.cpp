// results.json: it is refused, or every report on it can be written and contains nothing that
// misleads a reader.
#include "grader/report/autograders.h"
#include "grader/report/csv.h"
#include "grader/report/html.h"
#include "grader/report/junit.h"
#include "grader/report/terminal.h"
#include "grader/results/json.h"
#include "grader/results/presentable.h"
#include "grader/service/platforms/class_page.h"
#include "pt/error.h"
#include "tests/fuzz/input.h"

#include <algorithm>

#include <nlohmann/json.hpp>
#include <tinyxml2.h>

namespace {

using namespace grader;

// The text is UTF-8 and contains nothing that moves a terminal's cursor.
void expect_plain(const std::string& text) {
  for (const char c : text) {
    fuzz::expect(static_cast<unsigned char>(c) >= 0x20 || c == '\n' || c == '\r' || c == '\t');
  }
  fuzz::expect(text.find('\x7f') == text.npos && text.find("\xc2\x9b") == text.npos);
  nlohmann::json(text).dump();  // throws if it is not UTF-8
}

// The table has one line per task below the column names; a quoted field may contain line breaks.
void expect_table(const std::string& text, std::size_t tasks) {
  std::size_t lines = 0;
  bool quoted = false;
  for (const char c : text) {
    if (c == '"') quoted = !quoted;
    if (c == '\n' && !quoted) ++lines;
  }
  fuzz::expect(!quoted && lines == tasks + 1);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  try {
    const results::Results read =
        results::results_from_json(std::string(fuzz::as_text(bytes, size)), "results.json");
    expect_plain(report::to_text(results::presentable(read), {false, true}));
    const std::string table = report::to_csv(read), junit = report::to_junit(read);
    expect_plain(table);
    expect_plain(junit);
    expect_table(table, std::min<std::size_t>(read.tasks.size(), 100));
    fuzz::expect(tinyxml2::XMLDocument().Parse(junit.c_str()) == tinyxml2::XML_SUCCESS);
    fuzz::expect(nlohmann::json::parse(report::to_gradescope(read)).contains("tests"));
    fuzz::expect(nlohmann::json::parse(report::to_prairielearn(read)).at("score") <= 1);
    const std::string output = report::to_autolab(read), tests = report::to_artemis(read);
    const std::size_t last = output.rfind('\n', output.size() - 2) + 1;
    fuzz::expect(nlohmann::json::parse(output.substr(last)).contains("scores"));
    fuzz::expect(tinyxml2::XMLDocument().Parse(tests.c_str()) == tinyxml2::XML_SUCCESS);
    expect_plain(report::to_html(read));
    platforms::ClassPage page;
    page.add({"name", "", "page.html", "", false}, read);
    expect_plain(page.to_html());
    const std::string again = results::to_json(read);
    fuzz::expect(results::to_json(results::results_from_json(again, "again")) == again);
  } catch (const pt::Error& error) {
    fuzz::expect_reason(error);
  }
  return 0;
}
