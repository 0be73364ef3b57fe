#include "measure/scene/load.h"

#include "pt/error.h"
#include "pt/render/choose_engine.h"
#include "pt/todo_list.h"

#include <fmt/format.h>

namespace measure::scene {

pt::LoadedScene load_scene(const Options& options) {
  pt::LoadedScene loaded = pt::load_collada(options.scene, {options.lambertian});
  require_supported(loaded, options.scene);
  if (loaded.scene.lights.empty()) {
    throw pt::Error(options.scene.string() +
                    ": the scene has no light; add one, or give a surface an emission");
  }
  if (!options.out.empty()) std::filesystem::create_directories(options.out);
  pt::silence_todo();
  choose_engine(loaded.scene, options.engine, kMaxLeaf);
  return loaded;
}

void print_notes(const pt::LoadedScene& loaded) {
  for (const std::string& note : loaded.notes) fmt::print(stderr, "{}\n", note);
}

}  // namespace measure::scene
