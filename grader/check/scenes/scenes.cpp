#include "grader/check/scenes/scenes.h"

#include "grader/check/generators/generators.h"
#include "grader/check/language/show.h"
#include "grader/check/scenes/closed_forms.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>

namespace grader::check {

using pt::Rgb;
using pt::Vec3;

namespace {

constexpr Vec3 kOrigin{0, 0, 0};
constexpr Vec3 kUp{0, 0, 1};

constexpr std::size_t kMaxTold = 4;  // how many lights and how many surfaces a text lists

Rgb any_albedo_of_a_shade() { return {0.2, 0.5, 0.7}; }

double solid_angle_of(const std::vector<Vec3>& c) {
  return solid_angle(c[0], c[1], c[2], kOrigin) + solid_angle(c[0], c[2], c[3], kOrigin);
}

}  // namespace

pt::Scene ready(pt::Scene scene) {
  scene.tracer = pt::Tracer(pt::Engine::wide, scene.primitives);
  return scene;
}

rc::Gen<Pose> pose(double range, double far) {
  return rc::gen::exec([range, far] {
    const pt::Frame turn = *rc::gen::oneOf(rotation(), rotation_of_axes());
    const double size = *magnitude(1 / range, range);
    return Pose{turn, size * *point(far), size};
  });
}

rc::Gen<Pose> unturned_pose() {
  return rc::gen::map(pose(), [](Pose pose) {
    pose.turn = {};
    return pose;
  });
}

namespace {

// The normal itself, or a direction in the plane of two axes: one or two of its components are exactly 0.
rc::Gen<Vec3> exact_direction_above(double tilt) {
  return rc::gen::map(rc::gen::pair(real(0, tilt), whole(0, 7)),
                      [](const std::pair<double, int>& at) {
                        const auto& [angle, way] = at;
                        if (way > 3) return kUp;
                        const double r = way % 2 == 0 ? std::sin(angle) : -std::sin(angle);
                        return way < 2 ? Vec3{r, 0, std::cos(angle)} : Vec3{0, r, std::cos(angle)};
                      });
}

}  // namespace

rc::Gen<Vec3> direction_above(double tilt) {
  const auto any = rc::gen::map(rc::gen::pair(real(0, tilt), real(-pt::kPi, pt::kPi)),
                                [](const std::pair<double, double>& angles) {
                                  const double r = std::sin(angles.first);
                                  return Vec3{r * std::cos(angles.second),
                                              r * std::sin(angles.second), std::cos(angles.first)};
                                });
  return rc::gen::oneOf(any, any, exact_direction_above(tilt));
}

rc::Gen<Vec3> direction_above_at(const rc::Gen<double>& height) {
  return rc::gen::map(rc::gen::pair(height, real(-pt::kPi, pt::kPi)),
                      [](const std::pair<double, double>& at) {
                        const double r = std::sqrt(1 - at.first * at.first);
                        return Vec3{r * std::cos(at.second), r * std::sin(at.second), at.first};
                      });
}

rc::Gen<Rectangle> rectangle_above(double tilt, double narrow, double wide) {
  return rc::gen::exec([=] {
    const Vec3 towards = *direction_above(tilt);
    const double distance = *real(0.9, 1.1);
    const Vec3 turned = pt::frame_from_normal(-towards).to_world(*direction_above(0.8));
    const pt::Frame frame = pt::frame_from_normal(turned);
    return Rectangle{distance * towards, *real(narrow, wide) * frame.x,
                     *real(narrow, wide) * frame.y};
  });
}

std::vector<Rectangle> cube() {
  return {{{0, 0, 1}, {0, 2, 0}, {2, 0, 0}},    {{1, 0, 0.5}, {0, 0, 1}, {0, 2, 0}},
          {{-1, 0, 0.5}, {0, 2, 0}, {0, 0, 1}}, {{0, 1, 0.5}, {2, 0, 0}, {0, 0, 1}},
          {{0, -1, 0.5}, {0, 0, 1}, {2, 0, 0}}, {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}}};
}

