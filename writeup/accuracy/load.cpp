#include "writeup/accuracy/load.h"

#include "pt/end_of_program.h"
#include "pt/error.h"
#include "pt/render/choose_engine.h"
#include "pt/todo_list.h"

#include <cstdio>

#include <fmt/format.h>

namespace writeup::accuracy {

namespace {

constexpr int kMaxLeaf = 4;  // as ./run render has it

}  // namespace

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

int run_program(int (*run)(int, const char* const*), int argc, const char* const* argv) {
  try {
    const int status = run(argc, argv);
    pt::flush_standard_output();
    return status;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", pt::sentence_of(error).c_str());
    return 2;
  }
}

}  // namespace writeup::accuracy
