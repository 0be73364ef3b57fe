#include "grader/report/csv.h"
#include "pt/file.h"
#include "writeup/figure.h"
#include "writeup/files.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

// Draws the measurements of the program `accuracy`: its charts, and tables of its numbers.

namespace writeup {

namespace fs = std::filesystem;
using measure::percent;
using nlohmann::json;

namespace {

constexpr double kUnknown = 0.05;  // relative uncertainty of the error: more is marked

std::string times(const json& number) {
  if (number.is_null()) return kDash;
  if (!number.is_array()) return digits(number) + "\u00d7";
  return factor_text(number.at(0), number.at(1));
}

// Copies the files of a measurement, with the figure's name before theirs.
void take_files(const Plan& plan, const Measurement& measurement, const std::string& id,
                const std::vector<std::string>& charts, const std::vector<std::string>& tables,
                const fs::path& folder, Drawn& drawn) {
  const fs::path from = plan.measured().folder(measurement);
  const auto take = [&](const std::string& name, std::vector<std::string>& list) {
    take_file(from / name, folder, id + "." + name, list);
  };
  for (const std::string& name : charts) {
    take(name, drawn.charts);
    for (const char* ending : {"pdf", "tex"}) {
      take(fs::path(name).replace_extension(ending).string(), drawn.tables);
    }
  }
  for (const std::string& name : tables) take(name, drawn.tables);
}

// Returns whether the measurement is there; if not, adds the reason to the problems.
bool is_there(const Plan& plan, const Measurement& measurement, const std::string& scene,
              Drawn& drawn) {
  if (plan.measured().is_complete(measurement)) return true;
  const std::string problem =
      plan.scenes().short_name(scene) + ": " + plan.measured().failure(measurement);
  drawn.problems.push_back(problem);
  return false;
}

void enter_factors(const json& curve, const json& all, Drawn& drawn) {
  const std::string id = curve.at("id");
  const json& points = curve.at("points");
  drawn.numbers[id + ".error"] = digits(100 * points.back().at("error").at(0).get<double>());
  if (curve.at("fails")) return;
  for (const auto& [other, factors] : curve.at("beside").items()) {
    for (const char* what : {"time", "error", "rays"}) {
      drawn.numbers[id + ".beside." + other + "." + what] = digits(factors.at(what).at(0));
    }
  }
  drawn.numbers[id + ".time"] = digits(curve.at("beside").at(all.at("fastest")).at("time").at(0));
  drawn.numbers[id + ".slope"] = fmt::format("{:.3f}", curve.at("slope").at(0).get<double>());
}

std::vector<std::string> row_of(const json& curve, const std::string& fastest) {
  std::vector<std::string> row{curve.at("title")};
  for (const json& point : curve.at("points")) row.push_back(percent(point.at("error").at(0)));
  const bool fails = curve.at("fails");
  const auto slope = [&] {
    return fmt::format("{:.3f} \u00b1 {:.3f}", curve.at("slope").at(0).get<double>(),
                       curve.at("slope").at(1).get<double>());
  };
  row.push_back(curve.at("adaptive") || fails ? kDash : slope());
  for (const char* factor : {"time", "error", "rays"}) {
    row.push_back(fails ? "never" : times(curve.at("beside").at(fastest).at(factor)));
  }
  const json& last = curve.at("points").back();
  row.push_back(last.at("bias") > 0 ? percent(last.at("bias")) : kDash);
  for (const json& pixel : last.at("pixels")) row.push_back(percent(pixel));
  row.push_back(percent(last.at("black_samples")));
  if (curve.at("heavy_tails")) row[0] += " (heavy tails)";
  return row;
}

// The name of the chart that compares several codes.
std::string beside_of(const json& all) {
  std::string name;
  for (const json& code : all.at("codes")) {
    if (code.at("problem").get<std::string>().empty())
      name += code.at("name").get<std::string>() + ".";
  }
  return name + "beside";
}

Drawn draw_converge(const Plan& plan, const Figure& figure, const fs::path& folder) {
  Drawn drawn;
  const Measurement measurement = plan.measurements(figure).at(0);
  if (!is_there(plan, measurement, figure.scenes.at(0), drawn)) return drawn;
  const json all = plan.measured().load(measurement);
  const auto take = [&](const std::string& prefix) {
    std::vector<std::string> charts{"efficiency.svg", "samples.svg", "seconds.svg", "rays.svg"},
        tables{"efficiency.csv", "converge.csv", "factors.csv"};
    for (auto* names : {&charts, &tables}) {
      for (std::string& name : *names) name.insert(0, prefix);
    }
    take_files(plan, measurement, figure.id, charts, tables, folder, drawn);
  };
  if (!all.contains("codes")) take("");
  if (all.contains("codes"))
    take_files(plan, measurement, figure.id, {beside_of(all) + ".svg"}, {beside_of(all) + ".csv"},
               folder, drawn);
  for (const json& code : all.value("codes", json::array())) {
    take(code.at("name").get<std::string>() + ".");
    const std::string problem = code.at("problem");
    if (!problem.empty())
      drawn.problems.push_back(code.at("name").get<std::string>() + ": " + problem);
  }
  drawn.columns = {"",
                   "s = 4",
                   "16",
                   "64",
                   "256",
                   "slope",
                   "same error: time",
                   "same time: error",
                   "same error: rays",
                   "bias",
                   "pixels: median",
                   "99 % below",
                   "largest",
                   "samples on black"};
  for (const json& curve : all.at("curves")) {
    if (!all.contains("codes")) drawn.rows.push_back(row_of(curve, all.at("fastest")));
    enter_factors(curve, all, drawn);
  }
  for (const json& code : all.value("codes", json::array())) {
    if (code.at("curves").is_null()) continue;
    for (const json& curve : code.at("curves")) {
      drawn.rows.push_back(row_of(curve, code.at("fastest")));
      drawn.rows.back()[0].insert(0, code.at("name").get<std::string>() + ": ");
    }
  }
  drawn.numbers["fastest"] = all.at("curves").at(0).at("title");
  for (const json& curve : all.at("curves")) {
    if (curve.at("id") == all.at("fastest")) drawn.numbers["fastest"] = curve.at("title");
  }
  return drawn;
}

std::string method_of(const json& best) {
  return best.at("hemisphere").get<bool>() ? "hemisphere" : "lights";
}

std::vector<std::string> needs_row(const json& answer) {
  const json &best = answer.at("best"), &checked = answer.at("checked");
  const double error = checked.at("error").at(0), of_it = checked.at("error").at(1);
  return {std::to_string(answer.at("surfaces").get<int>()),
          method_of(best),
          std::to_string(best.at("samples").get<int>()),
          std::to_string(best.at("light_samples").get<int>()),
          std::to_string(best.at("bounces").get<int>()),
          best.at("bounces") > 2 ? fmt::format("{:g}", best.at("survival").get<double>()) : kDash,
          percent(best.at("bias")),
          digits(best.at("seconds")),
          digits(checked.at("seconds")),
          fmt::format("{:.2f} \u00b1 {:.2f} %", 100 * error, 100 * of_it)};
}

json without_roulette(const json& answer) {
  for (const json& option : answer.at("survivals")) {
    const bool none = !option.is_null() && option.at("survival") == 1;
    if (none && option.at("bounces") > 2) return option.at("times");
  }
  return nullptr;
}

json times_of(const json& option) { return option.is_null() ? json() : option.at("times"); }

// The bias with one bounce less than in the best settings.
std::string one_bounce_less(const json& answer) {
  const std::size_t bounces = answer.at("best").at("bounces");
  const json& bias = answer.at("bias");
  return bounces - 1 < bias.size() ? percent(bias.at(bounces - 1)) : kDash;
}

std::vector<std::string> left_out_row(const json& answer) {
  const double smooth = answer.at("smooth");
  return {times(times_of(answer.at("course"))),
          times(times_of(answer.at("hemisphere"))),
          times(without_roulette(answer)),
          times(answer.at("adaptive")),
          times(answer.at("without_tree")),
          smooth > 0 ? percent(smooth) : "0",
          one_bounce_less(answer)};
}

void enter_needs(const json& answer, const std::string& scene, Drawn& drawn) {
  const json& best = answer.at("best");
  const auto enter = [&](const char* name, const std::string& value) {
    drawn.numbers[scene + "." + name] = value;
  };
  enter("samples", best.at("samples").dump());
  enter("light_samples", best.at("light_samples").dump());
  enter("bounces", best.at("bounces").dump());
  enter("seconds", digits(best.at("seconds")));
  enter("surfaces", answer.at("surfaces").dump());
  const auto factor = [&](const char* name, const json& number) {
    if (!number.is_null()) enter(name, digits(number.is_array() ? number.at(0) : number));
  };
  factor("course", times_of(answer.at("course")));
  factor("hemisphere", times_of(answer.at("hemisphere")));
  factor("no_roulette", without_roulette(answer));
  factor("adaptive", answer.at("adaptive"));
  factor("no_tree", answer.at("without_tree"));
  enter("smooth", digits(100 * answer.at("smooth").get<double>()));
}

// Returns the number in a cell, without the signs for a reader: "1.5" of "1.5 %".
std::string bare(const std::string& cell) {
  return cell == kDash ? "" : cell.substr(0, cell.find_first_of(" \xc3"));
}

void write_table(const Drawn& drawn, const fs::path& file) {
  std::string csv;
  for (const std::string& column : drawn.columns) csv += (csv.empty() ? "" : ",") + column;
  for (const std::vector<std::string>& row : drawn.rows) {
    csv += '\n' + grader::report::csv_field(row[0]);
    for (std::size_t i = 1; i < row.size(); ++i) csv += ',' + bare(row[i]);
  }
  pt::write_file(file, csv + "\n");
}

Drawn draw_table(const Plan& plan, const Figure& figure, const fs::path& folder) {
  Drawn drawn;
  const bool needs = figure.kind == "needs";
  const std::vector<std::string> settings{"scene",
                                          "surfaces",
                                          "method",
                                          "s",
                                          "l",
                                          "m",
                                          "survival",
                                          "left out by m",
                                          "predicted seconds",
                                          "measured",
                                          "measured error"};
  const std::vector<std::string> parts{"scene",
                                       "course's settings",
                                       "hemisphere sampling",
                                       "no roulette",
                                       "adaptive",
                                       "no tree",
                                       "pixels whose normal is turned by 1°",
                                       "missing with m - 1"};
  drawn.columns = needs ? settings : parts;
  const std::vector<Measurement> all = plan.measurements(figure);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::string& scene = figure.scenes[i];
    std::vector<std::string> row{plan.scenes().short_name(scene)};
    if (is_there(plan, all[i], scene, drawn)) {
      const json answer = plan.measured().load(all[i]);
      if (answer.at("known") > kUnknown) row[0] += " (heavy tails)";
      const std::vector<std::string> cells = needs ? needs_row(answer) : left_out_row(answer);
      row.insert(row.end(), cells.begin(), cells.end());
      enter_needs(answer, scene, drawn);
    } else {
      row.resize(drawn.columns.size(), kDash);
    }
    drawn.rows.push_back(row);
  }
  drawn.tables = {figure.id + ".csv"};
  write_table(drawn, folder / drawn.tables[0]);
  return drawn;
}

Drawn draw_scene_needs(const Plan& plan, const Figure& figure, const fs::path& folder) {
  Drawn drawn;
  const Measurement measurement = plan.measurements(figure).at(0);
  if (!is_there(plan, measurement, figure.scenes.at(0), drawn)) return drawn;
  take_files(plan, measurement, figure.id, {"options.svg", "noise.svg", "bounces.svg"},
             {"options.csv", "noise.csv", "bounces.csv"}, folder, drawn);
  const json answer = plan.measured().load(measurement);
  const auto enter = [&](const char* name, const std::string& value) {
    drawn.numbers[name] = value;
  };
  for (const char* name : {"a", "b", "best_light_samples", "measured_light_samples"}) {
    enter(name, digits(answer.at(name)));
  }
  enter("c0", digits(1e6 * answer.at("c0").get<double>()));
  enter("c1", digits(1e6 * answer.at("c1").get<double>()));
  enter("off_the_line", digits(100 * answer.at("off_the_line").get<double>()));
  enter("off_the_time_line", digits(100 * answer.at("off_the_time_line").get<double>()));
  enter("error", digits(100 * answer.at("error").get<double>()));
  drawn.columns = {"most bounces, m", "missing radiance"};
  const json& bias = answer.at("bias");
  for (std::size_t m = 0; m < bias.size(); ++m) {
    const double part = bias[m];
    enter(fmt::format("m{}", m).c_str(), digits(100 * part));
    if (m > 0 && bias[m - 1] < answer.at("error").get<double>() / 10) continue;
    drawn.rows.push_back({std::to_string(m), percent(part)});
  }
  return drawn;
}

}  // namespace

Drawn draw_measured(const Plan& plan, const Figure& figure, const fs::path& folder) {
  if (figure.kind == "converge") return draw_converge(plan, figure, folder);
  if (figure.kind == "scene_needs") return draw_scene_needs(plan, figure, folder);
  const bool of_several = figure.kind == "needs" || figure.kind == "left_out";
  return of_several ? draw_table(plan, figure, folder) : Drawn{};
}

}  // namespace writeup
