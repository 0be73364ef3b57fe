#include "pt/scene/export/parts.h"

namespace pt {
namespace {

// pbrt's camera looks along +z with x to the right, so its space is left-handed: a matrix from the world says that, column by column.
std::string camera_of(const ExportedView& view) {
  const Frame& frame = view.camera.camera_to_world;
  const Vec3 x = frame.x, y = frame.y, z = -frame.z, p = view.camera.position;
  std::string text =
      fmt::format("Transform [{} {} {} 0 {} {} {} 0 {} {} {} 0 {} {} {} 1]\n", x.x, y.x, z.x, x.y,
                  y.y, z.y, x.z, y.z, z.z, -dot(x, p), -dot(y, p), -dot(z, p));
  // The field of view of the shorter side.
  const bool is_wide = view.width >= view.height;
  text += fmt::format("Camera \"perspective\" \"float fov\" [{}]\n",
                      is_wide ? view.camera.vfov_deg : view.camera.hfov_deg);
  text += fmt::format(
      "Film \"rgb\" \"integer xresolution\" [{}] \"integer yresolution\" [{}] \"string filename\" "
      "[\"scene.exr\"]\n",
      view.width, view.height);
  return text;
}

std::string emission_of(const Material& material) {
  if (is_black(material.emission)) return "";
  return fmt::format("  AreaLightSource \"diffuse\" \"rgb L\" [{}]\n", digits(material.emission));
}

std::string shape_of(const TriangleGroup& group) {
  std::string points, normals, indices;
  for (std::size_t i = 0; i < group.triangles.size(); ++i) {
    const Triangle& t = group.triangles[i];
    for (const Vec3 p : {t.p0, t.p1, t.p2}) points += digits(p) + " ";
    for (const Vec3 n : {t.n0, t.n1, t.n2}) normals += digits(n) + " ";
    indices += fmt::format("{} {} {} ", 3 * i, 3 * i + 1, 3 * i + 2);
  }
  std::string text = fmt::format(
      "  Shape \"trianglemesh\" \"point3 P\" [{}] \"integer indices\" [{}]", points, indices);
  if (!group.flat) text += fmt::format(" \"normal N\" [{}]", normals);
  return text + "\n";
}

std::string light_of(const Light& light) {
  if (const auto* point = std::get_if<PointLight>(&light)) {
    return fmt::format("LightSource \"point\" \"rgb I\" [{}] \"point3 from\" [{}]\n",
                       digits(point->intensity), digits(point->position));
  }
  if (const auto* sun = std::get_if<DirectionalLight>(&light)) {
    return fmt::format(
        "LightSource \"distant\" \"rgb L\" [{}] \"point3 from\" [0 0 0] \"point3 to\" [{}]\n",
        digits(sun->irradiance), digits(sun->direction));
  }
  return "";
}

}  // namespace

std::string to_pbrt(const ExportedView& view) {
  const Scene& scene = view.scene;
  std::string text = camera_of(view);
  text += fmt::format(
      "Sampler \"independent\" \"integer pixelsamples\" [{}]\nPixelFilter \"box\"\n"
      "Integrator \"path\" \"integer maxdepth\" [{}]\nWorldBegin\n",
      view.samples, view.depth);
  for (const Light& light : scene.lights) text += light_of(light);
  const auto add = [&](const Material& of, const std::string& shape) {
    text += fmt::format("AttributeBegin\n  Material \"diffuse\" \"rgb reflectance\" [{}]\n",
                        digits(of.albedo));
    text += emission_of(of) + shape + "AttributeEnd\n";
  };
  for (const TriangleGroup& group : triangle_groups(scene)) {
    add(scene.materials[group.material], shape_of(group));
  }
  const int triangles = static_cast<int>(scene.primitives.triangles.size());
  for (int i = triangles; i < scene.primitives.size(); ++i) {
    const Sphere& sphere = scene.primitives.sphere(i);
    add(material(scene, i),
        fmt::format("  Translate {}\n  Shape \"sphere\" \"float radius\" [{}]\n",
                    digits(sphere.center), sphere.radius));
  }
  return text;
}

}  // namespace pt
