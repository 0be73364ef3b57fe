#pragma once

#include "grader/check/generators/generators.h"
#include "grader/check/generators/special.h"
#include "grader/tasks/hit_bvh/large_grid.h"
#include "grader/tasks/hit_bvh/trees.h"
#include "grader/tasks/hit_bvh/truth.h"
#include "grader/tasks/hit_bvh/walls.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

// Random scenes with trees, and rays for which all right versions of hit_triangle and hit_sphere
// agree.

namespace grader::check::hit_bvh_inputs {

struct Wanted {
  int least = 1, most = 40;
  bool spheres = true;
  double padding = 0.5;
  int max_leaf = 6;
  int min_leaf = 1;         // the tree's limit is random between the two
  double size = 2;          // of triangles; primitives are within 5 of the origin
  bool all_of_ray = false;  // the ray's range is from 0 to infinity
  bool copies = false;      // some primitives occur twice: two hits at the same t
  bool any_scale = false;   // the scene is scaled by a millionth to a million, and the direction
};

// Triangles and perhaps spheres, with up to max_leaf of them in a leaf, and a ray without an end.
inline Wanted with_leaves_of(int max_leaf, double padding, bool spheres) {
  return {.spheres = spheres,
          .padding = padding,
          .max_leaf = max_leaf,
          .min_leaf = max_leaf,
          .size = 3,
          .all_of_ray = true};
}

// A ray in any direction from the first surface on `ray`. Its range begins a little away from
// there.
inline pt::Ray from_a_surface(const pt::Primitives& primitives, pt::Ray ray, RandomNumbers& make) {
  ray.t_min = 0;
  ray.t_max = pt::kInfinity;
  const Truth truth = truth_of(primitives, ray);
  if (!truth.any()) return ray;
  const pt::Vec3 away = make.vector(-1, 1);
  return {ray.at(truth.t()), away, 1e-2 / length(away), pt::kInfinity};
}

// A ray to a point, often along an axis or in a plane of two axes.
inline pt::Ray ray_to(pt::Vec3 target, RandomNumbers& make) {
  const pt::Vec3 origin = make.vector(-12, 12);
  pt::Ray ray{origin, std::pow(10, make.between(-2.0, 2.0)) * (target - origin)};
  const int still = make.whole(0, 2) == 0 ? make.whole(1, 2) : 0, first = make.whole(0, 2);
  for (int i = first; i < first + still; ++i) {
    ray.origin[i % 3] = target[i % 3];
    ray.direction[i % 3] = kAlmostZero.at(make.whole(0, 3));
  }
  return ray;
}

// A ray close to the middle of a primitive, or anywhere. Its range may have limits.
inline pt::Ray some_ray(const pt::Primitives& primitives, const Wanted& wanted,
                        RandomNumbers& make) {
  const pt::Box aim = bounds(primitives, make.whole(0, primitives.size() - 1));
  const bool at_one = make.whole(0, 3) > 0;
  const pt::Vec3 target = at_one ? aim.center() + 0.3 * make.vector(-1, 1) : make.vector(-8, 8);
  pt::Ray ray = ray_to(target, make);
  if (wanted.all_of_ray) return ray;
  const double way = length(target - ray.origin) / length(ray.direction);
  if (make.whole(0, 2) == 0) ray.t_min = way * make.between(0.0, 1.2);
  if (make.whole(0, 2) == 0) ray.t_max = ray.t_min + way * make.between(0.0, 1.2);
  return make.whole(0, 5) == 0 ? from_a_surface(primitives, ray, make) : ray;
}

// A ray that meets no primitive at an edge or as a tangent. In the largest scenes one ray of three
// is clear in this way, so that the attempts are always enough.
inline pt::Ray some_clear_ray(const pt::Primitives& primitives, const Wanted& wanted,
                              RandomNumbers& make) {
  constexpr int kAttempts = 200;
  pt::Ray ray;
  for (int i = 0; i < kAttempts; ++i) {
    ray = some_ray(primitives, wanted, make);
    if (truth_of(primitives, ray).is_clear) break;
  }
  return ray;
}

inline pt::Triangle some_triangle(double size, RandomNumbers& make) {
  const pt::Vec3 p = make.vector(-5, 5);
  const pt::Vec3 q = p + make.vector(-size, size), r = p + make.vector(-size, size);
  pt::Triangle made = flat_triangle(p, q, r);
  made.n0 = normalize(made.n0 + make.vector(-0.3, 0.3));
  made.n1 = normalize(made.n1 + make.vector(-0.3, 0.3));
  return made;
}

inline pt::Primitives some_primitives(int n, const Wanted& wanted, RandomNumbers& make) {
  pt::Primitives primitives;
  for (int i = 0; i < n; ++i) {
    const bool sphere = wanted.spheres && make.whole(0, 2) == 0;
    const bool copy = wanted.copies && make.whole(0, 3) == 0;
    auto& [triangles, spheres] = primitives;
    if (sphere) {
      const bool again = copy && !spheres.empty();
      const double radius = 0.5 * wanted.size * make.between(0.1, 1.5);
      spheres.push_back(again ? spheres.back() : pt::Sphere{make.vector(-5, 5), radius});
    } else {
      const bool again = copy && !triangles.empty();
      triangles.push_back(again ? triangles.back() : some_triangle(wanted.size, make));
    }
  }
  return primitives;
}

inline void enlarge(Case& c, double scale) {
  for (pt::Triangle& triangle : c.primitives.triangles) {
    for (pt::Vec3* p : {&triangle.p0, &triangle.p1, &triangle.p2}) *p *= scale;
  }
  for (pt::Sphere& sphere : c.primitives.spheres) {
    sphere = {scale * sphere.center, scale * sphere.radius};
  }
  c.ray.origin *= scale;
  c.ray.t_min *= scale;
  c.ray.t_max *= scale;
}

// Makes the ray's direction longer. Its range stays the same part of the line.
inline void lengthen(pt::Ray& ray, double factor) {
  ray.direction *= factor;
  ray.t_min /= factor;
  ray.t_max /= factor;
}

// The number of primitives, whether the scene has the scale 1, and the seed from which everything else about it follows.
struct Lot {
  int n;
  bool at_one = true;
  std::uint64_t seed = 0;
};

// A scene with fewer primitives is a different scene, and most mistakes are rarer in it. So
// shrinking tries several seeds per number of primitives: all small numbers in turn.
inline rc::Gen<Lot> some_lot(int least, int most, bool any_scale = false) {
  constexpr int kNumbers = 6, kSeeds = 10;
  return rc::Gen<Lot>([=](const rc::Random& random, int size) {
    const auto [number, kind, seed] =
        rc::gen::tuple(whole(least, most), whole(0, 9), sampler_seed())(random, size).value();
    return rc::shrinkable::shrinkRecur(
        Lot{number, !any_scale || kind < 3, seed}, [=](const Lot& lot) {
          std::vector<Lot> smaller;
          for (const bool at_one : {true, false}) {
            for (int k = 0; k < kSeeds; ++k) {
              for (int n = least; n < std::min(lot.n, least + kNumbers); ++n) {
                smaller.push_back({n, at_one, lot.seed + k});
              }
            }
            if (lot.at_one) break;
          }
          return rc::seq::fromContainer(smaller);
        });
  });
}

inline Case some_case(Shape shape, const Lot& lot, const Wanted& wanted, RandomNumbers& make) {
  const int max_leaf = make.whole(wanted.min_leaf, wanted.max_leaf);
  const double scale = lot.at_one ? 1 : std::pow(10, make.whole(-6, 6));
  Case c;
  c.how = words(shape);
  c.primitives = some_primitives(lot.n, wanted, make);
  c.ray = some_clear_ray(c.primitives, wanted, make);
  enlarge(c, scale);
  c.bvh = tree_of(c.primitives, shape, max_leaf, scale * wanted.padding, make);
  if (!lot.at_one) lengthen(c.ray, std::pow(10, make.whole(-6, 5)));
  return c;
}

// Six spheres in a row among thirty other primitives, and a ray along the row with every kind of
// range.
inline std::vector<Case> ranges_along_a_row(RandomNumbers& make) {
  Case c;
  c.primitives = some_primitives(30, {.size = 3}, make);
  for (int i = 0; i < 6; ++i) c.primitives.spheres.push_back({{0, 0, 4.0 * i}, 1});
  c.bvh = tree_of(c.primitives, Shape::random, 2, 0.1, make);
  std::vector<Case> cases;
  for (const double low : {0.0, 2.7, 3.3, 4.8, 12.5, 20.0}) {
    for (const double longer : {0.4, 1.9, pt::kInfinity}) {
      c.ray = {{0.1, 0.2, -6}, {0, 0, 2}, low, low + longer};
      cases.push_back(c);
    }
  }
  return cases;
}

inline rc::Gen<Case> with_tree(const std::vector<Shape>& shapes, Wanted wanted = {}) {
  return rc::gen::exec([=] {
    const Lot lot = *some_lot(wanted.least, wanted.most, wanted.any_scale);
    const Shape shape = *rc::gen::elementOf(shapes);
    RandomNumbers make(lot.seed);
    return some_case(shape, lot, wanted, make);
  });
}

inline rc::Gen<Case> some_tree(Wanted wanted = {}) {
  return with_tree({Shape::balanced, Shape::random}, wanted);
}

// Thousands of small primitives. A ray comes close to only a few of them.
inline rc::Gen<Case> large_tree() {
  return with_tree({Shape::balanced},
                   {.least = 2000, .most = 4000, .padding = 0.01, .size = 0.2, .all_of_ray = true});
}

// Walls in any order; the ray meets them one behind the other. Many are closer together than a
// thousandth of their distance. Half of them slant, so that the ray enters their boxes long before.
// Half of the rays are parallel to an axis, or almost.
inline rc::Gen<Case> close_walls() {
  return rc::gen::exec([] {
    const Lot lot = *some_lot(2, 30);
    RandomNumbers make(lot.seed);
    Case c;
    c.ray = kThroughWalls;
    if (make.whole(0, 1) == 0) {
      c.ray.direction = {kAlmostZero.at(make.whole(0, 3)), kAlmostZero.at(make.whole(0, 3)), 1};
    }
    for (int i = 0; i < lot.n; ++i) {
      const pt::Vec3 met = c.ray.at(5 + std::pow(10, make.between(-6, 1)));
      const double steep = 0.5 * make.whole(0, 1);
      const double along_x = make.between(-steep, steep), along_y = make.between(-steep, steep);
      c.primitives.triangles.push_back(wall_at(met, along_x, along_y));
    }
    c.bvh = tree_of(c.primitives, Shape::random, 2, 0, make);
    c.how = std::string(words(Shape::random)) + ", walls close behind each other";
    return c;
  });
}

// The points on the ray are 2e-11 to 1e-6 of their distance apart.
inline rc::Gen<Case> walls_that_all_but_touch() {
  return rc::gen::exec([] {
    RandomNumbers make(*sampler_seed());
    const double near = make.between(2, 12),
                 far = near * (1 + std::pow(10, make.between(-10.7, -6)));
    Case c = flat_wall_before_a_slanting_one(near, far, make.between(0.1, 0.5));
    enlarge(c, std::pow(10, make.whole(-6, 6)));
    c.bvh = tree_of(c.primitives, Shape::random, 1, 0, make);
    c.how = "a leaf for each of two walls that all but touch where the ray meets them";
    return c;
  });
}

// Up to six walls. The range ends at the first wall, begins at the last wall, or begins and ends at
// any wall.
inline rc::Gen<Case> range_with_a_wall_at_its_end() {
  return rc::gen::exec([] {
    const int axis = *whole(0, 2), n = *whole(1, 6);
    const End end{*whole(0, 2)};
    const int wall = end == End::last ? 0 : end == End::first ? n - 1 : *whole(0, n - 1);
    const double speed = std::pow(2, *whole(-9, 9));
    RandomNumbers make(*sampler_seed());
    Case c = walls_and_range(axis, n, wall, end, speed, make);
    if (*whole(0, 2) == 0) start_at(c.ray, (4 + wall) / speed);
    return c;
  });
}

inline rc::Gen<Case> walls_with_one_t() {
  return rc::gen::exec([] {
    const int walls = *whole(2, 5);
    RandomNumbers make(*sampler_seed());
    return walls_at_one_t(walls, make);
  });
}

// The nearest wall is at this part of a wide leaf, below 1.
inline rc::Gen<Case> with_a_wide_leaf(const rc::Gen<double>& part) {
  return rc::gen::map(rc::gen::pair(whole(257, 1025), part), [](const auto& drawn) {
    const auto [walls, at] = drawn;
    return wide_leaf(walls, static_cast<int>(at * walls));
  });
}

inline rc::Gen<Case> with_squares_in_halves() {
  return rc::gen::exec([] {
    const int axis = *whole(0, 2), squares = *whole(1, 4);
    RandomNumbers make(*sampler_seed());
    return squares_in_halves(axis, squares, make);
  });
}

// Makes a triangle or a sphere smaller, so that it stays inside its box.
inline void shrink(pt::Primitives& primitives, int primitive) {
  constexpr double kSmaller = 1e-3;
  if (!primitives.is_triangle(primitive)) {
    primitives.spheres[primitive - primitives.triangles.size()].radius *= kSmaller;
    return;
  }
  pt::Triangle& made = primitives.triangles[primitive];
  made.p1 = made.p0 + kSmaller * (made.p1 - made.p0);
  made.p2 = made.p0 + kSmaller * (made.p2 - made.p0);
}

// The same with one number of the ray changed, with two of them exchanged or others of the same sum, or
// with the nearest primitive smaller. The tree stays the same.
inline Case changed(Case c) {
  if (*whole(0, 2) == 0) {
    exchange_or_add_in(c.ray);
    return c;
  }
  const Truth truth = truth_of(c);
  const double t = truth.any() ? truth.t() : 1;
  if (truth.any() && *whole(0, 3) == 0) {
    shrink(c.primitives, truth.nearest);
  } else {
    make_one_of(changes_of(c.ray, t * length(c.ray.direction), t));
  }
  return c;
}

// A thousand walls and more.
inline rc::Gen<Case> deep_pile() {
  return rc::gen::exec([] {
    const int walls = *whole(1100, 1300);
    return pile(walls, *rc::gen::arbitrary<bool>());
  });
}

// A tree with a thousand levels and more. The ray enters all of them.
inline rc::Gen<Case> deep_tree(Shape chain) {
  return with_tree(
      {chain},
      {.least = 1100, .most = 1300, .padding = 20, .max_leaf = 1, .size = 0.5, .all_of_ray = true});
}

}  // namespace grader::check::hit_bvh_inputs
