// A task file as the pages of a class read it: the sketch for likeness, the marked lines, and the code on a learner's page.
#include "grader/service/platforms/learner_page.h"
#include "grader/service/platforms/likeness.h"
#include "grader/service/platforms/sketch.h"
#include "tests/fuzz/input.h"

#include <algorithm>
#include <string>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace grader::platforms;
  const std::string text(fuzz::as_text(bytes, size));
  const auto lines = static_cast<std::size_t>(std::ranges::count(text, '\n')) + 1;
  for (const Print& print : sketch_of(text)) {
    fuzz::expect(print.first_line >= 1 && print.first_line <= print.last_line);
    fuzz::expect(print.last_line <= lines);
  }
  grader::results::Results results;
  results.tasks.resize(1);
  results.tasks[0].slug = "hit_box";
  results.tasks[0].state = grader::results::State::fail;
  // Half of it is what somebody else handed in.
  const std::string half = text.substr(0, size / 2) + "x";
  Likeness likeness({{"hit_box", {half, {{"reference/hit_box.cpp", text}}}}});
  likeness.add("ada", {{"hit_box", text}}, results);
  likeness.add("bob", {{"hit_box", half}}, results);
  const std::string page = likeness.to_html(
      [&](const std::string&, const std::string& name) { return name == "bob" ? half : text; });
  fuzz::expect(page.ends_with("</html>\n"));
  const std::string finished =
      finished_page("<!--code hit_box--><!--/code hit_box-->", "", {{"hit_box", text}});
  fuzz::expect(finished.ends_with("<!--/code hit_box-->"));
  return 0;
}
