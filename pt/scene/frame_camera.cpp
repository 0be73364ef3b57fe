#include "pt/scene/frame_camera.h"

#include "pt/accel/wide_bvh.h"
#include "pt/scene/field_of_view.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <vector>

namespace pt {

namespace {

// Half the picture's width and height on a window at distance 1.
struct Window {
  double x, y;
};

Window file_window(const FileCamera& camera) {
  return {half_tangent(camera.hfov_deg), half_tangent(camera.vfov_deg)};
}

// The smallest window of that aspect ratio around the given one.
Window widen(Window window, double aspect) {
  const double y = std::max(window.y, window.x / aspect);
  return {y * aspect, y};
}

Window course_window(const FileCamera& camera, int width, int height) {
  constexpr double kScreenHeight = 600;
  const double distance = kScreenHeight / (2 * widen(file_window(camera), 4.0 / 3).y);
  return {width / (2 * distance), height / (2 * distance)};
}

FileCamera default_camera(Vec3 front) {
  FileCamera camera;
  camera.camera_to_world = {cross({0, 1, 0}, front), {0, 1, 0}, front};
  camera.hfov_deg = 49.13434;
  camera.vfov_deg = fov_from(half_tangent(camera.hfov_deg) * 3 / 4);
  return camera;
}

// The direction from the target towards the eye. The course's program transforms the view direction
// -z with the camera's matrix as if it were a point, which adds the camera's position. Only
// exported files are made for that program; a file written by hand means the camera's axis.
Vec3 towards_eye(const LoadedScene& loaded, const FileCamera& camera, Framing framing) {
  const Vec3 course = camera.position - camera.backwards;
  const bool as_course = framing == Framing::course && loaded.exported &&
                         length(course) > 1e-6 * length(camera.backwards);
  return as_course ? normalize(course) : camera.camera_to_world.z;
}

// The direction, or 45 degrees from it where it would look at a flat scene along its plane.
Vec3 off_edge(Vec3 towards, const Box& box) {
  constexpr double kFlat = 1e-3;
  const Vec3 size = box.extent();
  for (int axis = 0; axis < 3; ++axis) {
    Vec3 across{};
    (axis == 0 ? across.x : axis == 1 ? across.y : across.z) = 1;
    const bool is_flat = size[axis] <= kFlat * max_abs(size);
    if (is_flat && std::abs(towards[axis]) < kFlat) return normalize(towards + across);
  }
  return towards;
}

// A frame with z from the target towards the eye, and y as far up as possible.
Frame upright_frame(Vec3 z, const FileCamera& camera) {
  Vec3 right = cross({0, 1, 0}, z);
  if (!(length(right) > 1e-6)) right = cross(camera.camera_to_world.y, z);
  if (!(length(right) > 1e-6)) right = camera.camera_to_world.x;
  const Vec3 x = normalize(right);
  return {x, cross(z, x), z};
}

// Files outside the course's dialect have no other rule.
bool is_framed_as_file(const LoadedScene& loaded, Framing framing) {
  return framing == Framing::file || (framing == Framing::course && !loaded.is_course);
}

// The camera as the file has it.
Camera own_view(const FileCamera& from) {
  return {from.position, from.camera_to_world, from.hfov_deg,
          from.vfov_deg, from.near_clip,       from.far_clip};
}

// The distances of the surfaces that a grid of rays meets between the camera's clips.
std::vector<double> distances_seen(const Camera& camera, const Primitives& primitives) {
  constexpr int kRays = 64;
  const WideBvh tree = WideBvh::build(primitives);
  std::vector<double> distances;
  for (int i = 0; i < kRays * kRays; ++i) {
    const int row = i / kRays;
    const Ray ray = look_through(camera, (i % kRays + 0.5) / kRays, (row + 0.5) / kRays);
    if (const std::optional<Hit> hit = tree.closest(primitives, ray)) distances.push_back(hit->t);
  }
  return distances;
}

}  // namespace

Ray look_through(const Camera& camera, double x, double y) {
  const Vec3 on_window{(2 * x - 1) * half_tangent(camera.hfov_deg),
                       (2 * y - 1) * half_tangent(camera.vfov_deg), -1};
  return {camera.position, normalize(camera.camera_to_world.to_world(on_window)), camera.near_clip,
          camera.far_clip};
}

bool sees_surfaces(const FileCamera& camera, const Primitives& primitives) {
  return !distances_seen(own_view(camera), primitives).empty();
}

void add_camera_light(LoadedScene& loaded, const Camera& camera) {
  if (loaded.light != LightChoice::camera) return;
  const Primitives& primitives = loaded.scene.primitives;
  std::vector<double> seen = distances_seen(camera, primitives);
  if (seen.empty()) seen.push_back(length(camera.position - bounds(primitives).center()));
  const auto middle = seen.begin() + std::ssize(seen) / 2;
  std::nth_element(seen.begin(), middle, seen.end());
  const double intensity = kPi * *middle * *middle;
  loaded.scene.lights.push_back(PointLight{camera.position, {intensity, intensity, intensity}});
}

std::string note_on_framing(const LoadedScene& loaded, Framing framing) {
  if (!loaded.camera) return "";
  if (is_framed_as_file(loaded, framing) && !loaded.camera->sees_surfaces) {
    return "the file's camera sees no surface from where it stands, or clips all of them: the "
           "scene "
           "is framed as by --camera fit.";
  }
  if (framing != Framing::course) return "";
  if (!loaded.is_course) {
    return "the file is not in the course's dialect: --camera course takes the file's own camera; "
           "give --camera fit to see the whole scene.";
  }
  if (loaded.has_asset) return "";
  return "the file has no <asset>, which would name the program that exported it: --camera course "
         "takes it "
         "for one that was written by hand, seen along the camera's own axis.";
}

Camera frame_camera(const LoadedScene& loaded, Framing framing, int width, int height) {
  assert(width > 0 && height > 0);
  const FileCamera from = loaded.camera.value_or(default_camera(loaded.front));
  if (!loaded.camera) {
    framing = Framing::fit;
  } else if (is_framed_as_file(loaded, framing)) {
    framing = from.sees_surfaces ? Framing::file : Framing::fit;
  }

  const Window window = framing == Framing::course
                            ? course_window(from, width, height)
                            : widen(file_window(from), static_cast<double>(width) / height);
  Camera camera = own_view(from);
  camera.hfov_deg = fov_from(window.x);
  camera.vfov_deg = fov_from(window.y);
  if (framing == Framing::file) return camera;
  camera.near_clip = 0;
  camera.far_clip = kInfinity;
  const Box box = bounds(loaded.scene.primitives);
  const Vec3 towards = towards_eye(loaded, from, framing);
  camera.camera_to_world =
      upright_frame(framing == Framing::fit ? off_edge(towards, box) : towards, from);
  camera.position = box.center() + 1.5 * length(box.extent()) * camera.camera_to_world.z;
  return camera;
}

}  // namespace pt
