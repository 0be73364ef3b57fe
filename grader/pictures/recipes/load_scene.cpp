// Separate from recipes.cpp, so that programs which only read recipes need no renderer.
#include "grader/pictures/recipes/recipes.h"

namespace grader::pictures {

RecipeScene load_scene(const Recipe& recipe, pt::Engine engine) {
  pt::LoadedScene loaded = pt::load_collada(recipe.scene, recipe.load);
  if (!recipe.settings.show_normals) pt::require_supported(loaded, recipe.scene);
  const pt::Camera camera = pt::frame_camera(loaded, recipe.framing, recipe.width, recipe.height);
  add_camera_light(loaded, camera);
  loaded.scene.tracer = pt::Tracer(engine, loaded.scene.primitives);
  return {std::move(loaded.scene), camera};
}

pt::View view(const Recipe& recipe, const RecipeScene& scene) {
  return {scene.scene, scene.camera, recipe.settings, recipe.width, recipe.height};
}

}  // namespace grader::pictures
