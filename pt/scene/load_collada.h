#pragma once

#include "pt/math/frame.h"
#include "pt/scene/scene.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace pt {

// A camera as the file has it, in world space: the frame has x to the right, y up and z backwards.
struct FileCamera {
  Vec3 position;
  Frame camera_to_world;
  Vec3 backwards{0, 0, 1};  // the image of its z axis: camera_to_world.z, of any length
  double hfov_deg = 50;     // whole angles, in (0, 180)
  double vfov_deg = 38;
  double near_clip = 0;
  double far_clip = kInfinity;
  bool sees_surfaces = true;  // between its clips, by a grid of rays through its whole field
};

// The light of a scene: the file's own (a sky where the file has none), the same with the density
// of the course's skeleton for rectangles, or the file's and one more. The sky is white above the
// horizon. The lamp at the camera is a point light, which add_camera_light adds.
enum class LightChoice { file, course, sky, camera };

struct LoadOptions {
  bool lambertian = false;  // treat materials outside the model as albedo 0.5, and say so in notes
  bool common_emission = false;  // let surfaces emit the emission colour of profile_COMMON
  LightChoice light = LightChoice::file;
};

struct LoadedScene {
  Scene scene;  // complete except for the tracer, which is not built
  std::optional<FileCamera> camera;
  bool exported = false;                  // a program wrote the file, as its <authoring_tool> says
  bool has_asset = false;                 // the file has the <asset> that would say so
  bool is_course = false;                 // one of the course's files, or a file in its dialect
  Vec3 front{0, 0, 1};                    // towards somebody who stands in front of the scene
  bool ignores_emission = false;          // a material has an emission colour in profile_COMMON
  bool has_own_light = true;              // else the file has no light, and a sky was added
  LightChoice light = LightChoice::file;  // as it was loaded
  std::vector<std::string> unsupported_lights;  // "spot light 'Lamp'": lights outside the model
  std::vector<std::string> notes;  // a sentence per kind of correction or ignored thing
};

// Reads a COLLADA 1.4.1 file; docs/scenes.md describes the dialect and the answer to each of its
// traps. The scene has at least one surface; its normals are unit vectors, its triangles have an
// area, its numbers are finite.
//
// Throws Error, "file:line: what is wrong; what to do", for anything it cannot read. A material or
// a light outside the model is not an error here: its scene can still be shown by its normals.
LoadedScene load_collada(const std::filesystem::path& file, const LoadOptions& options = {});

// Throws Error, with the file and the material or light, if the scene has any that is outside the
// model of light transport. Call it before you render anything but normals.
void require_supported(const LoadedScene& loaded, const std::filesystem::path& file);

}  // namespace pt
