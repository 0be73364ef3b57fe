#include "measure/failure/print.h"

#include <nlohmann/json.hpp>

namespace measure::failure {

namespace {

using nlohmann::json;

// An error that is not a number becomes null.
json to_json(const Point& point) {
  return {{"place", point.place}, {"error", point.error},     {"noise", point.noise},
          {"cases", point.cases}, {"without", point.without}, {"reason", point.reason}};
}

json to_json(const Charts& charts, const Chart& chart) {
  json all{{"slug", chart.slug},     {"name", chart.name},       {"title", chart.title},
           {"input", chart.input},   {"error", chart.error},     {"source", chart.source},
           {"lines", json::array()}, {"promised", json::array()}};
  for (const Promised& promised : chart.promised) {
    json corners = json::array();
    for (const auto& [place, limit] : promised.corners) corners.push_back({place, limit});
    all["promised"].push_back({{"bonus", promised.bonus}, {"corners", corners}});
  }
  for (std::size_t i = 0; i < charts.lines.size(); ++i) {
    if (!is_named(charts, chart, i)) continue;
    json points = json::array();
    for (const Point& point : chart.points[i]) points.push_back(to_json(point));
    all["lines"].push_back(
        {{"id", id_of(charts.lines[i])}, {"title", charts.lines[i].title}, {"points", points}});
  }
  all["broken"] = json::array();
  for (const BrokenPromise& broken : broken_promises(charts, chart)) {
    all["broken"].push_back({{"id", id_of(charts.lines[broken.line])},
                             {"bonus", broken.bonus},
                             {"place", broken.place}});
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

}  // namespace measure::failure
