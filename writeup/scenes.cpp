#include "writeup/scenes.h"

#include "grader/service/process/run_command.h"
#include "pt/error.h"

#include <chrono>

#include <fmt/format.h>

namespace writeup {

namespace fs = std::filesystem;

namespace {

constexpr int kDraftMesh = 10;  // times fewer triangles
constexpr std::chrono::minutes kMaxTime{5};

}  // namespace

Scenes::Scenes(const Catalogue& catalogue, fs::path course, fs::path made, fs::path generate,
               bool draft)
    : sources_(catalogue.scenes),
      course_(std::move(course)),
      made_(std::move(made)),
      generate_(std::move(generate)),
      draft_(draft) {}

bool Scenes::has_course_file(const SceneSource& source) const {
  return !course_.empty() && !source.course.empty() && fs::exists(course_ / source.course);
}

int Scenes::mesh_size(const SceneSource& source) const {
  return draft_ ? source.triangles / kDraftMesh : source.triangles;
}

std::string Scenes::path(const std::string& name) const {
  const SceneSource& source = sources_.at(name);
  if (has_course_file(source)) return (course_ / source.course).string();
  if (source.mesh.empty()) return source.own;
  return (made_ /
          fmt::format("{}_{}{}.dae", source.mesh, mesh_size(source), source.room ? "_room" : ""))
      .string();
}

int Scenes::triangles(const std::string& name) const {
  const SceneSource& source = sources_.at(name);
  const bool made = !has_course_file(source) && !source.mesh.empty();
  return made ? mesh_size(source) : source.triangles;
}

std::string Scenes::camera(const std::string& name) const {
  const SceneSource& source = sources_.at(name);
  return has_course_file(source) ? "course" : source.camera;
}

std::string Scenes::description(const std::string& name) const {
  const SceneSource& source = sources_.at(name);
  std::string course = fs::path(source.course).filename().string();
  if (has_course_file(source)) return course;
  const std::string own = source.mesh.empty() ? fs::path(source.own).stem().string()
                                              : fmt::format("a generated {} of {} triangles",
                                                            source.mesh, mesh_size(source));
  return course.empty() ? own : own + ", in place of " + course;
}

std::string Scenes::short_name(const std::string& name) const {
  const SceneSource& source = sources_.at(name);
  if (has_course_file(source)) return name;
  if (source.mesh.empty()) return fs::path(source.own).stem().string();
  return fmt::format("{} of {} triangles", source.mesh, mesh_size(source));
}

void Scenes::prepare(const std::string& name) const {
  const SceneSource& source = sources_.at(name);
  const std::string file = path(name);
  if (source.mesh.empty() || has_course_file(source) || fs::exists(file)) return;
  fs::create_directories(made_);
  std::vector<std::string> words{generate_.string(),
                                 "--kind",
                                 source.mesh,
                                 "--triangles",
                                 std::to_string(mesh_size(source)),
                                 "-o",
                                 file};
  if (source.room) words.emplace_back("--room");
  const auto result =
      grader::process::run_command({words, {"PATH=/usr/bin"}, {}, "", {}}, kMaxTime);
  if (!result.ok()) throw pt::Error(file + " could not be made: " + result.output);
}

}  // namespace writeup
