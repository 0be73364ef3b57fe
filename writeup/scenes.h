#pragma once

#include "writeup/catalogue.h"

#include <filesystem>
#include <map>
#include <string>

namespace writeup {

// The file that stands for each scene of the catalogue on this machine.
class Scenes {
 public:
  // `course` may be empty: then our own scenes stand in. Meshes are made by the program `generate`
  // and kept in `made`; a draft has a tenth of their triangles.
  Scenes(const Catalogue& catalogue, std::filesystem::path course, std::filesystem::path made,
         std::filesystem::path generate, bool draft);

  // Paths of our own scenes are relative to the project's root, where this program runs.
  std::string path(const std::string& name) const;
  int triangles(const std::string& name) const;  // about
  // The word for the option --camera.
  std::string camera(const std::string& name) const;
  // "CBbunny.dae", or "box_blob, in place of CBbunny.dae".
  std::string description(const std::string& name) const;

  // "lucy", or "coil of 133000" if that replaces it.
  std::string short_name(const std::string& name) const;

  // Makes the file of a scene if it is a generated scene and the file is missing.
  void prepare(const std::string& name) const;

 private:
  bool has_course_file(const SceneSource& source) const;
  int mesh_size(const SceneSource& source) const;

  const std::map<std::string, SceneSource>& sources_;
  std::filesystem::path course_, made_, generate_;
  bool draft_;
};

}  // namespace writeup
