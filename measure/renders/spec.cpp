#include "measure/renders/spec.h"

#include "pt/error.h"
#include "pt/render/choose_engine.h"

#include <map>

#include <fmt/format.h>

namespace measure {

using nlohmann::json;
using Direct = pt::PathSettings::Direct;

namespace {

// The names of the engines, as the options of ./run render have them.
const std::map<pt::Engine, std::string> kEngineNames{
    {pt::Engine::linear, "linear"}, {pt::Engine::task, "task"}, {pt::Engine::wide, "wide"}};

}  // namespace

json to_json(const Spec& spec) {
  json out{{"scene", spec.scene},
           {"size", {spec.width, spec.height}},
           {"frame", {spec.frame_width, spec.frame_height}},
           {"camera", spec.framing == pt::Framing::file ? "file" : "course"},
           {"samples", spec.samples},
           {"engine", kEngineNames.at(spec.engine)},
           {"seed", spec.seed},
           {"normals", spec.path.show_normals},
           {"light_samples", spec.path.light_samples},
           {"hemisphere", spec.path.direct == Direct::hemisphere},
           {"survival", spec.path.survival},
           {"bounces", {spec.path.from, spec.path.to}}};
  for (const pt::BounceRange& range : spec.ranges) {
    out["ranges"].push_back({range.from, range.to});
  }
  if (spec.adaptive) {
    out["adaptive"] =
        json{{"batch", spec.adaptive->batch}, {"tolerance", spec.adaptive->tolerance}};
  }
  return out;
}

namespace {

pt::Engine engine_of(const std::string& word) {
  for (const auto& [engine, name] : kEngineNames) {
    if (word == name) return engine;
  }
  throw pt::Error("there is no engine '" + word + "'");
}

}  // namespace

Spec spec_from_json(const json& in) {
  Spec spec;
  spec.scene = in.at("scene");
  spec.width = in.at("size").at(0);
  spec.height = in.at("size").at(1);
  spec.frame_width = in.at("frame").at(0);
  spec.frame_height = in.at("frame").at(1);
  if (in.at("camera") == "file") spec.framing = pt::Framing::file;
  spec.samples = in.at("samples");
  spec.engine = engine_of(in.at("engine"));
  spec.seed = in.at("seed");
  spec.path.show_normals = in.at("normals");
  spec.path.light_samples = in.at("light_samples");
  spec.path.direct = in.at("hemisphere").get<bool>() ? Direct::hemisphere : Direct::lights;
  spec.path.survival = in.at("survival");
  spec.path.from = in.at("bounces").at(0);
  spec.path.to = in.at("bounces").at(1);
  for (const json& range : in.value("ranges", json::array())) {
    spec.ranges.push_back({range.at(0), range.at(1)});
  }
  if (in.contains("adaptive")) {
    const json& adaptive = in.at("adaptive");
    spec.adaptive = pt::AdaptiveSettings{spec.samples, adaptive.at("batch").get<int>(),
                                         adaptive.at("tolerance").get<double>()};
  }
  return spec;
}

std::set<std::string> tasks_used(const Spec& spec) {
  std::set<std::string> tasks{"camera_ray", spec.adaptive ? "adaptive_pixel" : "estimate_pixel"};
  if (spec.engine != pt::Engine::wide) tasks.insert({"hit_triangle", "hit_sphere"});
  // This is also needed without a tree: the program tries the tree first.
  if (spec.engine == pt::Engine::task) tasks.insert(pt::kTreeTasks.begin(), pt::kTreeTasks.end());
  if (spec.path.show_normals || spec.path.to < 1) return tasks;
  tasks.insert({"trace_path", "diffuse_bsdf"});
  const bool hemisphere = spec.path.direct == Direct::hemisphere;
  tasks.insert(hemisphere ? "direct_hemisphere" : "direct_lights");
  return tasks;
}

std::string render_command(const Spec& spec, const std::string& output) {
  const pt::PathSettings& path = spec.path;
  std::string words = fmt::format("./run render {} -f {} -s {}", spec.scene, output, spec.samples);
  if (spec.adaptive) {
    words += fmt::format(" -a {} {:g}", spec.adaptive->batch, spec.adaptive->tolerance);
  }
  if (path.show_normals) {
    words += " --show normals";
  } else {
    words += fmt::format(" -l {} -m {}", path.light_samples, path.to);
    if (path.from == 1 && path.to == 1) words += " --show direct";
    if (path.from == path.to && path.to != 1)
      words += fmt::format(" --show bounce --bounce {}", path.to);
    if (path.from == 2 && path.to > 2) words += " --show indirect";
    if (path.direct == Direct::hemisphere) words += " -H";
    if (path.survival != pt::PathSettings{}.survival) {
      words += fmt::format(" --survival {:g}", path.survival);
    }
  }
  if (spec.frame_width != 480 || spec.frame_height != 360) {
    words += fmt::format(" -r {} {}", spec.frame_width, spec.frame_height);
  }
  if (spec.framing == pt::Framing::file) words += " --camera file";
  if (spec.engine != pt::Engine::task) words += " --engine " + kEngineNames.at(spec.engine);
  return words + fmt::format(" --seed {}", spec.seed);
}

}  // namespace measure
