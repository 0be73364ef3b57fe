#include "pt/scene/export/parts.h"

namespace pt {

std::string to_plain(const ExportedView& view) {
  const Scene& scene = view.scene;
  const Camera& camera = view.camera;
  const Frame& frame = camera.camera_to_world;
  std::string text = fmt::format("camera {} {} {} {} {} {} {} {}\n", digits(camera.position),
                                 digits(frame.x), digits(frame.y), digits(frame.z), camera.hfov_deg,
                                 camera.vfov_deg, camera.near_clip, camera.far_clip);
  const auto colors = [&](int primitive) {
    const Material& of = material(scene, primitive);
    return digits(of.albedo) + " " + digits(of.emission);
  };
  for (int i = 0; i < scene.primitives.size(); ++i) {
    if (scene.primitives.is_triangle(i)) {
      const Triangle& t = scene.primitives.triangle(i);
      text += "triangle";
      for (const Vec3 v : {t.p0, t.p1, t.p2, t.n0, t.n1, t.n2}) text += " " + digits(v);
    } else {
      const Sphere& sphere = scene.primitives.sphere(i);
      text += fmt::format("sphere {} {}", digits(sphere.center), sphere.radius);
    }
    text += " " + colors(i) + "\n";
  }
  for (const Light& light : scene.lights) {
    if (const auto* point = std::get_if<PointLight>(&light)) {
      text += fmt::format("point {} {}\n", digits(point->position), digits(point->intensity));
    } else if (const auto* sun = std::get_if<DirectionalLight>(&light)) {
      text += fmt::format("directional {} {}\n", digits(sun->direction), digits(sun->irradiance));
    } else if (const auto* sky = std::get_if<AmbientLight>(&light)) {
      text += fmt::format("sky {}\n", digits(sky->radiance));
    }
  }
  return text;
}

}  // namespace pt
