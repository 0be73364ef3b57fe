#include "view/worker/json.h"

#include <cmath>

namespace view {

using nlohmann::json;

namespace {

json to_json(const Draw& draw) {
  return {{"light", draw.light},
          {"wi", view::to_json(draw.sample.wi)},
          {"distance", view::to_json(draw.sample.distance)},
          {"radiance", view::to_json(draw.sample.radiance)},
          {"pdf", view::to_json(draw.sample.pdf)},
          {"cos", view::to_json(draw.cosine)},
          {"traced", draw.was_traced},
          {"hidden", draw.is_hidden},
          {"hit", draw.hit}};
}

json to_json(const Direct& direct) {
  json draws = json::array();
  for (const Draw& draw : direct.draws) draws.push_back(to_json(draw));
  return {{"task", std::string(direct.task)},
          {"samples", direct.samples},
          {"light", view::to_json(direct.light)},
          {"draws", std::move(draws)}};
}

// The hit at this point, for a question about it (Answers::disk).
json met_of(const Bounce& bounce) {
  const pt::Vec3 o = bounce.met_by.origin, d = bounce.met_by.direction, n = bounce.met.n;
  json numbers = json::array();
  for (const double number : {o.x, o.y, o.z, d.x, d.y, d.z, bounce.met.t, n.x, n.y, n.z}) {
    numbers.push_back(view::to_json(number));
  }
  numbers.push_back(bounce.met.primitive);
  return numbers;
}

json to_json(const Bounce& bounce) {
  const pt::SurfacePoint& point = bounce.point;
  json drawn = json::array();
  for (const double xi : bounce.drawn) drawn.push_back(view::to_json(xi));
  json result{{"p", view::to_json(point.p)},
              {"primitive", bounce.primitive},
              {"met", met_of(bounce)},
              {"n", view::to_json(point.n)},
              {"wo", view::to_json(point.wo)},
              {"x", view::to_json(point.frame.x)},
              {"y", view::to_json(point.frame.y)},
              {"albedo", view::to_json(point.albedo)},
              {"direct", bounce.direct.empty() ? json() : to_json(bounce.direct[0])},
              {"drawn", std::move(drawn)},
              {"throughput", view::to_json(bounce.throughput)},
              {"survival", view::to_json(bounce.survival)},
              {"part", view::to_json(bounce.part)}};
  if (!bounce.next.empty()) {
    const pt::BsdfSample& next = bounce.next[0];
    result["local"] = view::to_json(next.wi);
    result["wi"] = view::to_json(point.frame.to_world(next.wi));
    result["f"] = view::to_json(next.f);
    result["cos"] = view::to_json(std::abs(next.wi.z));
    result["pdf"] = view::to_json(next.pdf);
  }
  if (bounce.ray) result["way"] = view::to_json(bounce.ray->direction);
  return result;
}

json to_json(const std::vector<Finding>& findings) {
  json all = json::array();
  for (const Finding& finding : findings) {
    all.push_back({{"bounce", finding.bounce},
                   {"cell", finding.cell},
                   {"task", finding.task},
                   {"promise", finding.promise},
                   {"text", finding.text}});
  }
  return all;
}

json to_json(const Path& path) {
  json bounces = json::array();
  for (const Bounce& bounce : path.bounces) bounces.push_back(to_json(bounce));
  const pt::Rgb sum = sum_of_parts(path);
  return {{"at", {path.at.x, path.at.y}},
          {"origin", view::to_json(path.ray.origin)},
          {"direction", view::to_json(path.ray.direction)},
          {"bounces", std::move(bounces)},
          {"emission", view::to_json(path.emission)},
          {"sum", view::to_json(sum)},
          {"traced", view::to_json(path.traced)},
          {"same", adds_up(path)},
          {"one", path.is_one && !path.lost_point},
          {"value", view::to_json(path.value)},
          {"findings", to_json(path.findings)}};
}

}  // namespace

json to_json(double value) {
  if (std::isnan(value)) return "nan";
  if (std::isinf(value)) return value > 0 ? "inf" : "-inf";
  return value;
}
json to_json(pt::Vec3 v) { return {to_json(v.x), to_json(v.y), to_json(v.z)}; }
json to_json(pt::Rgb color) { return {to_json(color.r), to_json(color.g), to_json(color.b)}; }

json to_json(const PixelPaths& pixel) {
  json paths = json::array();
  for (const Path& path : pixel.paths) paths.push_back(to_json(path));
  json values = json::array();
  for (const pt::Rgb& value : pixel.values) values.push_back(to_json(value));
  return {{"mean", to_json(pixel.mean)},
          {"samples", pixel.samples},
          {"values", std::move(values)},
          {"paths", std::move(paths)},
          {"findings", to_json(pixel.findings)}};
}

json to_json(const pt::Camera& camera) {
  return {{"position", to_json(camera.position)},
          {"x", to_json(camera.camera_to_world.x)},
          {"y", to_json(camera.camera_to_world.y)},
          {"z", to_json(camera.camera_to_world.z)},
          {"hfov", camera.hfov_deg},
          {"vfov", camera.vfov_deg}};
}

}  // namespace view
