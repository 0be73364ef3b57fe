#pragma once

#include "pt/examples/scenes.h"
#include "pt/math/frame.h"
#include "pt/sampling/sampler.h"

// Random inputs for examples.

namespace pt::inputs {

inline double any_number(Sampler& sampler, double least, double most) {
  return least + (most - least) * sampler.next_1d();
}

// All components are between -1 and 1.
inline Vec3 any_vector(Sampler& sampler) {
  const double x = any_number(sampler, -1, 1), y = any_number(sampler, -1, 1);
  return {x, y, any_number(sampler, -1, 1)};
}

// A unit vector.
inline Vec3 any_direction(Sampler& sampler) {
  while (true) {
    const Vec3 v = any_vector(sampler);
    if (length(v) > 0.1 && length(v) < 1) return normalize(v);
  }
}

inline Rgb any_color(Sampler& sampler) {
  const double r = sampler.next_1d(), g = sampler.next_1d();
  return {r, g, sampler.next_1d()};
}

// A point p of a floor with the unit normal n, and a rectangle above that floor. cross(u, v) points to the side from which p sees it.
struct Place {
  Vec3 p, n;
  Vec3 center, u, v;
};

inline Place any_place_on_floor(Sampler& sampler, Vec3 n) {
  Place place;
  place.p = 3 * any_vector(sampler);
  place.n = n;
  const Frame frame = frame_from_normal(place.n);
  while (true) {
    const double x = any_number(sampler, -1, 1), y = any_number(sampler, -1, 1);
    place.center = place.p + frame.to_world({x, y, any_number(sampler, 0.5, 1.5)});
    const Vec3 normal = normalize(place.p - place.center + 0.7 * any_vector(sampler));
    const Vec3 side = normalize(cross(normal, any_direction(sampler)));
    place.u = any_number(sampler, 0.3, 1.5) * side;
    place.v = any_number(sampler, 0.3, 1.5) * cross(normal, side);
    const double half = (std::abs(dot(place.u, place.n)) + std::abs(dot(place.v, place.n))) / 2;
    const bool is_above = dot(place.center - place.p, place.n) - half > 0.1;
    if (is_above && dot(place.p - place.center, normal) > 0.1) return place;
  }
}

// The same with a floor in any orientation.
inline Place any_place(Sampler& sampler) {
  return any_place_on_floor(sampler, any_direction(sampler));
}

// The scene and a floor of that place, 20 by 20, in which p is not on the edge between the two triangles. It may be seen from its front
// or from its back.
inline Scene with_floor(Scene scene, const Place& place, bool from_behind,
                        const Material& material) {
  const Frame frame = frame_from_normal(place.n);
  const Vec3 u = 20 * frame.x, v = 20 * frame.y, center = place.p + frame.to_world({1.3, 0.6, 0});
  return scenes::with_rectangle(std::move(scene), center, from_behind ? v : u, from_behind ? u : v,
                                material);
}

// The point p, seen from close above.
inline SurfacePoint point_of(const Scene& scene, const Place& place) {
  const Frame frame = frame_from_normal(place.n);
  return scenes::seen(scene, place.p + frame.to_world({0.02, 0.01, 0.04}), place.p);
}

// The variance of the numbers that so many calls return.
template <class Call>
double variance_of(int calls, const Call& call) {
  Sampler sampler(1);
  double sum = 0, squares = 0;
  for (int i = 0; i < calls; ++i) {
    const double value = call(sampler);
    sum += value;
    squares += value * value;
  }
  return squares / calls - sum * sum / calls / calls;
}

// True if the same random numbers give the same answer, whatever was called in between.
template <class Call>
bool repeats(const Call& call) {
  Sampler sampler(1), again(1), other(2);
  const auto first = call(sampler);
  call(other);
  return call(again) == first;
}

}  // namespace pt::inputs
