#pragma once

#include "pt/scene/recorder.h"
#include "pt/tasks/diffuse_bsdf.h"
#include "view/worker/settings.h"

#include <optional>
#include <string>
#include <vector>

namespace view {

// A direction in which direct light was looked for: a draw of a light, or a ray of hemisphere sampling.
struct Draw {
  int light = -1;  // index in the scene; -1: the surface, or the sky, that a ray met
  pt::LightSample sample;
  double cosine = 0;
  pt::Ray ray;  // that looked for what is in between
  bool was_traced = false;
  bool is_hidden = false;  // as the tracer answered
  int hit =
      -1;  // the primitive that is in between, as check_calls finds it; or that a ray of hemisphere sampling met
};

// One call of direct_lights or direct_hemisphere.
struct Direct {
  std::string_view task;
  int samples = 0;
  pt::Rgb light;
  // Directions come from the lights alone, or from the hemisphere alone. With numbers of its own direct_lights chooses between them, as
  // resampling and roulette do, and one call does not tell whether the choice is weighed.
  bool plain = true;
  std::vector<Draw> draws{};
};

// A point of a path, and how the path went on from there.
struct Bounce {
  pt::SurfacePoint point;
  int primitive = -1;
  pt::Ray met_by;                    // the ray that met the surface here, and
  pt::Hit met;                       // where
  std::vector<Direct> direct;        // one, if the task works by paths
  std::vector<double> drawn;         // random numbers before the direction, or before the end
  std::vector<pt::BsdfSample> next;  // as above
  pt::Vec3 wo;                       // that diffuse_sample got, in its frame
  std::optional<pt::Ray> ray;        // along which the path goes on
  pt::Rgb throughput = pt::gray(1);  // up to this point
  double survival = 1;               // by which the throughput was divided here
  pt::Rgb part;                      // of the sum: what the direct light here adds to it
};

// A number that breaks a promise.
struct Finding {
  int bounce = 0;    // 1: the first point; 0: before it
  std::string cell;  // the column of the table
  std::string task, promise;
  std::string text;
};

// One sample of a pixel.
struct Path {
  pt::Vec2 at;  // where it goes through the picture, as camera_ray counts
  pt::Ray ray;
  std::vector<pt::Call> calls;
  std::vector<Bounce> bounces;
  pt::Rgb emission;         // that the camera sees
  pt::Rgb traced;           // the result of trace_path
  pt::Rgb rest;             // of it without direct light
  pt::Rgb value;            // of the sample: emission and what was traced
  bool is_one = true;       // trace_path walked one path, so that the numbers tell what it did
  bool lost_point = false;  // direct light was taken at a point that the path did not reach
  std::vector<Finding> findings{};
};

// All samples of a pixel.
struct PixelPaths {
  pt::Rgb mean;     // as estimate_pixel or adaptive_pixel returned it
  int samples = 0;  // that adaptive_pixel says it took; else those asked for
  std::vector<pt::Call> calls;
  std::vector<pt::Rgb> values{};    // of every sample
  std::vector<Path> paths;          // of at most kMostPaths of them, from settings.first on
  std::vector<Finding> findings{};  // that belong to no path
};

inline constexpr int kMostPaths = 64;

// Traces the samples of a pixel again, with the random numbers of ./run render, and keeps all calls. With adaptive sampling
// adaptive_pixel takes the samples.
PixelPaths paths_of_pixel(const pt::View& view, const Settings& settings);

// One call of direct_lights or direct_hemisphere, which is calls[at], with the calls that it made.
Direct direct_of(const pt::Scene& scene, const std::vector<pt::Call>& calls, std::size_t at);

// The parts of a path, one after the other in double, as trace_path adds them up.
pt::Rgb sum_of_parts(const Path& path);

// Returns whether the parts, added one by one, are what trace_path returned, bit for bit: in double or in float, from either end.
// A task that multiplies the sum of all later points, as a recursion does, rounds otherwise.
bool adds_up(const Path& path);

// The product of f cos / pdf of a direction.
pt::Rgb factor(const pt::BsdfSample& sample);

}  // namespace view
