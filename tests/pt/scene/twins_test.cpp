// Surfaces in one place: what is seen does not depend on rounding, nor on the engine.
#include "pt/scene/collada/twins.h"

#include "collada_text.h"
#include "pt/sampling/sampler.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>

namespace pt {
namespace {

// Triangles far from each other, each with up to four copies whose corners are in any order.
// Material i is known by its red; those from 5 on emit.
struct Pile {
  Scene scene;
  // For each triangle its first copy's corners, and the materials in order, by whether a copy faces as the first.
  std::vector<Triangle> first;
  std::vector<std::vector<int>> same, turned;
};

Pile make_pile(Sampler& sampler) {
  Pile pile;
  for (int m = 0; m < 10; ++m) {
    pile.scene.materials.push_back({"m", {m / 10., .5, .5}, m < 5 ? Rgb{} : gray(m), ""});
  }
  const auto number = [&](int below) { return static_cast<int>(sampler.next_1d() * below); };
  const auto point = [&] { return Vec3{sampler.next_1d(), sampler.next_1d(), sampler.next_1d()}; };
  struct Copy {
    int place;
    Triangle triangle;
    int material;
  };
  std::vector<Copy> copies;
  for (int place = 0; place < 12; ++place) {
    const Vec3 at{3. * place, 0, 0};
    const Triangle t = flat_triangle(at + point(), at + point(), at + point());
    for (int n = 1 + number(4); n > 0; --n) {
      const Vec3 c[3] = {t.p0, t.p1, t.p2};
      const int k = number(3), step = 1 + number(2);
      copies.push_back(
          {place, flat_triangle(c[k], c[(k + step) % 3], c[(k + 2 * step) % 3]), number(10)});
    }
  }
  for (int i = static_cast<int>(copies.size()) - 1; i > 0; --i) {
    std::swap(copies[i], copies[number(i + 1)]);
  }
  pile.first.resize(12);
  pile.same.resize(12);
  pile.turned.resize(12);
  for (const Copy& copy : copies) {
    pile.scene.primitives.triangles.push_back(copy.triangle);
    pile.scene.material_of.push_back(copy.material);
    if (pile.same[copy.place].empty()) pile.first[copy.place] = copy.triangle;
    const bool faces_as_first =
        dot(geometric_normal(pile.first[copy.place]), geometric_normal(copy.triangle)) > 0;
    (faces_as_first ? pile.same : pile.turned)[copy.place].push_back(copy.material);
  }
  return pile;
}

// The first that emits, else the first.
std::optional<int> shown(const std::vector<int>& materials) {
  const auto lamp = std::find_if(materials.begin(), materials.end(), [](int m) { return m >= 5; });
  if (lamp != materials.end()) return *lamp;
  return materials.empty() ? std::nullopt : std::optional(materials[0]);
}

TEST(Twins, show_the_material_of_the_side_that_is_seen_by_every_engine) {
  Sampler sampler(69);
  for (int round = 0; round < 40; ++round) {
    Pile pile = make_pile(sampler);
    merge_twins(pile.scene);
    ASSERT_EQ(pile.scene.primitives.size(), 12);
    for (const Engine engine : {Engine::linear, Engine::task, Engine::wide}) {
      pile.scene.tracer = Tracer(engine, pile.scene.primitives);
      for (int place = 0; place < 12; ++place) {
        const Triangle& t = pile.first[place];
        const double a = .1 + .3 * sampler.next_1d(), b = .1 + .3 * sampler.next_1d();
        const Vec3 p = t.p0 + a * (t.p1 - t.p0) + b * (t.p2 - t.p0);
        const Vec3 n = normalize(geometric_normal(t));
        for (const bool in_front : {true, false}) {
          const Vec3 side = in_front ? n : -n;
          const Ray ray{p + .01 * side, -side};
          const std::optional<Hit> hit = pile.scene.closest(ray);
          ASSERT_TRUE(hit);
          const SurfacePoint point = surface_point(pile.scene, ray, *hit);
          const int front = *shown(pile.same[place]);
          const std::optional<int> own = in_front ? front : shown(pile.turned[place]);
          EXPECT_EQ(point.albedo.r, own.value_or(front) / 10.);
          EXPECT_EQ(point.emission, own && *own >= 5 ? gray(*own) : Rgb{});
        }
      }
    }
  }
}

// Regular polygons of 3 to 9 corners, forwards and backwards, from any corner on, in two colours.
TEST(Twins, of_more_corners_are_one_surface_wherever_they_begin) {
  Sampler sampler(70);
  const auto number = [&](int below) { return static_cast<int>(sampler.next_1d() * below); };
  for (int round = 0; round < 60; ++round) {
    const int n = 3 + number(7);
    std::string corners, faces[2];
    for (int i = 0; i < n; ++i) {
      corners += fmt::format("{} {} 0 ", std::cos(2 * kPi * i / n), std::sin(2 * kPi * i / n));
    }
    for (std::string& face : faces) {
      const int start = number(n), step = number(2) == 0 ? 1 : n - 1;
      for (int i = 0; i < n; ++i) face += fmt::format("{} ", (start + i * step) % n);
    }
    SceneText text;
    for (int which = 0; which < 2; ++which) {
      const std::string id = which == 0 ? "white" : "red";
      text = with_material(text, id, common_diffuse(which == 0 ? "1 1 1 1" : "1 0 0 1"));
      text.geometries += mesh(id + "-g", corners, 3 * n, "polygons", "count=\"1\" material=\"m\"",
                              "<p>" + faces[which] + "</p>");
      text.nodes += node(instance(id + "-g", id));
    }
    const LoadedScene loaded = load(text);
    EXPECT_EQ(loaded.scene.primitives.size(), n - 2) << faces[0] << "and " << faces[1];
    EXPECT_TRUE(has_note(loaded, "lie exactly on"));
    EXPECT_FALSE(has_note(loaded, "in their plane"));
  }
}

LoadedScene load_lamps(const std::vector<std::string>& transforms) {
  SceneText text =
      with_material({}, "lamp", course("<emission><radiance>2 2 2</radiance></emission>"));
  text.geometries = quad_mesh() + sphere("ball", "1");
  for (const std::string& transform : transforms) {
    const char* shape = transform == "ball" ? "ball" : "quad";
    text.nodes += node((transform == "ball" ? "" : transform) + instance(shape, "lamp"));
  }
  return load(text);
}

// By light sampling two lamps in one place would be twice as bright as by hemisphere sampling.
TEST(Twins, of_lamps_are_one_lamp) {
  EXPECT_EQ(load_lamps({""}).scene.lights.size(), 1u);
  const LoadedScene two = load_lamps({"", ""});
  EXPECT_EQ(two.scene.lights.size(), 1u);
  EXPECT_TRUE(std::holds_alternative<RectangleLight>(two.scene.lights.at(0)));
  EXPECT_EQ(two.scene.primitives.size(), 2);
  EXPECT_TRUE(has_note(two,
                       "2 surfaces lie exactly on another one that faces the same way and are "
                       "left out, 2 of them lamps on a lamp."));
  EXPECT_EQ(load_lamps({"ball", "ball", "ball"}).scene.lights.size(), 1u);
  // Back to back they shine to both sides.
  const LoadedScene both = load_lamps({"", "<scale>1 1 -1</scale>"});
  EXPECT_TRUE(has_note(both, "lie exactly on the back of another one"));
  EXPECT_EQ(both.scene.lights.size(), 2u);
  EXPECT_EQ(both.scene.primitives.size(), 2);
  const LoadedScene apart = load_lamps({"", "<translate>0 0 .1</translate>"});
  EXPECT_EQ(apart.scene.lights.size(), 2u);
  EXPECT_FALSE(has_note(apart, "lie exactly on"));
}

// Shifted by half their width in their own plane, two quads of two triangles each overlap.
TEST(Twins, that_are_not_the_same_are_counted) {
  EXPECT_TRUE(has_note(load_lamps({"", "<translate>.5 0 0</translate>"}),
                       "triangles have another one in their plane"));
  for (const char* transform : {"<translate>1 0 0</translate>", "<translate>.5 0 1e-6</translate>",
                                "<translate>5 0 0</translate>"}) {
    EXPECT_FALSE(has_note(load_lamps({"", transform}), "in their plane")) << transform;
  }
}

}  // namespace
}  // namespace pt
