#include "pt/file.h"
#include "writeup/exported.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

// Draws the boxes that one ray tests, from the numbers that ./run view exports.

namespace writeup {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

constexpr double kRow = 16, kLeft = 64, kRight = 12, kTop = 30;

bool is_leaf(const json& test) { return test.contains("primitives"); }
bool is_entered(const json& test) { return !test.at("t").is_null(); }

std::string fate_of(const json& test) {
  if (!is_entered(test)) return "missed";
  if (!test.at("opened")) return "entered, not opened";
  return is_leaf(test) ? "its primitives are tested" : "its children are tested";
}

// The range of t of a chart: of all boxes that the ray enters.
std::pair<double, double> range_of(const json& tests) {
  double low = INFINITY, high = 0;
  for (const json& test : tests) {
    if (!is_entered(test)) continue;
    low = std::min(low, value_in(test.at("t").at(0)));
    high = std::max(high, value_in(test.at("t").at(1)));
  }
  return {low, high};
}

// A row per test: a bar from where the ray enters the box to where it leaves it.
std::string drawing_of_ray(const json& ray) {
  const json& tests = ray.at("tests");
  const auto [low, high] = range_of(tests);
  const auto x = [low = low, high = high](double t) {
    return kLeft + (t - low) / std::max(high - low, 1e-300) * (kDrawingWidth - kLeft - kRight);
  };
  const double bottom = kTop + kRow * static_cast<double>(tests.size());
  std::string text = "<text x=\"4\" y=\"14\">level</text>\n";
  for (std::size_t i = 0; i < tests.size(); ++i) {
    const json& test = tests[i];
    const double y = kTop + kRow * static_cast<double>(i);
    text += fmt::format("<text x=\"{:.0f}\" y=\"{:.1f}\" font-size=\"12\">{}</text>\n", 4.0, y + 12,
                        test.contains("level") ? test.at("level").dump() : "?");
    if (!is_entered(test)) {
      text += fmt::format(
          "<text x=\"26\" y=\"{:.1f}\" font-size=\"12\" fill=\"#767676\">missed</text>\n", y + 12);
      continue;
    }
    const double from = x(value_in(test.at("t").at(0))), to = x(value_in(test.at("t").at(1)));
    const char* const color = !test.at("opened") ? "#b8b8b8"
                              : is_leaf(test)    ? "#d9772b"
                                                 : "#3d76b0";
    text += fmt::format(
        "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"10\" fill=\"{}\"><title>t from "
        "{} to "
        "{}: {}</title></rect>\n",
        from, y + 3, std::max(to - from, 1.5), color, number_in(test.at("t").at(0)),
        number_in(test.at("t").at(1)), fate_of(test));
    for (const json& primitive : test.value("primitives", json::array())) {
      if (!primitive.at(1).is_number()) continue;
      text += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"4\" fill=\"#111\"/>\n",
                          x(primitive.at(1)), y + 8);
    }
  }
  if (ray.at("t").is_number()) {
    const double at = x(ray.at("t"));
    text += fmt::format(
        "<path d=\"M{0:.1f} 20V{1:.1f}\" stroke=\"#111\" stroke-dasharray=\"4 3\"/>\n"
        "<text x=\"{0:.1f}\" y=\"14\" text-anchor=\"middle\">t = {2}</text>\n",
        at, bottom, number_in(ray.at("t")));
  }
  return svg(bottom + 6, text);
}

struct Level {
  int tested = 0, missed = 0, behind = 0, opened = 0, leaves = 0, primitives = 0;
};

void write_tests(const json& tests, const fs::path& file) {
  std::string csv = "test,node,level,enters,leaves,then,primitives\n";
  for (std::size_t i = 0; i < tests.size(); ++i) {
    const json& test = tests[i];
    const auto end = [&](int which) {
      return is_entered(test) ? fmt::format("{:.9g}", value_in(test.at("t").at(which))) : "";
    };
    csv += fmt::format("{},{},{},{},{},\"{}\",{}\n", i + 1, test.at("node").get<int>(),
                       test.value("level", -1), end(0), end(1), fate_of(test),
                       test.value("primitives", json::array()).size());
  }
  pt::write_file(file, csv);
}

void add_levels(const std::vector<Level>& levels, Drawn& drawn) {
  drawn.columns = {"level of the tree",   "boxes tested", "missed",
                   "entered, not opened", "opened",       "of these leaves",
                   "primitives tested"};
  Level sum;
  const auto add = [&](const std::string& name, const Level& level) {
    drawn.rows.push_back({name, std::to_string(level.tested), std::to_string(level.missed),
                          std::to_string(level.behind), std::to_string(level.opened),
                          std::to_string(level.leaves), std::to_string(level.primitives)});
  };
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const Level& level = levels[i];
    if (level.tested > 0) add(std::to_string(i), level);
    sum = {sum.tested + level.tested, sum.missed + level.missed, sum.behind + level.behind,
           sum.opened + level.opened, sum.leaves + level.leaves, sum.primitives + level.primitives};
  }
  add("all", sum);
  drawn.numbers["boxes"] = std::to_string(sum.tested);
  drawn.numbers["missed"] = std::to_string(sum.missed);
  drawn.numbers["behind"] = std::to_string(sum.behind);
  drawn.numbers["opened"] = std::to_string(sum.opened);
  drawn.numbers["leaves"] = std::to_string(sum.leaves);
}

}  // namespace

Drawn draw_ray(const Plan& plan, const Figure& figure, const fs::path& folder) {
  Drawn drawn;
  const json all = exported(plan, figure, drawn);
  if (!drawn.problems.empty()) return drawn;
  const json& ray = all.at("ray");
  const json& tests = ray.at("tests");
  if (tests.empty()) {
    drawn.problems.emplace_back("the ray tests no box");
    return drawn;
  }
  std::vector<Level> levels;
  for (const json& test : tests) {
    const std::size_t at = test.value("level", 0);
    levels.resize(std::max(levels.size(), at + 1));
    Level& level = levels[at];
    const bool is_opened = test.at("opened");
    ++level.tested;
    if (!is_entered(test)) ++level.missed;
    if (is_entered(test) && !is_opened) ++level.behind;
    if (is_opened) ++level.opened;
    if (is_opened && is_leaf(test)) ++level.leaves;
    level.primitives += static_cast<int>(test.value("primitives", json::array()).size());
  }
  add_levels(levels, drawn);
  drawn.numbers["levels"] = std::to_string(levels.size());
  drawn.numbers["primitives"] = std::to_string(ray.at("primitives").get<int>());
  drawn.numbers["primitives_of_all"] = std::to_string(ray.at("all").get<int>());
  drawn.numbers["t"] = number_in(ray.at("t"));
  drawn.charts = {figure.id + ".svg"};
  pt::write_file(folder / drawn.charts[0], drawing_of_ray(ray));
  drawn.tables = {figure.id + ".csv"};
  write_tests(tests, folder / drawn.tables[0]);
  return drawn;
}

}  // namespace writeup
