// cheapest SCENE: the settings that reach an error in the least time, with the tasks linked here.
#include "pt/end_of_program.h"
#include "pt/error.h"
#include "pt/render/choose_engine.h"
#include "pt/render/progress.h"
#include "pt/scene/load_collada.h"
#include "pt/todo_list.h"
#include "writeup/cheapest/options.h"
#include "writeup/cheapest/print.h"

#include <cstdio>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace writeup::cheapest {
namespace {

int run(int argc, const char* const* argv) {
  const Options options = parse_options(argc, argv);
  pt::LoadedScene loaded = pt::load_collada(options.scene, {options.lambertian});
  for (const std::string& note : loaded.notes) fmt::print(stderr, "{}\n", note);
  require_supported(loaded, options.scene);
  if (loaded.scene.lights.empty()) {
    throw pt::Error(options.scene.string() +
                    ": the scene has no light; add one, or give a surface an emission");
  }
  if (!options.out.empty()) std::filesystem::create_directories(options.out);
  pt::print_no_todo();
  choose_engine(loaded.scene, options.engine, 4);
  const pt::View view{loaded.scene,
                      frame_camera(loaded, options.framing, options.width, options.height),
                      {},
                      options.width,
                      options.height};
  pt::Progress progress;
  Study study(view, options.threads, options.seed, options.seconds,
              [&](double part) { progress.show(part); });
  if (const auto unwritten = pt::todo_list(); !unwritten.empty()) {
    progress.clear();
    throw pt::Error(fmt::format("not written yet: {}; nothing can be measured without",
                                fmt::join(unwritten, ", ")));
  }
  const Answer answer = find_cheapest(study, view, options.error);
  progress.clear();
  fmt::print("{}", to_text(answer, options, loaded.scene));
  if (!options.out.empty()) write_charts(answer, options, options.out);
  return 0;
}

}  // namespace
}  // namespace writeup::cheapest

int main(int argc, char** argv) {
  try {
    const int status = writeup::cheapest::run(argc, argv);
    pt::flush_standard_output();
    return status;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", pt::sentence_of(error).c_str());
    return 2;
  }
}
