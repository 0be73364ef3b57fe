#pragma once

#include "grader/check/scenes.h"
#include "pt/scene/view.h"

#include <array>

// Scenes for light that bounces more than once. Each is a handful of places between which light
// goes with known chances, so that the radiance after exactly k bounces is a closed form, and so is
// the noise of a path tracer.

namespace grader::check {

// All points of a scene that look alike to a path.
struct Place {
  pt::Rgb albedo;
  pt::Rgb direct;                 // the mean of the direct light that leaves a point of it
  pt::Rgb variance;               // of that from point to point
  pt::Rgb variance_of_a_sample;   // and of one estimate of it with one sample, at one point
  std::array<double, 3> leads{};  // the chance that a bounce in proportion to the cosine leads to
                                  // each place; the rest leaves the scene
};

struct Room {
  pt::Scene scene;
  pt::SurfacePoint point;
  pt::PathSettings::Direct direct{};  // the way in which direct light is looked for
  std::vector<Place> places;          // the first one is the point's own
  std::string text;

  // The radiance that leaves the point after from .. to bounces.
  pt::Rgb sum(int from, int to) const;

  // How much of it may be lost where every color, f, pdf and cosine on the way is only as precise
  // as the contracts ask for (kColorPrecision): in the brightest channel.
  double precision(int from, int to) const;
};
void showValue(const Room& room, std::ostream& out);

// How noisy the parts of a path tracer are.
struct PathNoise {
  double survival = 0.7;  // before all bounces of the path but the first
  // The mean square of the throughput of a bounce, over the squared mean: 1 for directions chosen
  // by the cosine, 4 / 3 for uniform ones, 2 at most as diffuse_bsdf.h has it.
  double mean_square = 1;
  // The deviation of an estimate of direct light with one sample is at most so many times that of
  // the usual method, or of the mean where that is more: 2 as direct_lights.h has it. 0: the usual.
  double most_of_direct = 0;
};

// The standard deviation of one estimate of sum(from, to).
pt::Rgb deviation(const Room& room, const pt::PathSettings& settings, const PathNoise& noise);

// What the light and the scale of a room are drawn from.
struct Ranges {
  double size = 1e2;  // from 1 / size to size
  rc::Gen<pt::Rgb> light;
  int max_lights = 1;
};
Ranges ordinary();
Ranges extreme();  // sizes 1e-6 to 1e6, radiances 1e-4 to 1e6, up to 40 lights

// Inside one ball, with point lights off its middle. From any patch of a sphere every other one of
// the same area looks as large, so what bounces once is spread evenly over all of it, and each
// further bounce leaves the albedo of it.
rc::Gen<Room> round_room(const rc::Gen<pt::Rgb>& albedo, const Ranges& ranges = ordinary());

// Inside a ball whose middle is a smaller, glowing ball, both as a surface and in the list of
// lights. The point is on either.
rc::Gen<Room> room_around_a_lamp(const rc::Gen<pt::Rgb>& albedo,
                                 const rc::Gen<pt::PathSettings::Direct>& direct,
                                 const Ranges& ranges = ordinary());

// A furnace: all walls of a cube glow and reflect alike. No light is in the list.
rc::Gen<Room> glowing_room(const rc::Gen<pt::Rgb>& albedo);

// A wall in the sun, seen by a point that is on no surface of the scene, and mostly in the light of
// another sun itself. A path bounces to the wall or leaves the scene. The wall is at most `tilt`
// from straight above the point.
rc::Gen<Room> sunny_wall(const rc::Gen<pt::Rgb>& albedo, double tilt = 0.9);

// The same under the sky alone, which the point itself sees too: only bounces from 2 on are known.
rc::Gen<Room> wall_under_the_sky(const rc::Gen<pt::Rgb>& albedo,
                                 const rc::Gen<pt::PathSettings::Direct>& direct);

}  // namespace grader::check