std::vector<Rectangle> cube_around() {
  std::vector<Rectangle> walls = cube();
  for (Rectangle& wall : walls) wall.center = wall.center - Vec3{0, 0, 0.5};
  return walls;
}

Rectangle Rectangle::part(double a0, double a1, double b0, double b1) const {
  return {at((a0 + a1) / 2, (b0 + b1) / 2), (a1 - a0) * u, (b1 - b0) * v};
}

void showValue(const Rectangle& rectangle, std::ostream& out) {
  out << fmt::format("rectangle at {}, sides {} {}", brief(rectangle.center), brief(rectangle.u),
                     brief(rectangle.v));
}

void showValue(const Situation& situation, std::ostream& out) {
  const pt::SurfacePoint& p = situation.point;
  out << situation.text
      << fmt::format("the point: wo {}, albedo {}{}{}", brief(p.frame.to_local(p.wo)),
                     brief(p.albedo), is_black(p.emission) ? "" : ", emission " + brief(p.emission),
                     dot(p.n, p.geometric_normal) < 0 ? ", seen from behind" : "");
}

double coordinate_size(const pt::Primitives& primitives) {
  double size = 0;
  for (const pt::Triangle& t : primitives.triangles) {
    size = std::max({size, max_abs(t.p0), max_abs(t.p1), max_abs(t.p2)});
  }
  for (const pt::Sphere& s : primitives.spheres) {
    size = std::max(size, max_abs(s.center) + s.radius);
  }
  return size;
}

SceneMaker::SceneMaker(const Pose& pose) : pose_(pose) {}

SceneMaker& SceneMaker::patch(Rgb albedo, Vec3 wo, bool from_behind, Rgb emission) {
  const Rectangle front{kOrigin, {0.125, 0, 0}, {0, 0.125, 0}};
  surface(from_behind ? front.flipped() : front, albedo, emission);
  point(albedo, wo);
  if (from_behind) point_.geometric_normal = -point_.n;
  if (!from_behind) point_.emission = emission;
  return *this;
}

SceneMaker& SceneMaker::point(Rgb albedo, Vec3 wo) {
  point_.p = pose_.point(kOrigin);
  point_.n = pose_.direction(kUp);
  point_.geometric_normal = point_.n;
  point_.frame = pt::frame_from_normal(point_.n);
  point_.wo = pose_.direction(wo);
  point_.albedo = albedo;
  return *this;
}

SceneMaker& SceneMaker::rectangle(const Rectangle& shape, Rgb radiance, Body body, double hidden,
                                  double way) {
  // A light's n is cross(u, v) or its opposite.
  const bool exchanged = shape.u.x < shape.v.x;
  const Vec3 u = exchanged ? shape.v : shape.u, v = exchanged ? shape.u : shape.v;
  scene_.lights.emplace_back(
      pt::RectangleLight{pose_.point(shape.center), pose_.size * pose_.direction(u),
                         pose_.size * pose_.direction(v), pose_.direction(shape.n()), radiance});
  lights_.push_back(fmt::format("rectangle light at {}, sides {} {}, emits to {}, radiance {}",
                                brief(shape.center), brief(u), brief(v), brief(shape.n()),
                                brief(radiance)));
  shines(shape, radiance, body, hidden, way);
  return *this;
}

SceneMaker& SceneMaker::mesh(const Rectangle& shape, Rgb radiance, Body body, double hidden,
                             double way, Strips strips) {
  const auto begin_of = [&](int i) {
    return std::pow(static_cast<double>(i) / strips.count, strips.power);
  };
  std::vector<pt::MeshLight::Face> faces;
  for (int i = 0; i < strips.count; ++i) {
    std::vector<Vec3> q = shape.part(begin_of(i), begin_of(i + 1), 0, 1).corners();
    for (Vec3& corner : q) corner = pose_.point(corner);
    faces.push_back({q[0], q[1], q[2]});
    faces.push_back({q[0], q[2], q[3]});
  }
  scene_.lights.emplace_back(pt::make_mesh_light(faces, radiance));
  const std::vector<Vec3> c = shape.corners();
  lights_.push_back(fmt::format("mesh light of {} triangles, corners {} {} {} {}, radiance {}",
                                faces.size() == 2 ? "two" : std::to_string(faces.size()),
                                brief(c[0]), brief(c[1]), brief(c[2]), brief(c[3]),
                                brief(radiance)));
  shines(shape, radiance, body, hidden, way);
  return *this;
}

