// The scene of a WildScene: its surfaces and lights in the world.
#include "grader/check/wild/wild_scene.h"

#include <utility>

namespace grader::check {

using pt::Rgb;
using pt::Vec3;
using Kind = WildLight::Kind;

namespace {

class Maker {
 public:
  explicit Maker(const WildScene& from)
      : from_(from), pose_{pt::frame_from_normal(from.up), from.size * from.away, from.size} {
    add_patch();
    for (const WildLight& light : from.lights) add(light);
    for (const WildSurface& surface : from.surfaces) add(surface);
    if (from.room) add(*from.room);
    scene_.material_of.insert(scene_.material_of.end(), ball_materials_.begin(),
                              ball_materials_.end());
    scene_.tracer = pt::Tracer(pt::Engine::linear, scene_.primitives);
  }

  std::optional<Situation> situation() const {
    const Vec3 start = from_.seen_from * from_.wo;
    const pt::Ray ray{pose_.point(start), pose_.direction(-from_.wo),
                      0.999 * from_.seen_from * pose_.size, 1.001 * from_.seen_from * pose_.size};
    const auto hit = scene_.tracer.closest(scene_.primitives, ray);
    if (!hit || hit->primitive != 0) return std::nullopt;
    Situation s{scene_, surface_point(scene_, ray, *hit), {}, {}, {}, {}};
    // The tracer refers to nothing, but must be made for the primitives where they are now.
    s.scene.tracer = pt::Tracer(pt::Engine::linear, s.scene.primitives);
    return s;
  }

 private:
  int material(Rgb albedo, Rgb emission) {
    scene_.materials.push_back({"", albedo, emission, ""});
    return static_cast<int>(scene_.materials.size()) - 1;
  }

  void triangle(Vec3 a, Vec3 b, Vec3 c, int material) {
    scene_.primitives.triangles.push_back(
        pt::flat_triangle(pose_.point(a), pose_.point(b), pose_.point(c)));
    scene_.material_of.push_back(material);
  }

  void ball(Vec3 center, double radius, int material) {
    scene_.primitives.spheres.push_back({pose_.point(center), pose_.size * radius});
    ball_materials_.push_back(material);
  }

  // The triangle of the point, whose corners share the shading normal.
  void add_patch() {
    const pt::Frame frame = pt::frame_from_normal(from_.true_normal);
    const double s = from_.side;
    triangle(s * (-frame.x - frame.y), s * (2 * frame.x - frame.y), s * (-frame.x + 2 * frame.y),
             material(from_.albedo, from_.emission));
    pt::Triangle& patch = scene_.primitives.triangles[0];
    if (from_.true_normal.z != 1) patch.n0 = patch.n1 = patch.n2 = pose_.direction({0, 0, 1});
  }

  void add(const WildLight& light) {
    const int made = light.has_body ? material(pt::gray(0.5), light.radiance) : 0;
    switch (light.kind) {
      case Kind::rectangle:
        return add_rectangle(light, made);
      case Kind::ball:
        scene_.lights.emplace_back(
            pt::SphereLight{pose_.point(light.at), pose_.size * light.radius, light.radiance});
        if (light.has_body) ball(light.at, light.radius, made);
        return;
      case Kind::cube:
        return add_cube(light, made);
      case Kind::point:
        scene_.lights.emplace_back(
            pt::PointLight{pose_.point(light.at), pose_.size * pose_.size * light.radiance});
        return;
      case Kind::directional:
        scene_.lights.emplace_back(
            pt::DirectionalLight{-pose_.direction(light.at), light.radiance});
        return;
      case Kind::sky:
        scene_.lights.emplace_back(pt::AmbientLight{light.radiance});
        return;
    }
  }

  void add_rectangle(const WildLight& light, int made) {
    const Rectangle shape{light.at, light.u, light.v};
    // A light's n is cross(u, v) or its opposite.
    const bool exchanged = light.u.x < light.v.x;
    scene_.lights.emplace_back(pt::RectangleLight{
        pose_.point(light.at), pose_.size * pose_.direction(exchanged ? light.v : light.u),
        pose_.size * pose_.direction(exchanged ? light.u : light.v), pose_.direction(shape.n()),
        light.radiance});
    if (!light.has_body) return;
    const std::vector<Vec3> c = shape.corners();
    triangle(c[0], c[1], c[2], made);
    triangle(c[0], c[2], c[3], made);
  }

  void add_cube(const WildLight& light, int made) {
    const Vec3 w = length(light.u) * normalize(cross(light.u, light.v));
    std::vector<pt::MeshLight::Face> faces;
    const std::array axes{light.u, light.v, w};
    for (int axis = 0; axis < 3; ++axis) {
      for (const double side : {-0.5, 0.5}) {
        // cross(u, v) of each face is along its outside.
        const Vec3 u = axes[(axis + 1) % 3], v = axes[(axis + 2) % 3];
        const Vec3 center = light.at + side * axes[axis];
        const std::vector<Vec3> c =
            (side > 0 ? Rectangle{center, u, v} : Rectangle{center, v, u}).corners();
        for (const auto& [i, k] : {std::pair{1, 2}, std::pair{2, 3}}) {
          faces.push_back({pose_.point(c[0]), pose_.point(c[i]), pose_.point(c[k])});
          if (light.has_body) triangle(c[0], c[i], c[k], made);
        }
      }
    }
    scene_.lights.emplace_back(pt::make_mesh_light(faces, light.radiance));
  }

  void add(const WildSurface& surface) {
    const int made = material(surface.albedo, surface.emission);
    if (surface.radius > 0) {
      ball(surface.at, surface.radius, made);
    } else {
      triangle(surface.at, surface.p1, surface.p2, made);
    }
  }

  void add(const WildRoom& room) {
    for (int wall = 0; wall < 6; ++wall) {
      const int axis = wall / 2;
      Vec3 x, y, z;
      x[axis] = wall % 2 == 0 ? -room.half : room.half;
      y[(axis + 1) % 3] = 2 * room.half;
      z[(axis + 2) % 3] = 2 * room.half;
      const Rectangle inwards =
          wall % 2 == 0 ? Rectangle{room.center + x, y, z} : Rectangle{room.center + x, z, y};
      const std::vector<Vec3> c = inwards.corners();
      const int made = material(room.albedo[wall], room.emission[wall]);
      triangle(c[0], c[1], c[2], made);
      triangle(c[0], c[2], c[3], made);
    }
  }

  const WildScene& from_;
  Pose pose_;
  pt::Scene scene_;
  std::vector<int> ball_materials_;  // spheres come after all triangles
};

}  // namespace

std::optional<Situation> made(const WildScene& scene) { return Maker(scene).situation(); }

}  // namespace grader::check
