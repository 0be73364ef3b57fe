#include "view/worker/answer.h"

#include "pt/error.h"
#include "pt/render/choose_engine.h"
#include "pt/render/darkness.h"
#include "pt/tasks/camera_ray.h"
#include "pt/todo_list.h"
#include "view/worker/check.h"
#include "view/worker/json.h"
#include "view/worker/tree.h"

namespace view {

using nlohmann::json;

namespace {

constexpr std::chrono::milliseconds kSlice{120};

}  // namespace

Answers::Answers(const std::filesystem::path& scene, bool lambertian, bool one_thread)
    : file_(scene), one_thread_(one_thread), loaded_(pt::load_collada(scene, {lambertian})) {
  exact_ = pt::Tracer(pt::Engine::wide, loaded_.scene.primitives);
}

void Answers::trace_with(const Settings& settings) {
  const std::pair wanted(settings.render.engine, settings.render.max_leaf);
  if (traced_with_ == wanted) return;
  choose_engine(loaded_.scene, wanted.first, wanted.second);
  traced_with_ = wanted;
}

// Materials and lights outside the model can be shown by their normals alone.
void Answers::require_light(const Settings& settings) const {
  if (settings.render.show == pt::Show::normals) return;
  pt::require_light(loaded_, file_);
}

Answer Answers::scene(const Query& query) {
  const Settings settings = settings_of(query);
  const pt::Box box = bounds(loaded_.scene.primitives);
  const json state{{"camera", to_json(view_of(loaded_, settings).camera)},
                   {"min", to_json(box.min)},
                   {"max", to_json(box.max)},
                   {"primitives", loaded_.scene.primitives.size()},
                   {"triangles", loaded_.scene.primitives.triangles.size()},
                   {"lights", loaded_.scene.lights.size()},
                   {"notes", loaded_.notes}};
  return {state, ""};
}

Answer Answers::picture(const Query& query) {
  if (!picture_ || picture_query_ != query) {
    Settings settings = settings_of(query);
    require_light(settings);
    trace_with(settings);
    if (one_thread_) settings.render.threads = 1;
    picture_ = std::make_unique<Picture>(begin_picture(loaded_, settings));
    picture_query_ = query;
  }
  const bool goes_on = improve(*picture_, kSlice);
  const Picture& picture = *picture_;
  json bad = json::array();
  for (const pt::BadPixel& pixel : picture.bad) bad.push_back({pixel.x, pixel.y});
  const json state{{"width", picture.view.width},
                   {"height", picture.view.height},
                   {"camera", to_json(picture.view.camera)},
                   {"stage", picture.stage},
                   {"samples", picture.samples},
                   {"rays", picture.rays.closest + picture.rays.occluded},
                   {"seconds", picture.seconds},
                   {"goes_on", goes_on},
                   {"engine", pt::name(loaded_.scene.tracer.engine())},
                   {"not_finite", picture.not_finite},
                   {"note", picture.note},
                   {"bad", std::move(bad)},
                   {"unwritten", pt::todo_list()}};
  const auto* bytes = reinterpret_cast<const char*>(picture.shown.data());
  return {state, std::string(bytes, sizeof(float) * picture.shown.size())};
}

Answer Answers::paths(const Query& query) {
  constexpr int kMostPaths = 64;
  Settings settings = settings_of(query);
  if (settings.render.samples > kMostPaths) {
    throw pt::Error("'samples' is at most 64 where paths are shown");
  }
  settings.render.show =
      settings.render.show == pt::Show::normals ? pt::Show::full : settings.render.show;
  require_light(settings);
  trace_with(settings);
  const pt::View view = view_of(loaded_, settings);
  PixelPaths pixel = paths_of_pixel(view, settings);
  check_calls(view, exact_, pixel, settings);
  json state = to_json(pixel);
  state["x"] = settings.x;
  state["y"] = settings.y;
  state["camera"] = to_json(view.camera);
  state["survival"] = settings.render.path.survival;
  state["unwritten"] = pt::todo_list();
  return {state, ""};
}

Answer Answers::tree(const Query& query) {
  trace_with(settings_of(query));
  return {tree_of(loaded_.scene.tracer.bvh()), ""};
}

// The ray through the middle of the pixel.
Answer Answers::ray(const Query& query) {
  const Settings settings = settings_of(query);
  trace_with(settings);
  const pt::View view = view_of(loaded_, settings);
  const pt::Ray ray =
      camera_ray(view.camera, (settings.x + 0.5) / view.width, (settings.y + 0.5) / view.height);
  return {tests_of(loaded_.scene, ray), ""};
}

Answer Answers::answer(const std::string& what, const Query& query) {
  if (what == "scene") return scene(query);
  if (what == "picture") return picture(query);
  if (what == "paths") return paths(query);
  if (what == "tree") return tree(query);
  if (what == "ray") return ray(query);
  throw pt::Error("nothing is known about '" + what + "'");
}

}  // namespace view
