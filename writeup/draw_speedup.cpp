#include "grader/report/csv.h"
#include "measure/charts/gnuplot.h"
#include "pt/file.h"
#include "writeup/figure.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace writeup {

namespace fs = std::filesystem;

namespace {

constexpr double kPixels = 480.0 * 360;

// One engine in one scene.
struct Cell {
  double seconds = 0;  // per picture of 480 x 360: the mean of all turns
  double error = 0;    // its standard error, as a part of it
  double tests = 0;    // of boxes and surfaces, per ray
  int primitives = 0;
  std::string problem;
};

Cell measured_once(const Plan& plan, const std::string& scene, pt::Engine engine, int turn) {
  const Rendered render = plan.store().load(plan.cell(scene, engine, turn));
  Cell cell;
  cell.primitives = render.primitives;
  cell.problem = render.failed;
  for (const std::string& task : render.missing) cell.problem = "not written yet: " + task;
  if (engine == pt::Engine::task && render.engine == "linear") {
    cell.problem = "not written yet: the tree";
  }
  if (cell.problem.empty() && render.seconds <= 0) cell.problem = "not measured";
  if (!cell.problem.empty()) return cell;
  const measure::RowHead& total = render.total;
  cell.seconds = render.seconds / static_cast<double>(render.film.pixels.size()) * kPixels;
  if (total.rays > 0) {
    cell.tests = static_cast<double>(total.boxes + total.triangles + total.spheres) /
                 static_cast<double>(total.rays);
  }
  return cell;
}

Cell measured(const Plan& plan, const std::string& scene, pt::Engine engine) {
  Cell cell = measured_once(plan, scene, engine, 0);
  double sum = cell.seconds, squares = cell.seconds * cell.seconds;
  for (int turn = 1; turn < kTurns && cell.problem.empty(); ++turn) {
    Cell again = measured_once(plan, scene, engine, turn);
    if (!again.problem.empty()) return again;
    sum += again.seconds;
    squares += again.seconds * again.seconds;
  }
  if (!cell.problem.empty()) return cell;
  cell.seconds = sum / kTurns;
  const double variance = std::max(0.0, squares / kTurns - cell.seconds * cell.seconds);
  cell.error = std::sqrt(variance / (kTurns - 1)) / cell.seconds;
  return cell;
}

std::string shown(const Cell& cell, double value) {
  if (!cell.problem.empty()) return kDash;
  return value > 0 ? digits(value) : kDash;
}

const char* const kChart = R"(set datafile missing "nan"
set logscale xy
set title "Normals, s = 1, 480 x 360 pixels\n{}" noenhanced
set xlabel "triangles"
set ylabel "processor seconds per picture"
set key top left
set format x "%.0s%c"
plot "{}.csv" using 2:3 skip 1 with linespoints lc rgb "#8a9299" lw 2 pt 7 ps .6 title "no tree", \
     "" using 2:4 skip 1 with linespoints lc rgb "#e69f00" lw 2 pt 5 ps .6 title "the tree of part 2", \
     "" using 2:5 skip 1 with linespoints lc rgb "#000000" lw 2 pt 9 ps .6 title "the fast engine"{}
)";

// Draws a point for each scene, by its number of triangles.
void draw_chart(const fs::path& folder, const std::string& id,
                const std::map<int, std::string>& lines) {
  std::string csv =
      "scene,triangles,linear_seconds,task_seconds,wide_seconds,linear_tests,task_tests,"
      "linear_error,task_error,wide_error\n";
  for (const auto& [triangles, line] : lines) csv += line;
  pt::write_file(folder / (id + ".csv"), csv);
  std::string values;
  for (const auto& [name, seconds, error] : {std::tuple{"no tree", "$3", "$8"},
                                             {"the tree of part 2", "$4", "$9"},
                                             {"the fast engine", "$5", "$10"}}) {
    values += measure::under_the_pointer(
        {fmt::format("\"{}.csv\" skip 1", id), name, "$2", seconds, seconds, error});
  }
  measure::draw(folder, id, fmt::format(fmt::runtime(kChart), measure::processor(), id, values),
                fmt::format("Processor seconds for a picture of the normals, s = 1, 480 x 360 "
                            "pixels, on {}: scenes by their "
                            "number of triangles, without and with a tree.",
                            measure::processor()));
}

