#pragma once

#include "grader/check/generators/generators.h"
#include "grader/check/scenes/scenes.h"
#include "pt/scene/view.h"

#include <array>

// Scenes for light that bounces more than once. Each scene has a few places, and light goes from
// one to another with known probabilities. So the radiance after exactly k bounces has a closed
// form, and the noise of a path tracer has one too.

namespace grader::check {

// All points of a scene that are equivalent for a path.
struct Place {
  pt::Rgb albedo;
  pt::Rgb direct;                 // the mean of the direct light that leaves its points
  pt::Rgb variance;               // of this light from point to point
  pt::Rgb variance_of_a_sample;   // of one estimate with one sample at one point
  std::array<double, 3> leads{};  // the probability that a cosine-weighted bounce leads to
                                  // each place; the rest leaves the scene
};

struct Room {
  pt::Scene scene;
  pt::SurfacePoint point;
  pt::PathSettings::Direct direct{};  // hemisphere or light sampling, for direct light
  std::vector<Place> places;          // the point is in the first one
  std::string text;

  // The radiance that leaves the point, summed over the bounces from .. to.
  pt::Rgb sum(int from, int to) const;

  // The largest error of sum(from, to) in the brightest channel, if every colour, f, pdf and cosine
  // on the path is only as precise as the contracts require (kColorPrecision).
  double precision(int from, int to) const;
};
void showValue(const Room& room, std::ostream& out);

// The noise of the parts of a path tracer.
struct PathNoise {
  double survival = pt::PathSettings{}.survival;  // before each bounce of the path except the first
  // The mean square of the throughput of a bounce, over the squared mean. It is 1 for
  // cosine-weighted directions, 4 / 3 for uniform ones, and 2 at most in the contract
  // diffuse_bsdf.h.
  double mean_square = 1;
  // The largest deviation of an estimate of direct light with one sample, as a multiple of that of
  // the usual method, or of the mean if the mean is larger. The contract direct_lights.h allows 2.
  // 0 means the deviation of the usual method.
  double most_of_direct = 0;
};

// The standard deviation of one estimate of sum(from, to).
pt::Rgb deviation(const Room& room, const pt::PathSettings& settings, const PathNoise& noise);

// The ranges of a room's size, its light and its number of lights.
struct Ranges {
  double size = 1e2;       // from 1 / size to size
  rc::Gen<pt::Rgb> light;  // in a room of size 1; an intensity grows with the squared size
  int max_lights = 1;
  bool small = false;  // always 1 / size
};
Ranges ordinary();
Ranges extreme();  // sizes 1e-6 to 1e6, radiances 1e-4 to 1e6, up to 40 lights

// The inside of one ball, with point lights away from its centre. From any point of a sphere, all
// patches of the same area get the same share of the reflected light. So light that has bounced
// once is uniform over the ball, and each further bounce multiplies it by the albedo.
rc::Gen<Room> round_room(const rc::Gen<pt::Rgb>& albedo, const Ranges& ranges = ordinary());

// The inside of a ball with a smaller, glowing ball in its centre. The glowing ball is a surface
// and also in the list of lights. The point is on one of the two. `ratio` is that of their radii.
rc::Gen<Room> room_around_a_lamp(const rc::Gen<pt::Rgb>& albedo,
                                 const rc::Gen<pt::PathSettings::Direct>& direct,
                                 const Ranges& ranges = ordinary(),
                                 const rc::Gen<double>& ratio = real(0.4, 0.7));

// A furnace: all walls of a cube have the same emission and the same albedo. The list of lights is
// empty.
rc::Gen<Room> glowing_room(const rc::Gen<pt::Rgb>& albedo);

// A furnace around a point whose normal is far from that of its own, small surface. The walls have
// another albedo than the point.
rc::Gen<Room> glowing_room_around_a_smooth_point();

// A wall in the sun, above a point that is on no surface of the scene. Usually a second sun lights
// the point itself. A path goes to the wall or leaves the scene. The direction to the wall is at
// most `tilt` from straight up.
rc::Gen<Room> sunny_wall(const rc::Gen<pt::Rgb>& albedo, double tilt = 0.9);

// The same with only the sky as a light. The point sees the sky too, so that only the bounces from
// 2 on are known. The shading normal of a smooth wall is not its true normal.
rc::Gen<Room> wall_under_the_sky(const rc::Gen<pt::Rgb>& albedo,
                                 const rc::Gen<pt::PathSettings::Direct>& direct,
                                 bool smooth = false);

// The inside of a ball with a point light in its centre. A black ball takes a part of the wall away, so
// that each direction of a path leads to light or to darkness.
rc::Gen<Room> dented_room(const rc::Gen<pt::Rgb>& albedo);

// A smooth wall above a point that is on no surface, in the middle of a huge hall. The light of the
// wall comes from one half of all directions; the other half is black. The path meets the wall from the
// front or from behind. Only the bounces from 3 on are known.
rc::Gen<Room> smooth_wall_in_a_hall();

// Where a point is seen from. The mock diffuse_sample draws by another density if that is exactly the
// normal (grader/tasks/diffuse_bsdf/mock.cpp), and only the promise about densities judges that.
pt::Vec3 any_view();

}  // namespace grader::check
