#include "pt/scene/collada/cameras.h"

#include "pt/scene/collada/numbers.h"
#include "pt/scene/collada/transforms.h"
#include "pt/scene/field_of_view.h"

#include <cmath>
#include <unordered_map>

#include <tinyxml2.h>

namespace pt {

namespace {

bool is_angle(double degrees) { return degrees > 0 && degrees < 180; }

std::optional<double> optional_fov(const Document& document, const XMLElement& perspective,
                                   const char* name) {
  const std::optional<double> fov = child_number(document, perspective, name);
  if (fov && !is_angle(*fov)) {
    document.fail(perspective, std::string(name) + " is " + shown(*fov) +
                                   " degrees; write an angle between 0 and 180");
  }
  return fov;
}

// A camera without a position. If the file states only one field of view, the other follows from
// the aspect ratio, which is 4:3 if the file has none.
FileCamera read_perspective(const Document& document, const XMLElement& perspective) {
  FileCamera camera;
  const std::optional<double> x = optional_fov(document, perspective, "xfov");
  const std::optional<double> y = optional_fov(document, perspective, "yfov");
  const double aspect = child_number(document, perspective, "aspect_ratio").value_or(4.0 / 3);
  if (!(aspect > 0)) document.fail(perspective, "aspect_ratio must be above 0; correct it");
  if (!x && !y) document.fail(perspective, "<perspective> has no xfov; add it, in degrees");
  camera.hfov_deg = x ? *x : fov_from(half_tangent(*y) * aspect);
  camera.vfov_deg = y ? *y : fov_from(half_tangent(*x) / aspect);
  if (!is_angle(camera.hfov_deg) || !is_angle(camera.vfov_deg)) {
    document.fail(perspective,
                  "the fields of view leave (0, 180) degrees; correct the aspect_ratio");
  }
  camera.near_clip = child_number(document, perspective, "znear").value_or(0);
  camera.far_clip = child_number(document, perspective, "zfar").value_or(kInfinity);
  if (!(camera.near_clip >= 0 && camera.near_clip < camera.far_clip)) {
    document.fail(perspective, "znear and zfar must satisfy 0 <= znear < zfar; correct them");
  }
  return camera;
}

std::optional<FileCamera> read_fields(const Document& document, const XMLElement& element) {
  const XMLElement& common = document.child(document.child(element, "optics"), "technique_common");
  if (const XMLElement* perspective = common.FirstChildElement("perspective")) {
    return read_perspective(document, *perspective);
  }
  document.note("camera " + label(element) + " has no perspective and is ignored.");
  return std::nullopt;
}

// The frame keeps the direction in which the camera looks; its up is turned to a right angle.
Frame camera_frame(const Document& document, const Instance& instance) {
  const Vec3 backwards = instance.to_world.z;
  if (!std::isnormal(length_squared(backwards))) {
    document.fail(*instance.node,
                  "camera " + label(*instance.node) +
                      " looks nowhere: its z axis has no length; correct its matrix");
  }
  return upright_frame(
      document, normalize(backwards), instance.to_world.y,
      "camera " + label(*instance.node) + " has no up direction of its own: y is up.");
}

}  // namespace

std::optional<FileCamera> read_camera(const Document& document,
                                      const std::vector<Instance>& cameras) {
  std::optional<FileCamera> last;
  std::unordered_map<const XMLElement*, std::optional<FileCamera>> fields;
  int perspectives = 0;
  for (const Instance& instance : cameras) {
    const auto [known, is_new] = fields.try_emplace(instance.target);
    std::optional<FileCamera>& camera = known->second;
    if (is_new) camera = read_fields(document, *instance.target);
    if (!camera) continue;
    last = camera;
    last->position = instance.to_world.translation;
    last->backwards = instance.to_world.z;
    last->camera_to_world = camera_frame(document, instance);
    ++perspectives;
  }
  if (perspectives > 1) {
    document.note("the file has " + std::to_string(perspectives) + " cameras: the last is taken.");
  }
  return last;
}

}  // namespace pt