// The surface of a flat light, what hides it, and its irradiance.
void SceneMaker::shines(const Rectangle& shape, Rgb radiance, Body body, double hidden,
                        double way) {
  if (body == Body::surface) surface(shape, pt::gray(0.5), radiance);
  if (hidden > 0) {
    const Rectangle shade =
        shape.part(hidden < 1 ? -0.25 : -0.5, hidden < 1 ? hidden : 1.5, -0.5, 1.5);
    surface(shade.scaled(way), any_albedo_of_a_shade());
  }
  if (dot(shape.n(), shape.center) < 0 && hidden < 1) {
    const std::vector<Vec3> seen = shape.part(hidden, 1, 0, 1).corners();
    arrives(radiance, cosine_of_polygon(seen, kOrigin, kUp), solid_angle_of(seen));
  }
}

SceneMaker& SceneMaker::ball(Vec3 center, double radius, Rgb radiance, Body body) {
  const pt::Sphere sphere{pose_.point(center), pose_.size * radius};
  scene_.lights.emplace_back(pt::SphereLight{sphere.center, sphere.radius, radiance});
  lights_.push_back(fmt::format("sphere light around {}, radius {}, radiance {}", brief(center),
                                brief(radius), brief(radiance)));
  if (body == Body::surface) {
    scene_.primitives.spheres.push_back(sphere);
    ball_materials_.push_back(material(pt::gray(0.5), radiance));
    is_met(radiance);
  }
  const double squared = radius * radius / length_squared(center);
  if (center.z > 0) {
    arrives(radiance, cosine_of_ball(center, radius, kOrigin, kUp),
            2 * pt::kPi * squared / (1 + std::sqrt(1 - squared)));
  }
  return *this;
}

SceneMaker& SceneMaker::point_light(Vec3 position, Rgb intensity, bool hidden, double way) {
  scene_.lights.emplace_back(
      pt::PointLight{pose_.point(position), pose_.size * pose_.size * intensity});
  lights_.push_back(
      fmt::format("point light at {}, intensity {}", brief(position), brief(intensity)));
  if (hidden) shade(way * position);
  const double squared = length_squared(position);
  if (!hidden && position.z > 0) {
    arrives(intensity, position.z / squared / std::sqrt(squared), 1 / squared);
  }
  return *this;
}

SceneMaker& SceneMaker::directional_light(Vec3 towards, Rgb irradiance, bool hidden) {
  scene_.lights.emplace_back(pt::DirectionalLight{-pose_.direction(towards), irradiance});
  lights_.push_back(
      fmt::format("directional light along {}, irradiance {}", brief(-towards), brief(irradiance)));
  if (hidden) shade(1.5 * towards);
  if (!hidden && towards.z > 0) arrives(irradiance, towards.z, 1);
  return *this;
}

SceneMaker& SceneMaker::sky(Rgb radiance) {
  scene_.lights.emplace_back(pt::AmbientLight{radiance});
  const Vec3 up{0, 1, 0};
  lights_.push_back(fmt::format("sky of radiance {} on the side of {}", brief(radiance),
                                brief(pose_.turn.to_local(up))));
  arrives(radiance, cosine_of_half_space(up, pose_.direction(kUp)), 2 * pt::kPi);
  brightest_ += radiance;
  return *this;
}

void SceneMaker::arrives(Rgb radiance, double cosine, double facing) {
  irradiance_ += radiance * cosine;
  facing_ += radiance * facing;
}

// Rays meet a surface of this emission.
void SceneMaker::is_met(Rgb emission) {
  for (int channel = 0; channel < 3; ++channel) {
    brightest_[channel] = std::max(brightest_[channel], emission[channel]);
  }
}

