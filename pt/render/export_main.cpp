// export: writes a scene in a format that another renderer reads.
#include "pt/command_line.h"
#include "pt/render/options.h"
#include "pt/scene/export/export.h"
#include "pt/scene/load_collada.h"

#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

int main(int argc, char** argv) {
  CLI::App app(
      "Writes a scene for another renderer: pbrt-v4, Mitsuba 3, Blender's Cycles, or your own.",
      "./run export");
  std::filesystem::path scene, folder;
  pt::SceneFormat format = pt::SceneFormat::plain;
  pt::Framing framing = pt::Framing::file;
  std::vector<int> size{480, 360};
  int depth = 5, samples = 64;
  app.add_option("SCENE", scene, "a COLLADA file")->required()->check(CLI::ExistingFile);
  app.add_option("--to", format, "plain (a line per thing), pbrt, mitsuba or blender")
      ->required()
      ->transform(CLI::CheckedTransformer(pt::kSceneFormats).description(""))
      ->type_name("plain|pbrt|mitsuba|blender");
  app.add_option("FOLDER", folder, "a folder for its files; made if it is missing")->required();
  app.add_option("-r,--size", size, "width and height in pixels, default 480 360")
      ->expected(2)
      ->allow_extra_args(false)
      ->check(CLI::Range(1, 16384))
      ->type_name("W H");
  app.add_option("--camera", framing, "file, fit or course, as for ./run render; default file")
      ->transform(CLI::CheckedTransformer(pt::kFramingWords).description(""))
      ->type_name("course|fit|file")
      ->default_str("file");
  app.add_option("-m,--bounces", depth, "the last bounce; 1 is direct light")
      ->check(CLI::Range(0, 100))
      ->capture_default_str();
  app.add_option("-s,--samples", samples, "per pixel")
      ->check(CLI::Range(1, 1 << 20))
      ->capture_default_str();
  return pt::run_command_line(app, argc, argv, [&] {
    const pt::LoadedScene loaded = pt::load_collada(scene);
    for (const std::string& note : loaded.notes) fmt::print(stderr, "{}\n", note);
    pt::require_supported(loaded, scene);
    std::filesystem::create_directories(folder);
    const auto file =
        pt::export_scene({loaded.scene, pt::frame_camera(loaded, framing, size[0], size[1]),
                          size[0], size[1], depth, samples},
                         format, folder, scene.string());
    fmt::print("wrote {}\n", file.string());
    return 0;
  });
}
