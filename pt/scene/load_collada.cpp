#include "pt/scene/load_collada.h"

#include "pt/error.h"
#include "pt/scene/collada/cameras.h"
#include "pt/scene/collada/lights.h"
#include "pt/scene/collada/nodes.h"
#include "pt/scene/collada/surfaces.h"

#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include <tinyxml2.h>

namespace pt {

namespace {

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
  document.note_on_the_whole();
  loaded.notes = once_per_kind(notes);
  loaded.unsupported_lights = std::move(nodes.unsupported);
  loaded.ignores_emission = surfaces.ignores_emission;
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
                "light, or give --show normals");
  }
}

}  // namespace pt