// A dark square around a position, facing the origin. The position is not on its diagonal, which is
// the edge of two triangles: a ray that meets just an edge may miss both.
void SceneMaker::shade(Vec3 position) {
  const pt::Frame frame = pt::frame_from_normal(normalize(position));
  const double width = 0.4 * length(position);
  const Rectangle around{position, width * frame.x, width * frame.y};
  surface(around.part(-0.05, 1, 0, 1), any_albedo_of_a_shade());
}

SceneMaker& SceneMaker::surface(const Rectangle& shape, Rgb albedo, Rgb emission,
                                std::optional<Vec3> smooth) {
  const int index = material(albedo, emission);
  const Vec3 p00 = pose_.point(shape.at(0, 0)), p10 = pose_.point(shape.at(1, 0));
  const Vec3 p11 = pose_.point(shape.at(1, 1)), p01 = pose_.point(shape.at(0, 1));
  for (const Vec3 middle : {p10, p11}) {
    const Vec3 last = middle == p10 ? p11 : p01;
    pt::Triangle& t =
        scene_.primitives.triangles.emplace_back(pt::flat_triangle(p00, middle, last));
    if (smooth) t.n0 = t.n1 = t.n2 = pose_.direction(*smooth);
    scene_.material_of.push_back(index);
  }
  is_met(emission);
  const std::string glow = is_black(emission) ? "" : ", emission " + brief(emission);
  const std::string shading = smooth ? ", shading normal " + brief(*smooth) : "";
  surfaces_.push_back(fmt::format("surface at {}, sides {} {}, albedo {}{}{}", brief(shape.center),
                                  brief(shape.u), brief(shape.v), brief(albedo), glow, shading));
  return *this;
}

SceneMaker& SceneMaker::dark_ball(Vec3 center, double radius) {
  scene_.primitives.spheres.push_back({pose_.point(center), pose_.size * radius});
  ball_materials_.push_back(material(any_albedo_of_a_shade(), {}));
  surfaces_.push_back(fmt::format("dark ball around {}, radius {}", brief(center), brief(radius)));
  return *this;
}

// Surfaces that look alike are of one material.
int SceneMaker::material(Rgb albedo, Rgb emission) {
  const auto is_alike = [&](const pt::Material& other) {
    return other.albedo == albedo && other.emission == emission;
  };
  const auto found = std::ranges::find_if(scene_.materials, is_alike);
  if (found != scene_.materials.end()) {
    return static_cast<int>(found - scene_.materials.begin());
  }
  scene_.materials.push_back({"", albedo, emission, ""});
  return static_cast<int>(scene_.materials.size()) - 1;
}

// If there are many lights or surfaces, only the first few are listed.
std::string SceneMaker::text() const {
  std::string text = fmt::format(
      "here the point is at (0, 0, 0) and its normal along z; the test scales this by {}, turns z "
      "to {}, and moves it by {}\n",
      brief(pose_.size), brief(pose_.direction({0, 0, 1})), brief(pose_.shift));
  for (const std::vector<std::string>* list : {&lights_, &surfaces_}) {
    const std::size_t told = list->size() > kMaxTold + 1 ? kMaxTold : list->size();
    for (std::size_t i = 0; i < told; ++i) text += (*list)[i] + "\n";
    if (told < list->size()) {
      text += fmt::format("and {} more {}\n", list->size() - told,
                          list == &lights_ ? "lights" : "surfaces");
    }
  }
  return text;
}

Situation SceneMaker::done() const {
  Situation all{scene_, point_, point_.albedo * irradiance_ / pt::kPi, text(), facing_, brightest_};
  all.scene.material_of.insert(all.scene.material_of.end(), ball_materials_.begin(),
                               ball_materials_.end());
  all.scene = ready(std::move(all.scene));
  all.point.scale = std::max(coordinate_size(all.scene.primitives), max_abs(all.point.p));
  return all;
}

}  // namespace grader::check
