#include "pt/tasks/hit_triangle.h"

#include "pt/todo.h"

namespace pt {

namespace {

// Helper functions of your own go here: nothing outside this file sees them.

}  // namespace

// TODO: find the t at which the ray meets the triangle, and the weighted corner normals there.
std::optional<SurfaceHit> hit_triangle(const Triangle& triangle, const Ray& ray) {
  todo("hit_triangle");
  return std::nullopt;
}

}  // namespace pt
