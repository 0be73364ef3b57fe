#pragma once

#include "view/worker/disk.h"
#include "view/worker/picture.h"

#include <memory>
#include <string>

#include <nlohmann/json.hpp>

namespace view {

// An answer of the child; `bytes` are the floats of a picture, or empty.
struct Answer {
  nlohmann::json state;
  std::string bytes;
};

// What the child keeps between two questions: the scene with its tracer, and the picture.
class Answers {
 public:
  // With one_thread, pictures are made by this thread alone. Throws pt::Error if the scene cannot be read.
  Answers(const std::filesystem::path& scene, bool lambertian, bool one_thread = false);

  // Throws pt::Error with one sentence if the question cannot be answered.
  Answer answer(const std::string& what, const Query& query);

 private:
  void trace_with(const Settings& settings);
  void require_light(const Settings& settings) const;
  Answer picture(const Query& query);
  Answer paths(const Query& query);
  Answer disk(const Query& query);
  Answer scene(const Query& query);
  Answer tree(const Query& query);
  Answer ray(const Query& query);
  Answer depth(const Query& query) const;

  std::filesystem::path file_;
  bool one_thread_;
  pt::LoadedScene loaded_;
  pt::Tracer exact_;
  std::optional<std::pair<pt::Engine, int>> traced_with_;
  std::unique_ptr<Picture> picture_;
  Query picture_query_;
  std::unique_ptr<Disk> disk_;
  Query disk_query_;
};

}  // namespace view
