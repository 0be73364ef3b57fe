#include "pt/tasks/hit_box.h"

#include "pt/todo.h"

namespace pt {

namespace {

// Helper functions of your own go here: nothing outside this file sees them.

}  // namespace

// TODO: find the part of the ray's range in which it is inside the box.
std::optional<Interval> hit_box(const Box& box, const Ray& ray) {
  todo("hit_box");
  return std::nullopt;
}

}  // namespace pt
