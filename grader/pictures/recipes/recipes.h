#pragma once

#include "pt/math/rgb.h"
#include "pt/scene/frame_camera.h"
#include "pt/scene/load_collada.h"
#include "pt/scene/tracer.h"
#include "pt/scene/view.h"
#include "pt/tasks/adaptive_pixel.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

// The pictures by which the grader judges. docs/recipes.md has the file's format.

namespace grader::pictures {

// One picture: its scene, camera, settings, and the tasks that it judges. The number of samples per
// pixel is not part of it, unless it is adaptive: the caller of the renderer chooses it (for goldens,
// usual_effort in make_golden.h). Goldens and verdicts take at least two at a time, so that all go
// through random points of the pixel.
struct Recipe {
  std::string name;             // also of its files in golden/: lower case, digits and underscores
  std::string title;            // its content, for a person
  std::filesystem::path scene;  // exists
  pt::Framing framing = pt::Framing::file;
  int width = 96;  // pixels
  int height = 72;
  pt::PathSettings settings;
  std::optional<pt::AdaptiveSettings> adaptive;
  std::uint64_t seed = 0;          // its own: 1 .. 2^31 - 1
  std::vector<std::string> tasks;  // the slugs of the tasks that it judges
  bool noisy = false;              // needs four times the samples
  // The variance of a sample that a right submission may have, over the golden's; 0: the usual 3,
  // or 6 if noisy. It is more if the contracts allow it: roulette and densities of many bounces add
  // up.
  double most_noise = 0;
  pt::LoadOptions load;            // scenes/recipes.json has the default
  std::optional<pt::Rgb> uniform;  // the radiance of every pixel, where theory knows it
};

// Reads scenes/recipes.json. Scenes are named relative to the file. Throws pt::Error, "file:line:
// what is wrong; what to do", if it is not JSON, and "file: recipe 'name': ..." for all other faults.
std::vector<Recipe> load_recipes(const std::filesystem::path& file);

// Throws pt::Error, which lists all names, if no recipe has this one.
const Recipe& find(const std::vector<Recipe>& recipes, const std::string& name);

// The slugs of all tasks, in the order of the course.
const std::vector<std::string>& task_slugs();

// The scene of a recipe, ready to be traced.
struct RecipeScene {
  pt::Scene scene;
  pt::Camera camera;
};

// Throws pt::Error if the scene cannot be read, or has no light and is not for normals.
RecipeScene load_scene(const Recipe& recipe, pt::Engine engine);

// The view refers to `scene`, which has to outlive it.
pt::View view(const Recipe& recipe, const RecipeScene& scene);

}  // namespace grader::pictures
