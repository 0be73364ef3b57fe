// convert: makes a COLLADA scene of a model in another format.
#include "pt/command_line.h"
#include "pt/file.h"
#include "pt/printable.h"
#include "pt/scene/export/convert/model.h"

#include <cerrno>
#include <cstdio>
#include <cstring>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace {

// Processor time for a model of that many bytes: assimp reads some ten times as fast.
rlim_t seconds_for(std::uintmax_t bytes) { return 5 + bytes / 1'000'000; }

// Runs `work` in a child process and returns its status: the library that reads models crashes on
// some damaged ones, and does not end on others. Throws Error where it was stopped.
template <class Work>
int run_apart(const std::filesystem::path& model, Work work) {
  const pid_t child = fork();
  if (child < 0) throw pt::Error(std::string("cannot start a process: ") + std::strerror(errno));
  if (child == 0) {
    const rlim_t seconds = seconds_for(std::filesystem::file_size(model));
    const rlimit limit{seconds, seconds + 1};
    setrlimit(RLIMIT_CPU, &limit);
    _exit(pt::run_program(work));
  }
  int status = 0;
  waitpid(child, &status, 0);
  if (WIFEXITED(status)) return WEXITSTATUS(status);
  throw pt::Error("cannot read '" + model.string() + "': assimp was stopped (" +
                  strsignal(WTERMSIG(status)) + "); the file is probably damaged");
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app(
      "Makes a COLLADA scene of a model: Wavefront OBJ, PLY, STL, glTF, FBX and whatever else "
      "assimp "
      "reads. Triangles, normals and diffuse colours are kept, and a sentence says what is lost.",
      "./run convert");
  std::filesystem::path model_file, scene;
  bool box = false, sky = false;
  std::string up = "y";
  app.add_option("MODEL", model_file, "the model")->required()->check(CLI::ExistingFile);
  app.add_option("SCENE", scene, "the .dae file to write")->required();
  auto* in_box = app.add_flag("--box", box, "Put it into the Cornell box, scaled to stand in it");
  app.add_flag("--sky", sky, "Put a white sky above it")->excludes(in_box);
  app.add_option("--up", up, "The axis of the model that is up: y, or z as in STL of CAD programs")
      ->check(CLI::IsMember({"y", "z"}))
      ->capture_default_str();
  return pt::run_command_line(app, argc, argv, [&] {
    if (scene.extension() != ".dae") {
      throw pt::Error("cannot write '" + scene.string() + "': the scene's name has to end in .dae");
    }
    pt::check_target(scene);
    return run_apart(model_file, [&] {
      const pt::Model model = pt::read_model(model_file);
      for (const auto& [what, count] : model.lost) {
        fmt::print(stderr, "not kept: {} ({})\n", what, count);
      }
      const auto around = box   ? pt::Surroundings::box
                          : sky ? pt::Surroundings::sky
                                : pt::Surroundings::none;
      pt::write_file(scene, to_collada(model, around, up == "z"));
      std::size_t triangles = 0;
      for (const pt::ModelMesh& mesh : model.meshes) triangles += mesh.faces.size();
      fmt::print("wrote {}: {} meshes, {} triangles\n", pt::printable(scene.string()),
                 model.meshes.size(), triangles);
      return 0;
    });
  });
}
