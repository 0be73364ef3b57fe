#include "pt/scene/load_collada.h"

#include "pt/error.h"
#include "pt/geometry/spawn_ray.h"
#include "pt/scene/collada/lights.h"
#include "pt/scene/collada/nodes.h"
#include "pt/scene/collada/numbers.h"
#include "pt/scene/collada/surfaces.h"
#include "pt/scene/collada/transforms.h"
#include "pt/scene/field_of_view.h"
#include "pt/scene/frame_camera.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

#include <tinyxml2.h>

namespace pt {

namespace {

bool is_angle(double degrees) { return degrees > 0 && degrees < 180; }

std::optional<double> optional_fov(const Document& document, const XMLElement& perspective,
                                   const char* name) {
  const std::optional<double> fov = child_number(document, perspective, name);
  if (fov && !is_angle(*fov)) {
    document.fail(perspective, std::string(name) + " is " + shown(*fov) +
                                   " degrees; write an angle between 0 and 180");
  }
  return fov;
}

// A camera without a position. If the file states only one field of view, the other follows from
// the aspect ratio, which is 4:3 if the file has none.
FileCamera read_perspective(const Document& document, const XMLElement& perspective) {
  FileCamera camera;
  const std::optional<double> x = optional_fov(document, perspective, "xfov");
  const std::optional<double> y = optional_fov(document, perspective, "yfov");
  double aspect = child_number(document, perspective, "aspect_ratio").value_or(4.0 / 3);
  if (!(aspect > 0)) {
    document.note("a camera has an aspect_ratio of " + shown(aspect) + ": 4:3 is taken.");
    aspect = 4.0 / 3;
  }
  if (!x && !y) document.fail(perspective, "<perspective> has no xfov; add it, in degrees");
  camera.hfov_deg = x ? *x : fov_from(half_tangent(*y) * aspect);
  camera.vfov_deg = y ? *y : fov_from(half_tangent(*x) / aspect);
  if (!is_angle(camera.hfov_deg) || !is_angle(camera.vfov_deg)) {
    document.fail(perspective,
                  "the fields of view leave (0, 180) degrees; correct the aspect_ratio");
  }
  camera.near_clip = child_number(document, perspective, "znear").value_or(0);
  camera.far_clip = child_number(document, perspective, "zfar").value_or(kInfinity);
  if (!(camera.near_clip >= 0 && camera.near_clip < camera.far_clip)) {
    document.note(
        "a camera has znear and zfar that do not satisfy 0 <= znear < zfar: it clips nothing.");
    camera.near_clip = 0;
    camera.far_clip = kInfinity;
  }
  return camera;
}

std::optional<FileCamera> read_fields(const Document& document, const XMLElement& element) {
  const XMLElement& common = document.child(document.child(element, "optics"), "technique_common");
  if (const XMLElement* perspective = common.FirstChildElement("perspective")) {
    return read_perspective(document, *perspective);
  }
  document.note("camera " + label(element) + " has no perspective and is ignored.");
  return std::nullopt;
}

// The frame keeps the direction in which the camera looks; its up is turned to a right angle.
Frame camera_frame(const Document& document, const Instance& instance) {
  const Vec3 backwards = instance.to_world.z;
  if (!std::isnormal(length_squared(backwards))) {
    document.fail(*instance.node,
                  "camera " + label(*instance.node) +
                      " looks nowhere: its z axis has no length; correct its matrix");
  }
  return upright_frame(
      document, normalize(backwards), instance.to_world.y,
      "camera " + label(*instance.node) + " has no up direction of its own: y is up.");
}

// The last camera of the scene that has a perspective, if there is one.
std::optional<FileCamera> read_camera(const Document& document,
                                      const std::vector<Instance>& cameras) {
  std::optional<FileCamera> last;
  std::unordered_map<const XMLElement*, std::optional<FileCamera>> fields;
  int perspectives = 0;
  for (const Instance& instance : cameras) {
    const auto [known, is_new] = fields.try_emplace(instance.target);
    std::optional<FileCamera>& camera = known->second;
    if (is_new) camera = read_fields(document, *instance.target);
    if (!camera) continue;
    last = camera;
    last->position = instance.to_world.translation;
    last->backwards = instance.to_world.z;
    last->camera_to_world = camera_frame(document, instance);
    ++perspectives;
  }
  if (perspectives > 1) {
    document.note("the file has " + std::to_string(perspectives) + " cameras: the last is taken.");
  }
  return last;
}

// The lights of the file, or a sky where it has none. A spot is left out where another light is asked for.
void choose_lights(const Document& document, const LoadOptions& options, LoadedScene& loaded) {
  std::vector<Light>& lights = loaded.scene.lights;
  for (Light& light : lights) {
    auto* area = std::get_if<RectangleLight>(&light);
    if (area != nullptr) area->as_in_cs184 = options.light == LightChoice::course;
  }
  const bool one_more = options.light == LightChoice::sky || options.light == LightChoice::camera;
  if (one_more) loaded.unsupported_lights.clear();
  loaded.light = options.light;
  loaded.has_own_light = !lights.empty() || !loaded.unsupported_lights.empty();
  if (options.light == LightChoice::sky || (lights.empty() && !one_more)) {
    lights.push_back(AmbientLight{{1, 1, 1}});
  }
  if (loaded.has_own_light || one_more) return;
  document.note(std::string("the file has no light") +
                (loaded.ignores_emission
                     ? " (emission colours in profile_COMMON are ignored; --common-emission makes "
                       "them shine)"
                     : "") +
                ": a white sky lights it from above; --light camera puts a lamp at the camera.");
}

// Rays start off their surface by kOffset times the distance of the surface from the world's origin.
void note_on_distance(const Document& document, const LoadedScene& loaded) {
  constexpr double kVisible = 1e-3;  // of the scene's size
  const Box box = bounds(loaded.scene.primitives);
  const double size = max_abs(box.extent());
  double far = std::max(max_abs(box.min), max_abs(box.max));
  if (loaded.camera && loaded.camera->sees_surfaces) {
    far = std::max(far, max_abs(loaded.camera->position));
  }
  if (!(kOffset * far > kVisible * size)) return;
  document.note("the scene or its camera is " + shown(far / size) +
                " times the scene's size from the world's origin: rays start " +
                shown(kOffset * far / size) +
                " of that size off their surfaces, so that light is wrong in details of this size; "
                "move the scene to the origin, or scale its parts.");
}

// Notes are of one kind if they differ in names and numbers alone.
std::string kind_of(const std::string& note) {
  std::string kind;
  bool is_name = false;
  for (const char c : note) {
    if (c == '\'') is_name = !is_name;
    if (!is_name && std::string_view("0123456789.-+e ").find(c) == std::string_view::npos)
      kind += c;
  }
  return kind;
}

// The first note of each kind, and how many others differ from it. A file can have 100,000 nodes or
// materials with the same fault.
std::vector<std::string> once_per_kind(const std::vector<std::string>& notes) {
  std::vector<std::string> first;
  std::unordered_map<std::string, std::unordered_set<std::string_view>> kinds;
  for (const std::string& note : notes) {
    std::unordered_set<std::string_view>& kind = kinds[kind_of(note)];
    if (kind.empty()) first.push_back(note);
    kind.insert(note);
  }
  for (std::string& note : first) {
    const std::size_t more = kinds.at(kind_of(note)).size() - 1;
    if (more > 0) note += " (" + std::to_string(more) + " more like this.)";
  }
  return first;
}

// The notes say what the scene would have shown.
[[noreturn]] void fail_without_surface(const Document& document,
                                       const std::vector<std::string>& notes) {
  std::string reasons;
  for (const std::string& note : once_per_kind(notes)) reasons += " " + note;
  document.fail(document.root(),
                "the scene shows no surface; " +
                    (reasons.empty() ? std::string("put an <instance_geometry> in it")
                                     : "change what these notes name:" + reasons));
}

}  // namespace

LoadedScene load_collada(const std::filesystem::path& file, const LoadOptions& options) {
  std::vector<std::string> notes;
  const Document document(file, notes);
  const Instances instances = read_nodes(document);
  LoadedScene loaded;
  // Exporters state their name, and people do not.
  const std::string_view tool =
      trimmed_text(find_below(&document.root(), {"asset", "contributor", "authoring_tool"}));
  loaded.exported = !tool.empty();
  loaded.has_asset = document.root().FirstChildElement("asset") != nullptr;
  // Files without materials or lights of the course's own are known by the program that its
  // handouts were exported with.
  loaded.is_course = document.has_course_profile() || tool.starts_with("Blender 2.74");
  loaded.front = instances.front;
  loaded.camera = read_camera(document, instances.cameras);

  Surfaces surfaces = read_surfaces(document, instances.geometries, options);
  loaded.scene = std::move(surfaces.scene);
  const Primitives& primitives = loaded.scene.primitives;
  if (primitives.size() == 0) fail_without_surface(document, notes);
  LightNodes nodes = read_lights(document, instances.lights, bounds(primitives));
  loaded.scene.lights = merge_lights(document, surfaces.emitters, nodes.nodes);
  loaded.unsupported_lights = std::move(nodes.unsupported);
  loaded.ignores_emission = surfaces.ignores_emission;
  choose_lights(document, options, loaded);
  if (loaded.camera) loaded.camera->sees_surfaces = sees_surfaces(*loaded.camera, primitives);
  note_on_distance(document, loaded);
  document.note_on_the_whole();
  loaded.notes = once_per_kind(notes);
  assert(std::ssize(loaded.scene.material_of) == primitives.size());
  return loaded;
}

void require_supported(const LoadedScene& loaded, const std::filesystem::path& file) {
  for (const Material& material : loaded.scene.materials) {
    if (material.unsupported.empty()) continue;
    throw Error(file.string() + ": material '" + material.name + "' is a " + material.unsupported +
                " material, which light transport here does not model; give --show normals, or "
                "--lambertian to treat it as diffuse");
  }
  for (const std::string& light : loaded.unsupported_lights) {
    throw Error(file.string() + ": " + light +
                " is a kind that light transport here does not model; make it a point or area "
                "light, or give --light sky to leave it out, or --show normals");
  }
}

}  // namespace pt
