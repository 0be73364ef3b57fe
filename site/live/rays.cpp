#include "pt/tasks/camera_ray.h"
#include "pt/tasks/hit_box.h"
#include "pt/tasks/hit_sphere.h"
#include "pt/tasks/hit_triangle.h"
#include "site/live/exchange.h"

namespace site::live {

namespace {

// 1, t, n for a hit; 0 for none.
int answer_of(const std::optional<pt::SurfaceHit>& hit) {
  begin();
  add(hit ? 1 : 0);
  if (hit) {
    add(hit->t);
    add(hit->n);
  }
  return count();
}

}  // namespace

extern "C" {

double* numbers_in(int size) {
  given.resize(static_cast<std::size_t>(size));
  return given.data();
}

const double* numbers_out() { return answer.data(); }

// Field of view (horizontal, vertical), x and y -> origin, direction. The camera stands at the origin and looks along -z.
int live_camera_ray() {
  Given in;
  pt::Camera camera;
  camera.camera_to_world = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  camera.hfov_deg = in.number();
  camera.vfov_deg = in.number();
  const double x = in.number(), y = in.number();
  const pt::Ray ray = pt::camera_ray(camera, x, y);
  begin();
  add(ray.origin);
  add(ray.direction);
  return count();
}

// Three corners and a ray. The corner normals are the axes, so that the normal of a hit is as the three weights are.
int live_hit_triangle() {
  Given in;
  const pt::Vec3 p0 = in.vector(), p1 = in.vector(), p2 = in.vector();
  const pt::Triangle triangle{p0, p1, p2, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  return answer_of(pt::hit_triangle(triangle, in.ray()));
}

// Centre, radius and a ray.
int live_hit_sphere() {
  Given in;
  pt::Sphere sphere;
  sphere.center = in.vector();
  sphere.radius = in.number();
  return answer_of(pt::hit_sphere(sphere, in.ray()));
}

// Two corners and a ray -> 1 and the interval, or 0.
int live_hit_box() {
  Given in;
  const pt::Vec3 min = in.vector(), max = in.vector();
  const std::optional<pt::Interval> hit = pt::hit_box({min, max}, in.ray());
  begin();
  add(hit ? 1 : 0);
  if (hit) {
    add(hit->min);
    add(hit->max);
  }
  return count();
}
}

}  // namespace site::live
