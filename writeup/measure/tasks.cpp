#include "writeup/measure/tasks.h"

namespace writeup::measure {

namespace {

std::vector<About> of_rays() {
  return {
      {.slug = "estimate_pixel",
       .kind = Kind::estimator,
       .cases = {"an edge", "an edge and noise"},
       .errors = {},
       .inputs = "16 samples of pixels that an edge divides; the radiance on both sides is "
                 "constant, or noise with that mean."},
      {.slug = "camera_ray",
       .kind = Kind::exact,
       .cases = {""},
       .errors = {"error, direction", "error, origin"},
       .inputs = "4096 points of pictures of 1 to 170 degrees, from any place in any direction."},
      {.slug = "hit_triangle",
       .kind = Kind::exact,
       .cases = {""},
       .errors = {"error of t", "error of n"},
       .inputs = "4096 triangles of 1e-6 to 1e6, up to a thousand times as long as high, up to a "
                 "thousand sizes away, seen at angles down to 1e-3; half are hit. The error of t "
                 "is a part of the largest length there is."},
      {.slug = "hit_sphere",
       .kind = Kind::exact,
       .cases = {""},
       .errors = {"error of t", "error of n", "at 1e7 radii"},
       .inputs = "4096 spheres up to a thousand radii away, or around the origin; a third is "
                 "missed. The error of t is a part of the radius; far away that of the point."}};
}

std::vector<About> of_trees() {
  return {{.slug = "build_bvh",
           .kind = Kind::tree,
           .cases = {"leaf 1", "leaf 2", "leaf 4", "leaf 8", "leaf 16"},
           .one_front = true,
           .errors = {},
           .inputs = "A blob of 1500 triangles, a coil of 800 and a floor of two; 512 rays, half "
                     "from a camera, half from anywhere, through the reference's hit_bvh."},
          {.slug = "hit_box",
           .kind = Kind::exact,
           .cases = {""},
           .errors = {"error of ends"},
           .inputs = "4096 boxes of 1e-3 to 1e3, some flat, and rays of any length, some along an "
                     "axis, some from inside; half hit. The error is that of the plane, as a part "
                     "of the largest coordinate."},
          {.slug = "hit_bvh",
           .kind = Kind::tree,
           .cases = {"nearest hit", "any hit"},
           .errors = {},
           .inputs = "The scene and the rays of build_bvh, the reference's tree with leaves of 4; "
                     "for any hit, rays that end at a random point."}};
}

std::vector<About> of_direct_light() {
  return {
      {.slug = "diffuse_bsdf",
       .kind = Kind::estimator,
       .cases = {"diffuse_sample"},
       .errors = {"error of f, pdf"},
       .inputs = "64 surfaces under a sky that varies smoothly; the estimate is that of the light "
                 "reflected."},
      {.slug = "direct_hemisphere",
       .kind = Kind::estimator,
       .cases = {"1 sample", "16 samples"},
       .errors = {},
       .inputs =
           "64 points of a floor below a rectangle of light and a small one, with a mesh beside."},
      {.slug = "direct_lights",
       .kind = Kind::estimator,
       .cases = {"1 sample", "16 samples"},
       .errors = {},
       .inputs =
           "64 points of a floor below a rectangle of light and a small one, with a mesh beside."}};
}

std::vector<About> of_paths_and_pixels() {
  return {
      {.slug = "trace_path",
       .kind = Kind::estimator,
       .cases = {"5 bounces"},
       .errors = {},
       .inputs = "64 points inside a colored ball with a point light off its centre, survival .7."},
      {.slug = "adaptive_pixel",
       .kind = Kind::estimator,
       .cases = {"an edge", "an edge and noise"},
       .chooses_samples = true,
       .errors = {},
       .inputs = "The pixels of estimate_pixel, batches of 16, tolerance .05."}};
}

}  // namespace

const std::vector<About>& tasks() {
  static const std::vector<About> all = [] {
    std::vector<About> joined;
    for (const auto part : {of_rays, of_trees, of_direct_light, of_paths_and_pixels}) {
      const std::vector<About> tasks_of_part = part();
      joined.insert(joined.end(), tasks_of_part.begin(), tasks_of_part.end());
    }
    return joined;
  }();
  return all;
}

}  // namespace writeup::measure
