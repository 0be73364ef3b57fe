#include "pt/scene/export/parts.h"

namespace pt {
namespace {

std::string commas(Rgb c) { return fmt::format("{}, {}, {}", c.r, c.g, c.b); }

// Mitsuba's camera looks along +z with x to the left.
std::string sensor_of(const ExportedView& view) {
  const Frame& frame = view.camera.camera_to_world;
  const Vec3 x = -frame.x, y = frame.y, z = -frame.z, p = view.camera.position;
  return fmt::format(
      R"(  <sensor type="perspective">
    <string name="fov_axis" value="x"/>
    <float name="fov" value="{}"/>
    <float name="near_clip" value="1e-4"/>
    <transform name="to_world">
      <matrix value="{} {} {} {} {} {} {} {} {} {} {} {} 0 0 0 1"/>
    </transform>
    <sampler type="independent">
      <integer name="sample_count" value="$spp"/>
      <integer name="seed" value="$seed"/>
    </sampler>
    <film type="hdrfilm">
      <integer name="width" value="{}"/>
      <integer name="height" value="{}"/>
      <string name="pixel_format" value="rgb"/>
      <string name="component_format" value="float32"/>
      <rfilter type="box"/>
    </film>
  </sensor>
)",
      view.camera.hfov_deg, x.x, y.x, z.x, p.x, x.y, y.y, z.y, p.y, x.z, y.z, z.z, p.z, view.width,
      view.height);
}

// The material of a shape, by its number, and the light that it sends out.
std::string look_of(const Scene& scene, int material) {
  std::string text = fmt::format("    <ref id=\"material{}\"/>\n", material);
  const Rgb emission = scene.materials[material].emission;
  if (!is_black(emission)) {
    text +=
        fmt::format("    <emitter type=\"area\"><rgb name=\"radiance\" value=\"{}\"/></emitter>\n",
                    commas(emission));
  }
  return text;
}

// PLY in words: corners with normals, and triples of corners.
std::string mesh_of(const TriangleGroup& group) {
  const std::size_t count = group.triangles.size();
  std::string text = fmt::format(
      "ply\nformat ascii 1.0\nelement vertex {}\nproperty float x\nproperty float y\nproperty "
      "float z\n",
      3 * count);
  if (!group.flat) text += "property float nx\nproperty float ny\nproperty float nz\n";
  text +=
      fmt::format("element face {}\nproperty list uchar int vertex_indices\nend_header\n", count);
  const auto add = [&](Vec3 p, Vec3 n) {
    text += digits(p) + (group.flat ? "" : " " + digits(n)) + "\n";
  };
  for (const Triangle& t : group.triangles) add(t.p0, t.n0), add(t.p1, t.n1), add(t.p2, t.n2);
  for (std::size_t i = 0; i < count; ++i) {
    text += fmt::format("3 {} {} {}\n", 3 * i, 3 * i + 1, 3 * i + 2);
  }
  return text;
}

std::string light_of(const Light& light) {
  if (const auto* point = std::get_if<PointLight>(&light)) {
    return fmt::format(
        "  <emitter type=\"point\"><point name=\"position\" value=\"{}\"/><rgb name=\"intensity\" "
        "value=\"{}\"/></emitter>\n",
        digits(point->position), commas(point->intensity));
  }
  if (const auto* sun = std::get_if<DirectionalLight>(&light)) {
    return fmt::format(
        "  <emitter type=\"directional\"><vector name=\"direction\" value=\"{}\"/><rgb "
        "name=\"irradiance\" value=\"{}\"/></emitter>\n",
        digits(sun->direction), commas(sun->irradiance));
  }
  return "";
}

}  // namespace

MitsubaScene to_mitsuba(const ExportedView& view) {
  const Scene& scene = view.scene;
  MitsubaScene all;
  // Mitsuba counts what the camera sees as the first bounce.
  all.xml = fmt::format(
      R"(<scene version="3.0.0">
  <default name="spp" value="{}"/>
  <default name="seed" value="0"/>
  <default name="depth" value="{}"/>
  <integrator type="path"><integer name="max_depth" value="$depth"/></integrator>
)",
      view.samples, view.depth + 1);
  all.xml += sensor_of(view);
  for (std::size_t i = 0; i < scene.materials.size(); ++i) {
    all.xml += fmt::format(
        "  <bsdf type=\"twosided\" id=\"material{}\"><bsdf type=\"diffuse\"><rgb "
        "name=\"reflectance\" value=\"{}\"/></bsdf></bsdf>\n",
        i, commas(scene.materials[i].albedo));
  }
  for (const TriangleGroup& group : triangle_groups(scene)) {
    const std::string file = fmt::format("mesh{}.ply", all.meshes.size());
    all.meshes[file] = mesh_of(group);
    all.xml += fmt::format(
        "  <shape type=\"ply\">\n    <string name=\"filename\" value=\"{}\"/>\n    <boolean "
        "name=\"face_normals\" value=\"{}\"/>\n{}  </shape>\n",
        file, group.flat, look_of(scene, group.material));
  }
  const int triangles = static_cast<int>(scene.primitives.triangles.size());
  for (int i = triangles; i < scene.primitives.size(); ++i) {
    const Sphere& sphere = scene.primitives.sphere(i);
    all.xml += fmt::format(
        "  <shape type=\"sphere\">\n    <point name=\"center\" value=\"{}\"/>\n    <float "
        "name=\"radius\" value=\"{}\"/>\n{}  </shape>\n",
        digits(sphere.center), sphere.radius, look_of(scene, scene.material_of[i]));
  }
  for (const Light& light : scene.lights) all.xml += light_of(light);
  all.xml += "</scene>\n";
  return all;
}

}  // namespace pt
