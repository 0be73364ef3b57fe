#include "pt/command_line.h"
#include "pt/file.h"
#include "scenes/collada_text.h"
#include "scenes/meshes.h"

#include <iostream>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace scenes {
namespace {

struct MeshRequest {
  std::string kind;
  int triangles = 0;
  int decimals = 6;
  bool room = false;
  std::string file;
};

// The command has only short options: a comment may not contain two hyphens in a row.
std::string comment(const MeshRequest& request, const Kind& kind) {
  return std::string(kind.purpose) +
         (request.room ? "\n     In the Cornell box."
                       : "\n     Open, under an even sky and a sun.") +
         " Made by: generate mesh -k " + request.kind + " -n " + std::to_string(request.triangles) +
         " -d " + std::to_string(request.decimals) + (request.room ? " -r" : "");
}

void generate_mesh(const MeshRequest& request) {
  for (const Kind& kind : kinds()) {
    if (kind.name != request.kind) continue;
    pt::check_target(request.file);
    const Mesh mesh = kind.make(request.triangles);
    const Setting setting = request.room ? Setting::room : Setting::open;
    pt::write_file(request.file,
                   collada_text(mesh, setting, request.decimals, comment(request, kind)));
    std::cout << request.file << ": " << mesh.faces.size() << " triangles\n";
  }
}

}  // namespace
}  // namespace scenes

int main(int argc, char** argv) {
  CLI::App app("One mesh, alone or in the Cornell box", "./run mesh");
  scenes::MeshRequest request;
  std::vector<std::string> names;
  for (const scenes::Kind& kind : scenes::kinds()) names.emplace_back(kind.name);

  app.add_option("-k,--kind", request.kind, "What it shows")
      ->required()
      ->check(CLI::IsMember(names));
  app.add_option("-n,--triangles", request.triangles,
                 "At most this many, and nearly: 100 to 10000000")
      ->required();
  app.add_option("-o,--output", request.file, "The file to write, .dae")->required();
  app.add_option("-d,--decimals", request.decimals, "Digits after the point")
      ->check(CLI::Range(3, 12))
      ->capture_default_str();
  app.add_flag("-r,--room", request.room, "Put it into the Cornell box");
  return pt::run_command_line(app, argc, argv, [&] {
    scenes::generate_mesh(request);
    return 0;
  });
}
