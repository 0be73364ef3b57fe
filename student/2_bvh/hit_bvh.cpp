#include "pt/tasks/hit_bvh.h"

#include "pt/todo.h"

namespace pt {

namespace {

// Helper functions of your own go here: nothing outside this file sees them.

}  // namespace

// TODO: find the nearest hit, and whether there is any, by walking through the tree.
std::optional<Hit> hit_bvh(const Bvh& bvh, const Primitives& primitives, const Ray& ray) {
  todo("hit_bvh");
  return std::nullopt;
}

bool occluded_bvh(const Bvh& bvh, const Primitives& primitives, const Ray& ray) {
  todo("hit_bvh");
  return false;
}

}  // namespace pt
