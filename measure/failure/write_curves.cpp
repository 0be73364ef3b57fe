#include "measure/failure/write_curves.h"

#include "pt/error.h"
#include "pt/file.h"

#include <algorithm>

#include <nlohmann/json.hpp>

namespace measure::failure {

namespace {

namespace check = grader::check;
using nlohmann::json;

// NaN becomes null.
json to_json(const check::MeasuredPlace& at) {
  return {{"place", at.place},     {"error", at.error},   {"noise", at.noise}, {"cases", at.cases},
          {"without", at.without}, {"reason", at.reason}, {"ended", at.ended}};
}

// The corners from left to right: [place, limit], at the curve's places and the promise's ends.
json to_json(const check::Promised& promised, const std::vector<double>& places) {
  const auto [least, most] = std::minmax(promised.first, promised.last);
  std::vector<double> at{least, most};
  for (const double place : places) {
    if (place > least && place < most) at.push_back(place);
  }
  std::ranges::sort(at);
  json corners = json::array();
  for (const double place : at) corners.push_back({place, promised.limit(place)});
  return {{"bonus", promised.bonus}, {"corners", corners}};
}

json to_json(const check::NamedCurve& named, const std::vector<check::MeasuredPlace>& measured) {
  const check::Curve& curve = named.curve;
  json all{{"name", named.name},      {"title", curve.title},     {"input", curve.input},
           {"error", curve.error},    {"source", curve.source},   {"methods", json::array()},
           {"places", json::array()}, {"promised", json::array()}};
  for (const check::Promised& promised : curve.promised) {
    all["promised"].push_back(to_json(promised, curve.places));
  }
  for (const check::Method& method : curve.methods) {
    all["methods"].push_back(
        {{"file", method.file}, {"title", method.title}, {"single", method.single}});
  }
  for (const check::MeasuredPlace& at : measured) {
    all["places"].push_back(to_json(at));
    if (curve.theory) all["places"].back()["theory"] = curve.theory(at.place);
  }
  return all;
}

}  // namespace

void write_curves(const std::string& path, const std::string& only,
                  const grader::check::CurveSettings& settings,
                  const std::function<void()>& begin) {
  json all = json::array();
  for (const check::NamedCurve& named : check::curves()) {
    if (!only.empty() && named.name != only) continue;
    all.push_back(to_json(named, check::measure(named.curve, settings, begin)));
  }
  if (!only.empty() && all.empty()) throw pt::Error("there is no curve '" + only + "'");
  pt::write_file(path, all.dump(1) + "\n");
}

}  // namespace measure::failure
