#include "pt/tasks/camera_ray.h"

#include "pt/todo.h"

namespace pt {

namespace {

// Helper functions of your own go here: nothing outside this file sees them.

}  // namespace

// TODO: make the ray from the camera through the point (x, y) of its window.
Ray camera_ray(const Camera& camera, double x, double y) {
  todo("camera_ray");
  return {{}, {0, 0, -1}};
}

}  // namespace pt