std::string csv_line(const std::string& scene, const Cell& linear, const Cell& tree,
                     const Cell& wide) {
  const auto number = [](const Cell& cell, double value) {
    return cell.problem.empty() ? fmt::format("{:.6g}", value) : "nan";
  };
  return fmt::format("{},{},{},{},{},{},{},{},{},{}\n", grader::report::csv_field(scene),
                     wide.primitives, number(linear, linear.seconds), number(tree, tree.seconds),
                     number(wide, wide.seconds), number(linear, linear.tests),
                     number(tree, tree.tests), number(linear, linear.error * linear.seconds),
                     number(tree, tree.error * tree.seconds),
                     number(wide, wide.error * wide.seconds));
}

double factor_of(const Cell& linear, const Cell& tree) { return linear.seconds / tree.seconds; }

void enter_numbers(const std::string& scene, const Cell& linear, const Cell& tree, Drawn& drawn) {
  drawn.numbers[scene + ".triangles"] = std::to_string(tree.primitives);
  drawn.numbers[scene] = digits(factor_of(linear, tree));
  drawn.numbers[scene + ".linear"] = digits(linear.seconds);
  drawn.numbers[scene + ".tree"] = digits(tree.seconds);
  if (!(tree.tests > 0)) return;
  drawn.numbers[scene + ".linear_tests"] = digits(linear.tests);
  drawn.numbers[scene + ".tests"] = digits(tree.tests);
}

}  // namespace

Drawn draw_speedup(const Plan& plan, const Figure& figure, const fs::path& folder) {
  Drawn drawn;
  drawn.columns = {"scene",
                   "triangles",
                   "no tree, s",
                   "tree, s",
                   "fast engine, s",
                   "speed-up",
                   "tests per ray, no tree",
                   "tests per ray, tree"};
  std::map<int, std::string> lines;
  for (const std::string& scene : figure.scenes) {
    const Cell linear = measured(plan, scene, pt::Engine::linear);
    const Cell tree = measured(plan, scene, pt::Engine::task);
    const Cell wide = measured(plan, scene, pt::Engine::wide);
    const bool both = linear.problem.empty() && tree.problem.empty() && tree.seconds > 0;
    const double factor = factor_of(linear, tree);
    const double error = factor * std::hypot(linear.error, tree.error);
    drawn.rows.push_back({plan.scenes().description(scene), std::to_string(wide.primitives),
                          shown(linear, linear.seconds), shown(tree, tree.seconds),
                          shown(wide, wide.seconds), both ? factor_text(factor, error) : kDash,
                          shown(linear, linear.tests), shown(tree, tree.tests)});
    if (both) enter_numbers(scene, linear, tree, drawn);
    drawn.numbers[scene + ".name"] = plan.scenes().short_name(scene);
    for (const Cell& cell : {linear, tree}) {
      const std::string problem = plan.scenes().short_name(scene) + ": " + cell.problem;
      const bool is_new = drawn.problems.empty() || drawn.problems.back() != problem;
      if (!cell.problem.empty() && is_new) drawn.problems.push_back(problem);
    }
    lines[wide.primitives] += csv_line(scene, linear, tree, wide);
    for (int turn = 0; turn < kTurns; ++turn) {
      for (const pt::Engine engine : kEngines) {
        drawn.seconds += plan.store().load(plan.cell(scene, engine, turn)).seconds;
      }
    }
  }
  draw_chart(folder, figure.id, lines);
  drawn.tables = {figure.id + ".csv"};
  if (fs::exists(folder / (figure.id + ".svg"))) drawn.charts = {figure.id + ".svg"};
  for (const char* ending : {".pdf", ".tex"}) {
    if (fs::exists(folder / (figure.id + ending))) drawn.tables.push_back(figure.id + ending);
  }
  return drawn;
}

}  // namespace writeup
