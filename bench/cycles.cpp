#include "bench/cycles.h"

#include "grader/service/process/spawn.h"
#include "pt/error.h"
#include "pt/file.h"
#include "pt/image/image_io.h"

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <map>
#include <utility>

#include <fcntl.h>
#include <nlohmann/json.hpp>

namespace pt {

namespace {

using Json = nlohmann::json;

// The tolerance for the power of a light, compared with that of the surfaces that emit.
constexpr double kSamePower = 1e-6;
// A triangle counts as flat if the normals of its corners are closer to the face's than this.
constexpr double kFlat = 1e-9;

Json numbers(Vec3 v) { return {v.x, v.y, v.z}; }
Json numbers(Rgb c) { return {c.r, c.g, c.b}; }

bool is_flat(const Triangle& triangle) {
  const Vec3 n = normalize(geometric_normal(triangle));
  return std::min({dot(n, triangle.n0), dot(n, triangle.n1), dot(n, triangle.n2)}) > 1 - kFlat;
}

void append(Json& list, Vec3 v) {
  list.push_back(v.x);
  list.push_back(v.y);
  list.push_back(v.z);
}

// One group for each material, and for flat and smooth triangles.
Json triangle_groups(const Scene& scene) {
  std::map<std::pair<int, bool>, Json> groups;
  for (std::size_t i = 0; i < scene.primitives.triangles.size(); ++i) {
    const Triangle& triangle = scene.primitives.triangles[i];
    const bool flat = is_flat(triangle);
    Json& group = groups[{scene.material_of[i], flat}];
    group["material"] = scene.material_of[i];
    for (const Vec3 p : {triangle.p0, triangle.p1, triangle.p2}) append(group["corners"], p);
    if (flat) continue;
    for (const Vec3 n : {triangle.n0, triangle.n1, triangle.n2}) append(group["normals"], n);
  }
  Json all = Json::array();
  for (auto& [key, group] : groups) all.push_back(std::move(group));
  return all;
}

Json sphere_list(const Scene& scene) {
  Json all = Json::array();
  const Primitives& primitives = scene.primitives;
  for (std::size_t i = 0; i < primitives.spheres.size(); ++i) {
    const Sphere& sphere = primitives.spheres[i];
    all.push_back({{"center", numbers(sphere.center)},
                   {"radius", sphere.radius},
                   {"material", scene.material_of[primitives.triangles.size() + i]}});
  }
  return all;
}

Json material_list(const Scene& scene) {
  Json all = Json::array();
  for (const Material& material : scene.materials) {
    all.push_back({{"name", material.name},
                   {"albedo", numbers(material.albedo)},
                   {"emission", numbers(material.emission)}});
  }
  return all;
}

double area(const Triangle& triangle) { return 0.5 * length(geometric_normal(triangle)); }

// Area times luminance: the power without its factor pi.
double power_of_surfaces(const Scene& scene) {
  double power = 0;
  for (int i = 0; i < scene.primitives.size(); ++i) {
    const Primitives& all = scene.primitives;
    const double size = all.is_triangle(i) ? area(all.triangle(i))
                                           : 4 * kPi * all.sphere(i).radius * all.sphere(i).radius;
    power += size * luminance(scene.materials[scene.material_of[i]].emission);
  }
  return power;
}

// The lights that have no surface, and the power of all lights that have an area.
struct Lamps {
  Json list = Json::array();
  double power = 0;
  bool sky = false;
};

void add_light(Lamps& lamps, const Light& light) {
  if (const auto* rectangle = std::get_if<RectangleLight>(&light)) {
    lamps.power += length(cross(rectangle->u, rectangle->v)) * luminance(rectangle->radiance);
  } else if (const auto* sphere = std::get_if<SphereLight>(&light)) {
    lamps.power += 4 * kPi * sphere->radius * sphere->radius * luminance(sphere->radiance);
  } else if (const auto* mesh = std::get_if<MeshLight>(&light)) {
    lamps.power += mesh->area_up_to.back() * luminance(mesh->radiance);
  } else if (const auto* point = std::get_if<PointLight>(&light)) {
    lamps.list.push_back({{"kind", "point"},
                          {"position", numbers(point->position)},
                          {"intensity", numbers(point->intensity)}});
  } else if (const auto* sun = std::get_if<DirectionalLight>(&light)) {
    lamps.list.push_back({{"kind", "directional"},
                          {"direction", numbers(sun->direction)},
                          {"irradiance", numbers(sun->irradiance)}});
  } else {
    lamps.sky = true;
  }
}

Json lamp_list(const Scene& scene, const std::filesystem::path& file) {
  Lamps lamps;
  for (const Light& light : scene.lights) add_light(lamps, light);
  const double power = power_of_surfaces(scene);
  if (lamps.sky) {
    throw Error(file.string() + ": Cycles does not get the sky; use a scene without a sky");
  }
  if (std::abs(lamps.power - power) > kSamePower * power) {
    throw Error(file.string() +
                ": an area light has no surface that emits; Cycles would show it differently");
  }
  return lamps.list;
}

Json camera_of(const Camera& camera) {
  const Frame& frame = camera.camera_to_world;
  return {{"position", numbers(camera.position)},
          {"frame", {numbers(frame.x), numbers(frame.y), numbers(frame.z)}},
          {"hfov", camera.hfov_deg * (kPi / 180)},
          {"near", camera.near_clip},
          {"far", std::min(camera.far_clip, 1e30)}};
}

}  // namespace

std::string cycles_scene(const LoadedScene& loaded, const std::filesystem::path& file,
                         const Camera& camera, const CyclesSettings& settings) {
  const Scene& scene = loaded.scene;
  return Json{{"width", settings.width},
              {"height", settings.height},
              {"bounces", settings.bounces},
              {"threads", settings.threads},
              {"sphere_level", settings.sphere_level},
              {"materials", material_list(scene)},
              {"triangles", triangle_groups(scene)},
              {"spheres", sphere_list(scene)},
              {"lamps", lamp_list(scene, file)},
              {"camera", camera_of(camera)}}
      .dump();
}

namespace fs = std::filesystem;
using grader::base::Descriptor;

namespace {

// The last line that says what went wrong. Blender prints more lines after it.
std::string last_words(const fs::path& log) {
  std::ifstream file(log);
  std::string line, last;
  while (std::getline(file, line)) {
    if (line.find("Error") != std::string::npos || last.empty()) last = line;
  }
  return last.empty() ? "it printed nothing" : last;
}

grader::process::Child blender_with(const fs::path& blender, const fs::path& folder) {
  grader::process::Child child;
  child.command = {blender.string(),
                   "--background",
                   "--factory-startup",
                   "-noaudio",
                   "--python-exit-code",
                   "3",
                   "--python",
                   FIRSTLIGHT_ROOT "/bench/cycles.py",
                   "--",
                   (folder / "scene.json").string()};
  // Blender's own files stay in the folder, too.
  child.environment = {"PATH=/usr/bin:/bin", "LANG=C.UTF-8", "HOME=" + folder.string()};
  return child;
}

}  // namespace

Cycles::Cycles(const fs::path& blender, const fs::path& folder, const std::string& scene)
    : folder_(folder) {
  write_file(folder / "scene.json", scene);
  const Descriptor log(
      open((folder / "blender.log").c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666));
  if (!log.is_open()) throw Error("cannot write " + (folder / "blender.log").string());
  grader::base::Pipe jobs = grader::base::make_pipe(), answers = grader::base::make_pipe();
  grader::process::Child child = blender_with(blender, folder);
  child.descriptors = {jobs.read_end.number(), log.number(), log.number(),
                       answers.write_end.number()};
  std::signal(SIGPIPE, SIG_IGN);  // if Blender is gone, reading its answer fails
  process_ = grader::process::spawn(child);
  jobs_ = std::move(jobs.write_end);
  answers_.reset(fdopen(dup(answers.read_end.number()), "r"));
  answers.write_end.close();
  const nlohmann::json ready = answer();
  version_ = ready["version"];
  start_seconds_ = ready["seconds"];
}

Cycles::~Cycles() { grader::process::kill_child(process_); }

nlohmann::json Cycles::answer() {
  std::string line;
  for (int c = std::fgetc(answers_.get()); c != EOF && c != '\n'; c = std::fgetc(answers_.get())) {
    line += static_cast<char>(c);
  }
  nlohmann::json parsed = nlohmann::json::parse(line, nullptr, false);
  if (parsed.is_discarded()) {
    throw Error("Blender ended: " + last_words(folder_ / "blender.log"));
  }
  return parsed;
}

TimedImage Cycles::render(int samples, std::uint32_t seed) {
  const fs::path picture = folder_ / "picture.exr";
  const std::string job =
      nlohmann::json{{"samples", samples}, {"seed", seed}, {"picture", picture.string()}}.dump() +
      '\n';
  [[maybe_unused]] const ssize_t written = write(jobs_.number(), job.data(), job.size());
  const double seconds = answer()["seconds"];
  TimedImage result{read_image(picture), seconds};
  fs::remove(picture);
  return result;
}

}  // namespace pt
