#include "pt/tasks/hit_sphere.h"

#include "pt/todo.h"

namespace pt {

namespace {

// Helper functions of your own go here: nothing outside this file sees them.

}  // namespace

// TODO: find the smallest t in the ray's range that is on the sphere, and the normal there.
std::optional<SurfaceHit> hit_sphere(const Sphere& sphere, const Ray& ray) {
  todo("hit_sphere");
  return std::nullopt;
}

}  // namespace pt
