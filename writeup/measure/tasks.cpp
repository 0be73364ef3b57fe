#include "writeup/measure/tasks.h"

namespace writeup::measure {

const std::vector<About>& tasks() {
  static const std::vector<About> all{
      {"estimate_pixel",
       Kind::estimator,
       {"an edge", "an edge and noise"},
       false,
       {},
       "16 samples of pixels that an edge divides; the radiance on both sides is constant, or "
       "noise with that mean."},
      {"camera_ray",
       Kind::exact,
       {""},
       false,
       {"error, direction", "error, origin"},
       "4096 points of pictures of 1 to 170 degrees, from any place in any direction."},
      {"hit_triangle",
       Kind::exact,
       {""},
       false,
       {"error of t", "error of n"},
       "4096 triangles of 1e-6 to 1e6, up to a thousand times as long as high, up to a thousand "
       "sizes away, seen at angles down to 1e-3; half are hit. The error of t is a part of the "
       "largest length there is."},
      {"hit_sphere",
       Kind::exact,
       {""},
       false,
       {"error of t", "error of n", "at 1e7 radii"},
       "4096 spheres up to a thousand radii away, or around the origin; a third is missed. The "
       "error of t is a part of the radius; far away that of the point."},
      {"build_bvh",
       Kind::tree,
       {"leaf 1", "leaf 2", "leaf 4", "leaf 8", "leaf 16"},
       true,
       {},
       "A blob of 1500 triangles, a coil of 800 and a floor of two; 512 rays, half from a camera, "
       "half from anywhere, through the reference's hit_bvh."},
      {"hit_box",
       Kind::exact,
       {""},
       false,
       {"error of ends"},
       "4096 boxes of 1e-3 to 1e3, some flat, and rays of any length, some along an axis, some "
       "from inside; half hit. The error is that of the plane, as a part of the largest "
       "coordinate."},
      {"hit_bvh",
       Kind::tree,
       {"nearest hit", "any hit"},
       false,
       {},
       "The scene and the rays of build_bvh, the reference's tree with leaves of 4; for any hit, "
       "rays that end at a random point."},
      {"diffuse_bsdf",
       Kind::estimator,
       {"diffuse_sample"},
       false,
       {"error of f, pdf"},
       "64 surfaces under a sky that varies smoothly; the estimate is that of the light "
       "reflected."},
      {"direct_hemisphere",
       Kind::estimator,
       {"1 sample", "16 samples"},
       false,
       {},
       "64 points of a floor below a rectangle of light and a small one, with a mesh beside."},
      {"direct_lights",
       Kind::estimator,
       {"1 sample", "16 samples"},
       false,
       {},
       "64 points of a floor below a rectangle of light and a small one, with a mesh beside."},
      {"trace_path",
       Kind::estimator,
       {"5 bounces"},
       false,
       {},
       "64 points inside a colored ball with a point light off its centre, survival .7."},
      {"adaptive_pixel",
       Kind::estimator,
       {"an edge", "an edge and noise"},
       false,
       {},
       "The pixels of estimate_pixel, batches of 16, tolerance .05."},
  };
  return all;
}

}  // namespace writeup::measure
