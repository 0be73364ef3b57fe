#pragma once

#include "pt/geometry/surface_point.h"
#include "pt/math/frame.h"
#include "pt/scene/light.h"
#include "pt/scene/scene.h"

#include <ostream>
#include <string>
#include <vector>

#include <rapidcheck.h>

// Small scenes for the tasks that estimate light, together with what the right answer is.

namespace grader::check {

// A complete scene, made so that it answers rays. The one place where the engine is chosen: the
// fast one, which calls no task, so only for tasks of parts 3 to 5. A worker with all of a
// learner's tasks traces the scene by them instead.
pt::Scene ready(pt::Scene scene);

// Turned, moved and scaled: from the coordinates a scene is thought out in to the world's.
struct Pose {
  pt::Frame turn;
  pt::Vec3 shift;
  double size = 1;

  pt::Vec3 direction(pt::Vec3 local) const { return turn.to_world(local); }
  pt::Vec3 point(pt::Vec3 local) const { return shift + size * direction(local); }
};

// Any rotation, sizes from 1 / range to range, positions of up to `far` times the size.
rc::Gen<Pose> pose(double range = 1e2, double far = 1e2);

// The same, but not turned: local and world directions are the same.
rc::Gen<Pose> unturned_pose();

// center + (a - 1/2) u + (b - 1/2) v, a and b in [0, 1]. Its normal is along cross(u, v).
struct Rectangle {
  pt::Vec3 center, u, v;

  pt::Vec3 n() const { return normalize(cross(u, v)); }
  pt::Vec3 at(double a, double b) const { return center + (a - 0.5) * u + (b - 0.5) * v; }
  std::vector<pt::Vec3> corners() const { return {at(0, 0), at(1, 0), at(1, 1), at(0, 1)}; }

  // The part with a in [a0, a1] and b in [b0, b1].
  Rectangle part(double a0, double a1, double b0, double b1) const;

  // What covers exactly this rectangle as seen from the origin: nearer for a factor below 1, behind
  // it for one above.
  Rectangle scaled(double factor) const { return {factor * center, factor * u, factor * v}; }

  Rectangle flipped() const { return {center, v, u}; }
};

void showValue(const Rectangle& rectangle, std::ostream& out);

// Faces the origin, about a distance of 1 away, from straight above it to `tilt` to the side, and
// turned by up to 0.8 from facing it straight. Sides from narrow to wide.
rc::Gen<Rectangle> rectangle_above(double tilt, double narrow, double wide);

// The walls of a closed cube above the origin, which is the middle of its floor; all face inwards.
std::vector<Rectangle> cube();

// A unit direction, at most `tilt` from +z.
rc::Gen<pt::Vec3> direction_above(double tilt = 1.5);

// A unit direction whose z is drawn: how far above the horizon it is.
rc::Gen<pt::Vec3> direction_above_at(const rc::Gen<double>& height);

// A point of a scene, and the radiance that leaves it along wo after exactly one bounce.
struct Situation {
  pt::Scene scene;
  pt::SurfacePoint point;
  pt::Rgb expected;
  std::string text;   // the scene in words, a line a thing, in coordinates of its own
  pt::Rgb facing;     // what its lights would add to the irradiance if they were straight above
  pt::Rgb brightest;  // the largest radiance that a ray from the point may meet
};
void showValue(const Situation& situation, std::ostream& out);

// Whether an area light is also a surface that rays meet.
enum class Body { none, surface };

// A shaded patch and what it sees. Everything is given in coordinates of its own, with the shaded
// point in the origin and its normal, on the side it is looked at from, along +z; the pose takes it
// to the world. The irradiance is added up by closed forms, so nothing that the stage does not know
// of may hide a light: shades are made by `hidden`, other surfaces by who knows where they are.
class Stage {
 public:
  explicit Stage(const Pose& pose);

  // The patch itself, a surface of half that width around the origin, looked at along -wo (local,
  // wo.z >= 0). From behind: its geometric normal points to -z.
  Stage& patch(pt::Rgb albedo, pt::Vec3 wo, bool from_behind = false, pt::Rgb emission = {});

  // Lights, with the irradiance they give. Of the rectangle the part with a in [0, hidden] is
  // behind a dark surface, which stands at `way` of the way to it; so is a hidden point light.
  Stage& rectangle(const Rectangle& shape, pt::Rgb radiance, Body body, double hidden = 0,
                   double way = 0.5);
  Stage& mesh(const Rectangle& shape, pt::Rgb radiance, Body body);
  Stage& ball(pt::Vec3 center, double radius, pt::Rgb radiance, Body body);
  Stage& point_light(pt::Vec3 position, pt::Rgb intensity, bool hidden = false, double way = 0.5);
  Stage& directional_light(pt::Vec3 towards, pt::Rgb irradiance, bool hidden = false);
  Stage& sky(pt::Rgb radiance);

  // A surface that is not a light of the list, and does not touch the irradiance.
  Stage& surface(const Rectangle& shape, pt::Rgb albedo, pt::Rgb emission = {});

  Situation done() const;

 private:
  void shade(pt::Vec3 position);
  int material(pt::Rgb albedo, pt::Rgb emission);
  void arrives(pt::Rgb radiance, double cosine, double facing);
  std::string text() const;

  Pose pose_;
  pt::Scene scene_;
  pt::SurfacePoint point_;
  pt::Rgb irradiance_;
  pt::Rgb facing_;
  pt::Rgb brightest_;
  std::vector<int> ball_materials_;  // spheres come after all triangles
  std::vector<std::string> lights_, surfaces_;
};

// The largest coordinate of the scene's surfaces: what rounding errors of a point are relative to.
double coordinate_size(const pt::Primitives& primitives);

}  // namespace grader::check
