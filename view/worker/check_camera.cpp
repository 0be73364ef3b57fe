#include "pt/render/pixel_record.h"
#include "pt/todo_list.h"
#include "view/worker/check.h"

namespace view {

namespace {

void add(std::vector<Finding>& found, const char* task, const char* promise, std::string text) {
  found.push_back({0, "camera", task, promise, std::move(text)});
}

void check_ray(const pt::Camera& camera, pt::Vec2 at, const pt::Ray& ray,
               std::vector<Finding>& found) {
  constexpr const char* kTask = "camera_ray";
  const double size = std::max(1e-12, max_abs(camera.position));
  if (!(length(ray.origin - camera.position) <= 1e-5 * size)) {
    add(found, kTask, "starts_at_the_camera", "the ray starts elsewhere");
  }
  if (!(std::abs(length(ray.direction) - 1) <= 2e-5)) {
    add(found, kTask, "has_a_unit_direction",
        "the direction has length " + std::to_string(length(ray.direction)));
  }
  if (!close(ray.t_min, camera.near_clip) || !close(ray.t_max, camera.far_clip)) {
    add(found, kTask, "keeps_the_clip_range", "t does not run from near_clip to far_clip");
  }
  const pt::Vec3 local = camera.camera_to_world.to_local(ray.direction);
  if (!(local.z < 0)) {
    add(found, kTask, "looks_along_minus_z", "the ray goes backwards");
    return;
  }
  const double x = 0.5 + 0.5 * local.x / (-local.z * half_tangent(camera.hfov_deg));
  const double y = 0.5 + 0.5 * local.y / (-local.z * half_tangent(camera.vfov_deg));
  const double off = std::max(std::abs(x - at.x), std::abs(y - at.y));
  if (off <= 1e-4) return;
  const bool is_mirrored = (std::abs(1 - x - at.x) < 1e-4 || std::abs(x - at.x) < 1e-4) &&
                           (std::abs(1 - y - at.y) < 1e-4 || std::abs(y - at.y) < 1e-4);
  add(found, kTask, is_mirrored ? "puts_x_to_the_right_and_y_up" : "fills_the_field_of_view",
      "the ray goes through x " + std::to_string(x) + ", y " + std::to_string(y) +
          " of the picture");
}

void check_point(const pt::View& view, const Settings& settings, pt::Vec2 at,
                 std::vector<Finding>& found) {
  constexpr double kSlack = 2e-5;
  const double x = at.x * view.width - settings.x, y = at.y * view.height - settings.y;
  const double slack_x = kSlack * view.width, slack_y = kSlack * view.height;
  const std::string place =
      "the ray is at " + std::to_string(x) + ", " + std::to_string(y) + " of the pixel";
  const bool is_inside = x >= -slack_x && x <= 1 + slack_x && y >= -slack_y && y <= 1 + slack_y;
  if (!is_inside) {
    add(found, "estimate_pixel", "stays_inside_the_pixel", place);
  } else if (settings.render.samples == 1 &&
             !(std::abs(x - 0.5) <= slack_x && std::abs(y - 0.5) <= slack_y)) {
    add(found, "estimate_pixel", "sends_one_sample_through_the_centre", place);
  }
}

}  // namespace

void check_camera(const pt::View& view, const Settings& settings, PixelPaths& pixel) {
  const bool is_adaptive = settings.render.adaptive.has_value();
  const std::size_t samples = pixel.values.size();
  if (!is_adaptive && samples != static_cast<std::size_t>(settings.render.samples)) {
    add(pixel.findings, "estimate_pixel", "takes_the_samples_asked_for",
        std::to_string(samples) + " samples were taken");
  }
  pt::Rgb sum;
  for (const pt::Rgb& value : pixel.values) sum += pt::fits_float(value) ? value : pt::Rgb{};
  if (samples > 0 && !close(sum / static_cast<double>(samples), pixel.mean)) {
    add(pixel.findings, is_adaptive ? "adaptive_pixel" : "estimate_pixel",
        is_adaptive ? "returns_the_mean_of_all_samples" : "averages_the_radiance",
        "the result is not the mean of the samples");
  }
  std::vector<pt::Ray> rays;
  for (const pt::Call& call : pixel.calls) {
    if (call.name == "camera_ray") rays.push_back(std::any_cast<pt::Ray>(call.out));
  }
  if (rays.size() != samples) return;  // it is not known which ray belongs to which sample
  for (std::size_t i = 0; i < pixel.paths.size(); ++i) {
    Path& path = pixel.paths[i];
    check_ray(view.camera, path.at, rays[settings.first + i], path.findings);
    if (!is_adaptive) check_point(view, settings, path.at, path.findings);
  }
}

void check_calls(const pt::View& view, const pt::Tracer& exact, PixelPaths& pixel,
                 const Settings& settings) {
  check_camera(view, settings, pixel);
  for (Path& path : pixel.paths) {
    check_hits(view.scene, exact, path);
    for (std::size_t i = 0; i < path.bounces.size(); ++i) {
      Bounce& bounce = path.bounces[i];
      for (Direct& direct : bounce.direct) {
        for (Draw& draw : direct.draws) {
          if (!draw.is_hidden) continue;
          const auto hit = exact.closest(view.scene.primitives, draw.ray);
          draw.hit = hit ? hit->primitive : -1;
        }
      }
      const int number = static_cast<int>(i) + 1;
      if (path.is_one) check_sample(number, bounce, path.findings);
      check_direct(view.scene, exact, number, bounce, path.findings);
    }
    check_path(view.settings, path);
  }
  // A task that is not written breaks no promise yet.
  const std::vector<std::string> unwritten = pt::todo_list();
  const auto is_unwritten = [&](const Finding& finding) {
    return std::ranges::find(unwritten, finding.task) != unwritten.end();
  };
  std::erase_if(pixel.findings, is_unwritten);
  for (Path& path : pixel.paths) std::erase_if(path.findings, is_unwritten);
}

}  // namespace view
