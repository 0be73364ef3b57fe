#include "pt/scene/load_collada.h"

#include "pt/error.h"
#include "pt/scene/collada/cameras.h"
#include "pt/scene/collada/lights.h"
#include "pt/scene/collada/nodes.h"
#include "pt/scene/collada/surfaces.h"

#include <unordered_set>
#include <utility>

#include <tinyxml2.h>

namespace pt {

namespace {

// A node that is instanced several times causes the same notes every time.
void append_new(std::vector<std::string>& notes, const std::vector<std::string>& more) {
  std::unordered_set<std::string> known(notes.begin(), notes.end());
  for (const std::string& note : more) {
    if (known.insert(note).second) notes.push_back(note);
  }
}

// <asset><contributor><authoring_tool>: exporters write it, people do not.
bool names_authoring_tool(const XMLElement& root) {
  const XMLElement* at = root.FirstChildElement("asset");
  at = at ? at->FirstChildElement("contributor") : nullptr;
  at = at ? at->FirstChildElement("authoring_tool") : nullptr;
  return at != nullptr && at->GetText() != nullptr;
}

}  // namespace

LoadedScene load_collada(const std::filesystem::path& file, const LoadOptions& options) {
  const ColladaDocument document(file);
  Instances instances = read_nodes(document);
  LoadedScene loaded;
  loaded.exported = names_authoring_tool(document.root());
  loaded.has_asset = document.root().FirstChildElement("asset") != nullptr;
  loaded.camera = read_camera(document, instances.cameras, instances.notes);
  append_new(loaded.notes, instances.notes);

  Surfaces surfaces = read_surfaces(document, instances.geometries, options);
  if (surfaces.primitives.size() == 0) {
    document.fail(document.root(), "the scene shows no surface; put an <instance_geometry> in it");
  }
  LightNodes nodes = read_lights(document, instances.lights);
  SceneLights lights = merge_lights(surfaces.emitters, nodes.nodes);
  append_new(loaded.notes, surfaces.notes);
  append_new(loaded.notes, nodes.notes);
  append_new(loaded.notes, lights.notes);
  if (const std::string ids = document.note_on_ids(); !ids.empty()) loaded.notes.push_back(ids);

  loaded.scene.primitives = std::move(surfaces.primitives);
  loaded.scene.material_of = std::move(surfaces.material_of);
  loaded.scene.materials = std::move(surfaces.materials);
  loaded.scene.lights = std::move(lights.lights);
  loaded.unsupported_lights = std::move(nodes.unsupported);
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
