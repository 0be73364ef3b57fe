#pragma once

#include "pt/scene/camera.h"
#include "pt/scene/scene.h"

#include <filesystem>
#include <map>
#include <string>

// A loaded scene in the formats that other renderers read: camera, triangles with their normals, spheres, diffuse materials,
// lights. World space stays as it is (right-handed, y up); radiance, intensity and irradiance too.

namespace pt {

enum class SceneFormat {
  plain,    // scene.txt: a line per thing; to_plain says which
  pbrt,     // scene.pbrt, for pbrt-v4
  mitsuba,  // scene.xml for Mitsuba 3, and meshes in PLY
  blender,  // scene.json, for scripts/cycles.py
};

inline const std::map<std::string, SceneFormat> kSceneFormats{{"plain", SceneFormat::plain},
                                                              {"pbrt", SceneFormat::pbrt},
                                                              {"mitsuba", SceneFormat::mitsuba},
                                                              {"blender", SceneFormat::blender}};

// The scene with the camera of a picture.
struct ExportedView {
  const Scene& scene;
  Camera camera;
  int width = 0, height = 0;
  int depth = 5;     // the last bounce: 1 is direct light
  int samples = 64;  // per pixel, where the format has a default
};

// Writes the scene into the folder, which exists, and returns the file that the renderer reads. Throws Error for a light that only we can
// show: an area light without a surface, and where the format has no sky, a sky. `name` is the scene's, for that sentence.
std::filesystem::path export_scene(const ExportedView& view, SceneFormat format,
                                   const std::filesystem::path& folder, const std::string& name);

// The text of scene.txt, one thing per line, numbers separated by spaces:
//   camera POSITION X Y Z HFOV VFOV NEAR FAR     axes of the camera, which looks along -Z; whole angles in degrees
//   triangle P0 P1 P2 N0 N1 N2 ALBEDO EMISSION   emits on the side from which its corners run anticlockwise
//   sphere CENTER RADIUS ALBEDO EMISSION         emits outwards
//   point POSITION INTENSITY | directional DIRECTION IRRADIANCE | sky RADIANCE
std::string to_plain(const ExportedView& view);
std::string to_pbrt(const ExportedView& view);
// The parts of a mesh file, by its name, come with the text.
struct MitsubaScene {
  std::string xml;
  std::map<std::string, std::string> meshes;
};
MitsubaScene to_mitsuba(const ExportedView& view);
std::string to_blender(const ExportedView& view);

}  // namespace pt
