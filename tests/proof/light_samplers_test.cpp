#include "pt/scene/light.h"
#include "pt/tasks/hit_sphere.h"
#include "tests/proof/closed_forms.h"
#include "tests/proof/directions.h"

// The directions to each kind of light, their density and their distance.

namespace pt::proof {
namespace {

// The density per steradian along w from p, for points chosen evenly on triangles of this total
// area, from the hits of w with the triangles. Triangles that face away have none.
double triangles_density(const std::vector<MeshLight::Face>& faces, Vec3 p, Vec3 w) {
  double area = 0, density = 0;
  for (const auto& f : faces) area += 0.5 * length(cross(f.p1 - f.p0, f.p2 - f.p0));
  for (const auto& f : faces) {
    const Vec3 a = f.p0 - p, b = f.p1 - p, c = f.p2 - p;
    const double ab = dot(w, cross(a, b)), bc = dot(w, cross(b, c)), ca = dot(w, cross(c, a));
    if (!(ab < 0 && bc < 0 && ca < 0)) continue;
    const Vec3 n = normalize(cross(f.p1 - f.p0, f.p2 - f.p0));
    const double distance = dot(a, n) / dot(w, n);
    density += distance * distance / (-dot(w, n) * area);
  }
  return density;
}

std::vector<MeshLight::Face> two_faces(const Polygon& p) {
  return {{p[0], p[1], p[2]}, {p[0], p[2], p[3]}};
}

struct LightCase {
  std::string name;
  Light light;
  Bins bins;
  std::function<double(Vec3)> density;  // of wi
  double solid_angle;
};

constexpr Vec3 kPoint{0.3, -0.2, 0.1};

LightCase mesh_case(const std::string& name, const Light& light,
                    const std::vector<MeshLight::Face>& faces, Vec3 center) {
  double solid = 0;
  for (const auto& f : faces) solid += solid_angle(kPoint, f.p0, f.p1, f.p2);
  return {name, light, Bins{frame_from_normal(normalize(center - kPoint)), 1},
          [faces](Vec3 w) { return triangles_density(faces, kPoint, w); }, solid};
}

std::vector<LightCase> light_cases() {
  const Vec3 center{1, 0.5, 1.2}, u{0.2, 1, 0}, v{1.2, 0, -0.9};
  const Vec3 n = normalize(cross(u, v));  // towards kPoint
  std::vector<LightCase> cases;
  cases.push_back(mesh_case("rectangle", RectangleLight{center, u, v, n, gray(1)},
                            two_faces(parallelogram(center, u, v)), center));
  std::vector<MeshLight::Face> faces = two_faces(parallelogram(center, u, v));
  faces.push_back({{-1, 0, 1}, {0, 0.5, 0.9}, {-0.5, -1, 1.5}});
  faces.push_back({{0, 0, 2}, {0, 0, 2}, {1, 1, 2}});  // no area
  const MeshLight mesh = make_mesh_light(faces, gray(1));
  cases.push_back(mesh_case("mesh", mesh, mesh.faces, {0.2, 0, 1.2}));
  for (const double distance : {1.1, 3.0, 500.0}) {
    const Vec3 axis = normalize({1, 2, -2});
    const double cap = 1 - std::sqrt(1 - 1 / (distance * distance));
    cases.push_back({"sphere", SphereLight{kPoint + 0.5 * distance * axis, 0.5, gray(1)},
                     Bins{frame_from_normal(axis), cap * (1 + 1e-9)},
                     [cap](Vec3) { return 1 / (2 * kPi * cap); }, 2 * kPi * cap});
  }
  cases.push_back({"ambient", AmbientLight{gray(1)}, Bins{},
                   [](Vec3 w) { return w.y > 0 ? 1 / (2 * kPi) : 0; }, 2 * kPi});
  return cases;
}

TEST(SampleLight, has_the_density_it_says) {
  for (const LightCase& c : light_cases()) {
    expect_density(
        c.bins, [&](Sampler& s) { return sample_light(c.light, kPoint, s).wi; }, c.density, c.name);
    Sampler sampler(54);
    Running inverse_pdf;
    for (int i = 0; i < 100000; ++i) {
      const LightSample sample = sample_light(c.light, kPoint, sampler);
      ASSERT_EQ(sample.radiance, gray(1)) << c.name;
      ASSERT_FALSE(sample.delta);
      // At a distance of 500 radii, 1 - sqrt(1 - x) above has lost six digits.
      ASSERT_NEAR(sample.pdf / c.density(sample.wi), 1, 1e-9) << c.name;
      inverse_pdf.add(1 / sample.pdf);
    }
    const double lost = 1e-9 * c.solid_angle;
    EXPECT_LE(std::abs(inverse_pdf.mean - c.solid_angle),
              lost + two_sided_threshold(kLevel) * inverse_pdf.standard_error())
        << c.name;
  }
}

// Half of the mesh faces away from the point: these samples contribute nothing, but they count.
TEST(SampleLight, is_dark_from_behind) {
  const Polygon near = parallelogram({0, 0, 2}, {0, 1, 0}, {1, 0, 0});
  const Polygon away = parallelogram({3, 0, 2}, {1, 0, 0}, {0, 1, 0});
  std::vector<MeshLight::Face> faces = two_faces(near);
  for (const auto& face : two_faces(away)) faces.push_back(face);
  const Light light = make_mesh_light(faces, gray(1));
  Sampler sampler(55);
  Running seen;
  for (int i = 0; i < 100000; ++i) {
    const LightSample sample = sample_light(light, {}, sampler);
    ASSERT_GT(sample.pdf, 0);
    const bool bright = !is_black(sample.radiance);
    ASSERT_EQ(bright, triangles_density(two_faces(near), {}, sample.wi) > 0);
    seen.add(bright ? 1 / sample.pdf : 0);
  }
  expect_mean(
      seen, solid_angle({}, near[0], near[1], near[2]) + solid_angle({}, near[0], near[2], near[3]),
      "solid angle of the bright half");
  const LightSample inside = sample_light(SphereLight{{0.1, 0, 0}, 1, gray(1)}, {}, sampler);
  EXPECT_EQ(inside.radiance, Rgb{});
}

// The light that a white surface with normal n at p reflects of a lamp that nothing hides, times pi.
double received(const Light& light, Vec3 p, Vec3 n, Sampler& sampler) {
  constexpr int kSamples = 200;
  double sum = 0;
  for (int i = 0; i < kSamples; ++i) {
    const LightSample one = sample_light(light, p, sampler);
    sum += one.radiance.g * std::max(0.0, dot(one.wi, n)) / one.pdf;
  }
  return sum / kSamples;
}

// Points in the plane of a lamp, of its own surface and beside it, on both of their sides and on a wall that stands on
// the plane: rounding decides on which side of the lamp they are, and so little light may depend on
// it that nobody sees it. The same for a point light in the plane of the surface.
TEST(SampleLight, in_its_own_plane_is_as_good_as_dark) {
  Sampler sampler(59);
  const auto draw = [&] { return Vec3{sampler.next_1d(), sampler.next_1d(), sampler.next_1d()}; };
  for (const double away : {0.0, 1.0, 1e3, 1e6}) {
    const double rounding = 1e-10 * (1 + away);
    for (int i = 0; i < 200; ++i) {
      const Vec3 o = away * draw(), u = draw(), v = draw();
      const Vec3 n = normalize(cross(u, v));
      if (!(length(cross(u, v)) > .05)) continue;
      const RectangleLight rectangle{o + .5 * (u + v), u, v, n, gray(1)};
      const MeshLight triangle = make_mesh_light({{o, o + u, o + v}}, gray(1));
      const double a = 2 * sampler.next_1d() - .5, b = 2 * sampler.next_1d() - .5;
      const Vec3 p = o + a * u + b * v;
      for (const Vec3 side : {n, -n, normalize(u), -normalize(v)}) {
        EXPECT_LT(received(rectangle, p, side, sampler), rounding) << away << " " << a << " " << b;
        EXPECT_LT(received(triangle, p, side, sampler), rounding) << away << " " << a << " " << b;
      }
      const PointLight lamp{o, gray(1)};
      const double close = length(p - o);
      if (close > .1) {
        EXPECT_LT(received(lamp, p, n, sampler), rounding) << away;
      }
      // In front of it there is light.
      EXPECT_GT(received(rectangle, rectangle.center + .1 * n, -n, sampler), .01);
    }
  }
}

// A point of a sphere is computed from a ray, with rounding errors on both sides of the sphere. It gets nothing from its own lamp; a point
// a little farther out does.
TEST(SampleLight, is_dark_on_the_sphere_itself) {
  Sampler sampler(58);
  for (const double away : {0.0, 1.0, 1e3, 1e6}) {
    for (const double radius : {1e-3, 1.0, 1e3}) {
      for (int i = 0; i < 300; ++i) {
        const Vec3 center = away * Vec3{sampler.next_1d(), sampler.next_1d(), sampler.next_1d()};
        const Vec3 d = normalize(Vec3{sampler.next_1d() - 0.5, sampler.next_1d() - 0.5, 1});
        const Ray ray{center + 0.3 * radius * Vec3{1, -1, 0.5}, d, 0, kInfinity};
        const auto hit = hit_sphere({center, radius}, ray);
        ASSERT_TRUE(hit.has_value());
        const SphereLight light{center, radius, gray(1)};
        EXPECT_EQ(sample_light(light, ray.at(hit->t), sampler).radiance, Rgb{})
            << away << " " << radius;
        if (away > 1e5 * radius) continue;
        const Vec3 outside = center + radius * (1 + 1e-6) * d;
        EXPECT_EQ(sample_light(light, outside, sampler).radiance, gray(1)) << away << " " << radius;
      }
    }
  }
}

// p + distance wi is a point of the light, within the rounding errors of the way.
TEST(SampleLight, says_how_far_the_light_is) {
  Sampler sampler(56);
  for (const double distance : {1.1, 10.0, 1e4, 1e7, 1e9}) {
    const Vec3 center = distance * normalize({1, 2, -2});
    for (int i = 0; i < 1000; ++i) {
      const LightSample sample = sample_light(SphereLight{center, 1, gray(1)}, {}, sampler);
      const Vec3 on_light = sample.distance * sample.wi - center;
      EXPECT_NEAR(length(on_light), 1, 16 * 0x1p-53 * distance) << distance;
      EXPECT_LT(dot(on_light, sample.wi), 16 * 0x1p-53 * distance) << "the near side";
    }
  }
  const Vec3 u{0.2, 1, 0}, v{1.2, 0, -0.9}, center{1, 0.5, 1.2};
  const Vec3 n = normalize(cross(u, v));
  for (int i = 0; i < 1000; ++i) {
    const LightSample sample =
        sample_light(RectangleLight{center, u, v, n, gray(1)}, kPoint, sampler);
    EXPECT_NEAR(dot(kPoint + sample.distance * sample.wi - center, n), 0, 64 * 0x1p-53);
  }
}

// A lamp shines outwards, so there is no light inside, however near the surface.
TEST(SampleLight, of_a_sphere_is_dark_from_within) {
  const SphereLight light{{1, 2, 3}, 2, gray(5)};
  Sampler sampler(1);
  for (const double part : {0.0, 0.3, 0.6, 0.999}) {
    const Vec3 p = light.center + part * light.radius * normalize({1, -2, 2});
    const LightSample sample = sample_light(light, p, sampler);
    EXPECT_TRUE(is_black(sample.radiance)) << part;
    EXPECT_GT(sample.pdf, 0) << part;
    EXPECT_NEAR(length(sample.wi), 1, 1e-14) << part;
  }
  const Vec3 outside = light.center + 1.001 * light.radius * normalize({1, -2, 2});
  EXPECT_EQ(sample_light(light, outside, sampler).radiance, gray(5));
}

}  // namespace
}  // namespace pt::proof
