#include "view/worker/answer.h"

#include "pt/error.h"
#include "pt/render/choose_engine.h"
#include "pt/tasks/camera_ray.h"
#include "pt/todo_list.h"
#include "view/worker/check.h"
#include "view/worker/json.h"
#include "view/worker/tree.h"

#include <algorithm>
#include <cmath>

namespace view {

using nlohmann::json;

namespace {

constexpr std::chrono::milliseconds kSlice{120};
constexpr int kDepthSide = 240;  // distances in a row or a column, at most

// The primitives that paths meet, and those that hide a light from them, by number: [p0, p1, p2] or [center, radius].
json shapes_of(const pt::Primitives& primitives, const PixelPaths& pixel) {
  json shapes = json::object();
  const auto add = [&](int i) {
    if (i < 0 || i >= primitives.size()) return;
    if (primitives.is_triangle(i)) {
      const pt::Triangle& triangle = primitives.triangle(i);
      shapes[std::to_string(i)] = {to_json(triangle.p0), to_json(triangle.p1),
                                   to_json(triangle.p2)};
    } else {
      const pt::Sphere& sphere = primitives.sphere(i);
      shapes[std::to_string(i)] = {to_json(sphere.center), sphere.radius};
    }
  };
  for (const Path& path : pixel.paths) {
    for (const Bounce& bounce : path.bounces) {
      add(bounce.primitive);
      for (const Direct& direct : bounce.direct) {
        for (const Draw& draw : direct.draws) add(draw.is_hidden ? draw.hit : -1);
      }
    }
  }
  return shapes;
}

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
  pt::require_supported(loaded_, file_);
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
                   {"whole", picture.next_pixel == 0},
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
  Settings settings = settings_of(query);
  settings.render.show =
      settings.render.show == pt::Show::normals ? pt::Show::full : settings.render.show;
  require_light(settings);
  trace_with(settings);
  const pt::View view = view_of(loaded_, settings);
  PixelPaths pixel = paths_of_pixel(view, settings);
  check_calls(view, exact_, pixel, settings);
  json state = to_json(pixel);
  state["first"] = settings.first;
  state["adaptive"] = query.contains("adaptive") ? query.at("adaptive") : "";
  state["x"] = settings.x;
  state["y"] = settings.y;
  state["camera"] = to_json(view.camera);
  state["shapes"] = shapes_of(loaded_.scene.primitives, pixel);
  state["survival"] = settings.render.path.survival;
  state["unwritten"] = pt::todo_list();
  return {state, ""};
}

// `met` is the hit of a point as paths tell it, `point` how many points of its path come before it.
Answer Answers::disk(const Query& query) {
  Query of_settings = query;
  const auto taken = [&](const char* name) {
    const auto found = of_settings.find(name);
    std::string word = found == of_settings.end() ? "" : found->second;
    of_settings.erase(name);
    return word;
  };
  const std::vector<double> met = numbers_of("met", taken("met"), 11);
  const double before = numbers_of("point", taken("point"), 1)[0];
  Settings settings = settings_of(of_settings);
  require_light(settings);
  trace_with(settings);
  if (!disk_ || disk_query_ != query) {
    const int primitive = static_cast<int>(std::clamp(met[10], -1.0, 1e9));
    if (primitive < 0 || primitive >= loaded_.scene.primitives.size()) {
      throw pt::Error("the scene has no such primitive as the last number of 'met'");
    }
    const pt::Ray ray{{met[0], met[1], met[2]}, {met[3], met[4], met[5]}};
    const pt::Hit hit{met[6], {met[7], met[8], met[9]}, primitive};
    if (one_thread_) settings.render.threads = 1;
    disk_ = std::make_unique<Disk>(begin_disk(surface_point(loaded_.scene, ray, hit), settings,
                                              static_cast<int>(std::clamp(before, 0.0, 100.0))));
    disk_query_ = query;
  }
  const bool goes_on = improve(*disk_, loaded_.scene, kSlice);
  nlohmann::json state = to_json(*disk_);
  state["goes_on"] = goes_on;
  state["unwritten"] = pt::todo_list();
  const std::vector<float> layers = layers_of(*disk_);
  const auto* bytes = reinterpret_cast<const char*>(layers.data());
  return {std::move(state), std::string(bytes, sizeof(float) * layers.size())};
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

// Distances of surfaces, row by row from the top, without the tasks: with them the page finds which parts of a line are hidden.
Answer Answers::depth(const Query& query) const {
  const pt::View view = view_of(loaded_, settings_of(query));
  const int step = (std::max(view.width, view.height) + kDepthSide - 1) / kDepthSide;
  const int width = (view.width + step - 1) / step, height = (view.height + step - 1) / step;
  const pt::Camera& camera = view.camera;
  const double right = half_tangent(camera.hfov_deg);
  const double up = half_tangent(camera.vfov_deg);
  std::vector<float> distances;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const pt::Vec3 local{(2 * (x + 0.5) / width - 1) * right, (1 - 2 * (y + 0.5) / height) * up,
                           -1};
      const pt::Vec3 direction = normalize(camera.camera_to_world.to_world(local));
      const auto hit =
          exact_.closest(loaded_.scene.primitives,
                         {camera.position, direction, camera.near_clip, camera.far_clip});
      distances.push_back(static_cast<float>(hit ? hit->t : pt::kInfinity));
    }
  }
  const auto* bytes = reinterpret_cast<const char*>(distances.data());
  return {{{"width", width}, {"height", height}},
          std::string(bytes, sizeof(float) * distances.size())};
}

Answer Answers::answer(const std::string& what, const Query& query) {
  if (what == "scene") return scene(query);
  if (what == "picture") return picture(query);
  if (what == "paths") return paths(query);
  if (what == "disk") return disk(query);
  if (what == "tree") return tree(query);
  if (what == "ray") return ray(query);
  if (what == "depth") return depth(query);
  throw pt::Error("nothing is known about '" + what + "'");
}

}  // namespace view
