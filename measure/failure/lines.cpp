#include "measure/failure/lines.h"

#include "grader/base/files.h"
#include "grader/base/parallel.h"
#include "grader/base/sha256.h"
#include "grader/service/judging/alone.h"
#include "grader/service/judging/ask_battery.h"
#include "grader/service/process/run_command.h"
#include "grader/service/sandbox/box.h"
#include "grader/tasks.h"
#include "pt/error.h"
#include "pt/file.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <optional>

#include <nlohmann/json.hpp>

namespace measure::failure {

namespace {

namespace fs = std::filesystem;
namespace base = grader::base;
namespace build = grader::build;
namespace judging = grader::judging;
using nlohmann::json;

constexpr std::chrono::seconds kMaxTime{900};
constexpr double kOfLook = 3;  // a look takes one place of so many (Request::coarse)

std::string folder_of(const build::Config& config, const build::TaskConfig& task) {
  return config.root + "/grader/tasks/" + task.slug + "/";
}

// The source file of a line.
std::string file_of(const build::Config& config, const build::TaskConfig& task,
                    const CurveLine& line) {
  const std::string wrong = "wrong/";
  if (!line.file.starts_with(wrong)) return folder_of(config, task) + line.file + ".cpp";
  return grader::mistake_file(config.root, task.slug, line.file.substr(wrong.size()));
}

// It measures the task's curves, and searches (measure/failure/stability_of_task.cpp).
std::string program_of(const build::TaskConfig& task) {
  return base::programs_folder() + "/../measure/stability." + task.slug;
}

// It contains the reference (measure/failure/search_here.cpp), so it needs the reference's sources.
std::string search_program_of(const build::TaskConfig& task) {
  return base::programs_folder() + "/../measure/search." + task.slug;
}

// The line's compiled code. An unusable object has an error or a reason for its rejection.
judging::Judged compiled(const build::Config& config, const build::Builder& builder,
                         const build::TaskConfig& task, const Request& request,
                         const CurveLine& line) {
  judging::Judged judged = judging::not_judged(config, task);
  if (line.kind == CurveLine::Kind::reference) {
    judged.object.path = task.reference.at(0);
    judged.object.key = base::stamp(judged.object.path);
    return judged;
  }
  if (line.kind == CurveLine::Kind::submission) {
    judging::GradeRequest own = request.judge;
    own.submission = request.submission;
    std::vector<judging::Judged> one{judged};
    judging::compile_all(builder, own, one);
    if (!one[0].object.ok() && one[0].object.error.empty()) {
      one[0].object.error = one[0].result.reason;
    }
    return one[0];
  }
  const std::string text = pt::read_file(file_of(config, task, line));
  judged.object = builder.compile(task, line.single ? "#define REAL float\n" + text : text);
  return judged;
}

// A worker for one line, or an error with the reason why there is none.
build::Built worker_of(const build::Config& config, const build::Builder& builder,
                       const build::TaskConfig& task, const Request& request,
                       const CurveLine& line) {
  const judging::Judged judged = compiled(config, builder, task, request, line);
  const build::Built& object = judged.object;
  if (!object.ok() || !object.rejected.empty()) {
    build::Built none;
    none.error = object.rejected.empty() ? object.error : object.rejected;
    return none;
  }
  return judging::link_alone(config, builder, judged, judging::Elsewhere::answers);
}

// The limit in seconds per curve, for a submission that is slow at every call.
constexpr double kSecondsOfCurve = 60;

// The curves of one line as JSON, or the reason why there are none.
Answered curves_of(const build::Config& config, const build::Builder& builder,
                   const build::TaskConfig& task, const Request& request, const CurveLine& line) {
  const build::Built worker = worker_of(config, builder, task, request, line);
  if (!worker.error.empty()) return {json::array(), worker.error};
  const judging::Trial trial{task, worker, false, request.judge, {}};
  std::vector<std::string> words{"--seed", std::to_string(request.judge.seed), "--effort",
                                 std::to_string(request.effort)};
  if (request.coarse) words.push_back("--coarse");
  if (line.kind == CurveLine::Kind::submission) {
    const double seconds = kSecondsOfCurve * std::max(1.0, request.effort);
    words.insert(words.end(), {"--seconds", std::to_string(seconds)});
  }
  words.push_back("--curves");
  const judging::Written written =
      judging::ask_program(builder, program_of(task), trial, words, kMaxTime);
  if (!written.path.empty()) return {json::parse(pt::read_file(written.path)), ""};
  if (line.kind == CurveLine::Kind::reference) {
    throw pt::Error("the curves of " + task.slug + ": " + written.error);
  }
  return {json::array(), written.error};  // the other lines are still measured
}

// "the largest of 200 cases": what is drawn at each place; empty where that is one case.
std::string drawn_of(const json& curve) {
  int cases = 0;
  for (const json& at : curve.at("places")) cases = std::max(cases, at.at("cases").get<int>());
  if (cases < 2) return "";
  return "the " + curve.at("statistic").get<std::string>() + " of " + std::to_string(cases) +
         " cases";
}

std::vector<Point> points_of(const json& curve) {
  std::vector<Point> points;
  for (const json& at : curve.at("places")) {
    const json& error = at.at("error");
    points.push_back(
        {at.at("place"),
         error.is_null() ? std::numeric_limits<double>::quiet_NaN() : error.get<double>(),
         at.at("noise"), at.at("cases"), at.at("without"), at.at("reason"), at.at("ended")});
  }
  return points;
}

Chart chart_of(const build::TaskConfig& task, const json& curve) {
  Chart chart;
  chart.slug = task.slug;
  chart.name = curve.at("name");
  chart.title = curve.at("title");
  chart.input = curve.at("input");
  chart.error = curve.at("error");
  chart.source = curve.at("source");
  chart.drawn = drawn_of(curve);
  for (const json& at : curve.at("places")) {
    if (at.contains("theory")) chart.theory.push_back(at.at("theory"));
  }
  for (const json& from : curve.at("promised")) {
    Promised& promised = chart.promised.emplace_back();
    from.at("bonus").get_to(promised.bonus);
    for (const json& corner : from.at("corners")) {
      promised.corners.push_back({corner.at(0), corner.at(1)});
    }
  }
  return chart;
}

CurveLine line_of(const json& method) {
  return {CurveLine::Kind::method, method.at("title"), method.at("file"), method.at("single"), ""};
}

bool same(const CurveLine& a, const CurveLine& b) {
  return a.file == b.file && a.single == b.single;
}

std::vector<std::size_t> methods_of(const json& curve, const std::vector<CurveLine>& lines) {
  std::vector<std::size_t> found;
  for (const json& method : curve.at("methods")) {
    for (std::size_t i = 0; i < lines.size(); ++i) {
      if (same(lines[i], line_of(method))) found.push_back(i);
    }
  }
  return found;
}

// The time that was measured when the curves were, which may be long ago.
double seconds_of(const json& curves) {
  double seconds = 0;
  for (const json& curve : curves) seconds += curve.at("seconds").get<double>();
  return seconds;
}

// The methods that the curves name, each once, and then the other right solutions. The learners'
// edition does not have their files.
std::vector<CurveLine> kept_solutions(const build::Config& config, const build::TaskConfig& task,
                                      const json& curves, const Request& request) {
  const std::string folder = folder_of(config, task);
  std::vector<CurveLine> lines;
  const auto add = [&](const CurveLine& line) {
    const bool known =
        std::ranges::any_of(lines, [&](const CurveLine& l) { return same(l, line); });
    if (!known && fs::exists(file_of(config, task, line))) lines.push_back(line);
  };
  for (const json& curve : curves) {
    if (!request.methods) break;
    for (const json& method : curve.at("methods")) add(line_of(method));
  }
  if (!request.variants) return lines;
  for (const fs::path& file : base::sources_in(folder + "right")) {
    const std::string name = file.stem();
    std::string title = name;
    std::ranges::replace(title, '_', ' ');
    add({CurveLine::Kind::variant, title, "right/" + name, false, ""});
  }
  return lines;
}

}  // namespace

std::string id_of(const CurveLine& line) {
  if (line.kind == CurveLine::Kind::reference) return "reference";
  if (line.kind == CurveLine::Kind::submission) return "yours";
  return fs::path(line.file).filename().string() + (line.single ? "_single" : "");
}

bool is_named(const Charts& charts, const Chart& chart, std::size_t line) {
  const CurveLine::Kind kind = charts.lines[line].kind;
  return kind == CurveLine::Kind::reference || kind == CurveLine::Kind::submission ||
         std::ranges::count(chart.methods, line) > 0;
}

namespace {

// The limit at a place of the curve; nothing if there is no promise.
std::optional<double> limit_at(const Promised& promised, double place) {
  constexpr double kRounding = 1e-9;  // for numbers that were written and read again
  for (const auto& [at, limit] : promised.corners) {
    if (std::abs(place / at - 1) < kRounding) return limit;
  }
  return {};
}

bool is_broken(const Promised& promised, const Point& point) {
  const std::optional<double> limit = limit_at(promised, point.place);
  if (!limit || point.cases == 0) return false;
  return point.without > 0 || !(point.error <= *limit + kErrors * point.noise);
}

}  // namespace

std::vector<BrokenPromise> broken_promises(const Charts& charts, const Chart& chart) {
  std::vector<BrokenPromise> all;
  for (std::size_t i = 0; i < charts.lines.size(); ++i) {
    if (!is_shown(charts, chart, i)) continue;
    for (const Promised& promised : chart.promised) {
      if (promised.bonus && !is_named(charts, chart, i)) continue;
      const auto at = std::ranges::find_if(
          chart.points[i], [&](const Point& point) { return is_broken(promised, point); });
      if (at != chart.points[i].end()) all.push_back({i, promised.bonus, at->place});
    }
  }
  return all;
}

bool fails(const Charts& charts) {
  for (std::size_t i = 0; i < charts.lines.size(); ++i) {
    if (charts.lines[i].kind != CurveLine::Kind::submission) continue;
    if (!charts.lines[i].unusable.empty()) return true;
    for (const Chart& chart : charts.charts) {
      if (std::ranges::any_of(chart.points[i], &Point::ended)) return true;
      const std::vector<BrokenPromise> broken = broken_promises(charts, chart);
      if (std::ranges::any_of(
              broken, [&](const BrokenPromise& each) { return each.line == i && !each.bonus; })) {
        return true;
      }
    }
  }
  return false;
}

bool is_shown(const Charts& charts, const Chart& chart, std::size_t line) {
  return is_named(charts, chart, line) || charts.lines[line].file.starts_with("right/");
}

Answered search_task(const build::Config& config, const build::TaskConfig& task,
                     const Request& request, const Search& search, const CurveLine& line) {
  if (!config.no_reference.empty()) throw pt::Error(config.no_reference);
  const double seconds = 60 * search.minutes;
  std::vector<std::string> words{search_program_of(task)};
  if (line.kind != CurveLine::Kind::reference || !fs::exists(words[0])) {
    const build::Builder builder(config, request.judge.isolation.tier, request.judge.compile_limit);
    const build::Built worker = worker_of(config, builder, task, request, line);
    if (!worker.error.empty()) return {json::array(), worker.error};
    words = {program_of(task), "--worker", worker.path, "--isolation",
             std::string(1, grader::sandbox::letter(request.judge.isolation.tier))};
  }
  // judging::ask_program is not used, because each search goes on where the last one ended.
  words.insert(words.end(), {"--seed", std::to_string(request.judge.seed), "--seconds",
                             std::to_string(seconds), "--search", search.file});
  const grader::process::Child child{words, grader::sandbox::judges_environment(), {}, "", {}};
  const auto most = std::chrono::seconds(static_cast<long long>(60 + 4 * seconds));
  const auto result = grader::process::run_command(child, most);
  if (!result.ok()) throw pt::Error("the search of " + task.slug + ": " + result.output);
  return {json::parse(pt::read_file(search.file)), ""};
}

std::string charts_hash(const build::Config& config, const build::TaskConfig& task,
                        const Request& request) {
  std::string text = base::stamp("/proc/self/exe") + base::stamp(program_of(task));
  for (const std::string& object : task.reference) text += base::stamp(object);
  for (const char* kind : {"methods/", "right/", "mistakes.txt"}) {
    const std::string path = folder_of(config, task) + kind;
    if (fs::is_regular_file(path)) text += base::stamp(path);
    for (const fs::path& file : base::sources_in(path)) text += base::stamp(file.string());
  }
  if (!request.submission.empty()) {
    text += base::read_submitted(request.submission, task.part, task.slug).text;
  }
  return base::sha256(text);
}

Charts measure_task(const build::Config& config, const build::TaskConfig& task,
                    const Request& request, const std::function<void(double)>& expect) {
  if (!config.no_reference.empty()) throw pt::Error(config.no_reference);
  const build::Builder builder(config, request.judge.isolation.tier, request.judge.compile_limit);
  Charts charts;
  charts.lines.push_back({CurveLine::Kind::reference, "reference", "", false, ""});
  if (!request.submission.empty()) {
    charts.lines.push_back({CurveLine::Kind::submission, "yours", "", false, ""});
  }
  // A look at the reference's curves names the methods.
  Request look = request;
  look.coarse = true;
  const json seen = curves_of(config, builder, task, look, charts.lines[0]).answer;
  for (CurveLine& line : kept_solutions(config, task, seen, request)) {
    charts.lines.push_back(std::move(line));
  }
  const auto lines = static_cast<double>(charts.lines.size() - 1);
  const double one = (request.coarse ? 1 : kOfLook) * seconds_of(seen);
  expect(one * (1 + std::ceil(lines / request.judge.threads)));
  std::vector<json> found{curves_of(config, builder, task, request, charts.lines[0]).answer};
  for (const json& curve : found[0]) {
    charts.charts.push_back(chart_of(task, curve));
    charts.charts.back().methods = methods_of(curve, charts.lines);
  }
  found.resize(charts.lines.size());
  base::for_each(charts.lines.size() - 1, request.judge.threads, [&](std::size_t i) {
    CurveLine& line = charts.lines[i + 1];
    Answered curves = curves_of(config, builder, task, request, line);
    found[i + 1] = std::move(curves.answer);
    line.unusable = std::move(curves.unusable);
  });
  for (std::size_t c = 0; c < charts.charts.size(); ++c) {
    for (const json& curves : found) {
      charts.charts[c].points.push_back(curves.empty() ? std::vector<Point>{}
                                                       : points_of(curves.at(c)));
    }
  }
  return charts;
}

}  // namespace measure::failure
