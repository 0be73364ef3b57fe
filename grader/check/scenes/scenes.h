#pragma once

#include "pt/geometry/surface_point.h"
#include "pt/math/frame.h"
#include "pt/scene/light.h"
#include "pt/scene/scene.h"

#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include <rapidcheck.h>

// Small scenes for the tasks that estimate light, together with the right answer.

namespace grader::check {

// Makes a scene complete, so that rays can be traced. Only this function chooses the engine. It is
// the fast one, which calls no task, so it is only for tasks of parts 3 to 5. A worker with all of
// a learner's tasks traces the scene with those tasks instead.
pt::Scene ready(pt::Scene scene);

// A rotation, a shift and a scale. They take local coordinates, in which a scene is described, to
// world coordinates.
struct Pose {
  pt::Frame turn;
  pt::Vec3 shift;
  double size = 1;

  pt::Vec3 direction(pt::Vec3 local) const { return turn.to_world(local); }
  pt::Vec3 point(pt::Vec3 local) const { return shift + size * direction(local); }
};

// A pose with any rotation, of which half take axes to axes, a size from 1 / range to range, and a position of up to `far` times the
// size.
rc::Gen<Pose> pose(double range = 1e2, double far = 1e2);

// The same without a rotation: local and world directions are equal.
rc::Gen<Pose> unturned_pose();

// The points center + (a - 1/2) u + (b - 1/2) v, with a and b in [0, 1]. The normal is along
// cross(u, v).
struct Rectangle {
  pt::Vec3 center, u, v;

  pt::Vec3 n() const { return normalize(cross(u, v)); }
  pt::Vec3 at(double a, double b) const { return center + (a - 0.5) * u + (b - 0.5) * v; }
  std::vector<pt::Vec3> corners() const { return {at(0, 0), at(1, 0), at(1, 1), at(0, 1)}; }

  // The part with a in [a0, a1] and b in [b0, b1].
  Rectangle part(double a0, double a1, double b0, double b1) const;

  // The rectangle that covers exactly the same directions, seen from the origin. It is nearer if
  // the factor is below 1, and farther away if it is above 1.
  Rectangle scaled(double factor) const { return {factor * center, factor * u, factor * v}; }

  Rectangle flipped() const { return {center, v, u}; }
};

void showValue(const Rectangle& rectangle, std::ostream& out);

// A rectangle that faces the origin from a distance of about 1. The direction to it is at most
// `tilt` from straight up, and the rectangle is turned away from the origin by up to 0.8. Its sides
// are `narrow` to `wide` long.
rc::Gen<Rectangle> rectangle_above(double tilt, double narrow, double wide);

// The walls of a closed cube above the origin, which is the middle of its floor; all face inwards.
std::vector<Rectangle> cube();

// The same cube, with the origin in its middle.
std::vector<Rectangle> cube_around();

// A unit direction, at most `tilt` from +z. A third of them are exactly +z or have an x or a y of
// exactly 0.
rc::Gen<pt::Vec3> direction_above(double tilt = 1.5);

// A unit direction whose z, the height above the horizon, is drawn from `height`.
rc::Gen<pt::Vec3> direction_above_at(const rc::Gen<double>& height);

// A point of a scene, and the radiance that leaves it along wo after exactly one bounce.
struct Situation {
  pt::Scene scene;
  pt::SurfacePoint point;
  pt::Rgb expected;
  std::string text;   // the scene in words, one line per object, in local coordinates
  pt::Rgb facing;     // the irradiance that its lights would give from straight above
  pt::Rgb brightest;  // the largest radiance that a ray from the point may meet
};
void showValue(const Situation& situation, std::ostream& out);

// An area light may also be a surface that rays meet.
enum class Body { none, surface };

// The faces of a mesh light divide its rectangle into strips of two triangles each. Strip i of n begins
// at the part (i / n)^power of the first side.
struct Strips {
  int count = 1;
  double power = 1;
};

// A shaded patch, and the lights and surfaces around it. All arguments are in local coordinates:
// the shaded point is the origin, and its normal, on the side of the viewer, is along +z. The pose
// takes them to the world. The irradiance is added up by closed forms and includes only the shades
// of `hidden`. So the caller has to place other surfaces where they hide no light, or has to set
// the right answer itself.
class SceneMaker {
 public:
  explicit SceneMaker(const Pose& pose);

  // The patch itself: a square surface of side 1/8 around the origin, seen along -wo (local, wo.z
  // >= 0). With `from_behind`, its geometric normal points to -z.
  SceneMaker& patch(pt::Rgb albedo, pt::Vec3 wo, bool from_behind = false, pt::Rgb emission = {});

  // The same point, seen along -wo, without a surface of its own that could hide it.
  SceneMaker& point(pt::Rgb albedo, pt::Vec3 wo);

  // Lights, with their irradiance. A dark surface hides the part of the rectangle with a in [0,
  // hidden]. It is at the fraction `way` of the way to the light. A mesh and a
  // point light are hidden in the same way.
  SceneMaker& rectangle(const Rectangle& shape, pt::Rgb radiance, Body body, double hidden = 0,
                        double way = 0.5);
  SceneMaker& mesh(const Rectangle& shape, pt::Rgb radiance, Body body, double hidden = 0,
                   double way = 0.5, Strips strips = {});
  SceneMaker& ball(pt::Vec3 center, double radius, pt::Rgb radiance, Body body);
  SceneMaker& point_light(pt::Vec3 position, pt::Rgb intensity, bool hidden = false,
                          double way = 0.5);
  SceneMaker& directional_light(pt::Vec3 towards, pt::Rgb irradiance, bool hidden = false);
  SceneMaker& sky(pt::Rgb radiance);

  // A surface that is not in the list of lights and does not change the irradiance. A smooth one has
  // this shading normal everywhere; otherwise it is flat.
  SceneMaker& surface(const Rectangle& shape, pt::Rgb albedo, pt::Rgb emission = {},
                      std::optional<pt::Vec3> smooth = {});

  // A ball without emission. Around the point, it hides everything outside of it.
  SceneMaker& dark_ball(pt::Vec3 center, double radius);

  Situation done() const;

 private:
  void shade(pt::Vec3 position);
  int material(pt::Rgb albedo, pt::Rgb emission);
  void arrives(pt::Rgb radiance, double cosine, double facing);
  void shines(const Rectangle& shape, pt::Rgb radiance, Body body, double hidden, double way);
  void is_met(pt::Rgb emission);
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

// The largest coordinate of the scene's surfaces. Rounding errors of a point are relative to it.
double coordinate_size(const pt::Primitives& primitives);

}  // namespace grader::check
