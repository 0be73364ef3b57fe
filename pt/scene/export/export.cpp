#include "pt/scene/export/export.h"

#include "pt/error.h"
#include "pt/file.h"
#include "pt/scene/export/parts.h"

#include <algorithm>

namespace pt {
namespace {

void require_no_sky(const Scene& scene, const std::string& name, const char* format) {
  const bool has_sky = std::ranges::any_of(
      scene.lights, [](const Light& light) { return std::holds_alternative<AmbientLight>(light); });
  if (!has_sky) return;
  throw Error(name + ": the sky lights from above only and is not seen by the camera; " + format +
              " has no such light");
}

}  // namespace

std::filesystem::path export_scene(const ExportedView& view, SceneFormat format,
                                   const std::filesystem::path& folder, const std::string& name) {
  require_surfaces(view.scene, name);
  const auto written = [&](const char* file, const std::string& text) {
    write_file(folder / file, text);
    return folder / file;
  };
  if (format == SceneFormat::plain) return written("scene.txt", to_plain(view));
  if (format == SceneFormat::pbrt) {
    require_no_sky(view.scene, name, "pbrt");
    return written("scene.pbrt", to_pbrt(view));
  }
  if (format == SceneFormat::blender) {
    require_no_sky(view.scene, name, "Cycles");
    return written("scene.json", to_blender(view));
  }
  require_no_sky(view.scene, name, "Mitsuba");
  const MitsubaScene all = to_mitsuba(view);
  for (const auto& [file, mesh] : all.meshes) write_file(folder / file, mesh);
  return written("scene.xml", all.xml);
}

}  // namespace pt
