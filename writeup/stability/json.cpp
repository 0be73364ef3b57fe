#include "writeup/stability/print.h"

#include <nlohmann/json.hpp>

namespace writeup::stability {

namespace {

using nlohmann::json;

// An error that is not a number becomes null.
json to_json(const Point& point) {
  return {{"place", point.place},
          {"error", point.error},
          {"cases", point.cases},
          {"without", point.without},
          {"reason", point.reason}};
}

json to_json(const Charts& charts, const Chart& chart) {
  json all{{"slug", chart.slug},    {"name", chart.name},   {"title", chart.title},
           {"input", chart.input},  {"error", chart.error}, {"source", chart.source},
           {"lines", json::array()}};
  if (chart.promised_last > 0) {
    all["promised"] = {
        {"first", chart.promised_first}, {"last", chart.promised_last}, {"limit", chart.limit}};
  }
  for (std::size_t i = 0; i < charts.lines.size(); ++i) {
    if (!is_named(charts, chart, i)) continue;
    json points = json::array();
    for (const Point& point : chart.points[i]) points.push_back(to_json(point));
    all["lines"].push_back(
        {{"id", id_of(charts.lines[i])}, {"title", charts.lines[i].title}, {"points", points}});
  }
  return all;
}

}  // namespace

std::string to_json(const std::vector<Charts>& tasks, double cpu_seconds) {
  json all{{"cpu_seconds", cpu_seconds}, {"charts", json::array()}, {"unusable", json::array()}};
  for (const Charts& charts : tasks) {
    for (const Chart& chart : charts.charts) all["charts"].push_back(to_json(charts, chart));
    for (const CurveLine& line : charts.lines) {
      if (line.unusable.empty()) continue;
      all["unusable"].push_back({{"title", line.title}, {"reason", line.unusable}});
    }
  }
  return all.dump(1) + "\n";
}

}  // namespace writeup::stability
