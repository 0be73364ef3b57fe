#pragma once

#include "pt/scene/scene.h"
#include "pt/scene/view.h"

#include <vector>

// Scenes for examples, so small that their light can be calculated by hand. y is up, and everything that shines has radiance 1.

namespace pt::scenes {

inline constexpr Rgb kWhite{1, 1, 1};
inline constexpr Rgb kBrown{0.8, 0.4, 0.2};  // the albedo of the floor

// The scene and a rectangle more: its middle, its two whole sides, and its material. It emits to the side of cross(u, v).
Scene with_rectangle(Scene scene, Vec3 center, Vec3 u, Vec3 v, const Material& material);

// The scene and a dark rectangle, which hides what is behind it.
Scene with_screen(Scene scene, Vec3 center, Vec3 u, Vec3 v);

// The scene and a rectangle of radiance 1, which is a light too. It shines to the side of cross(u, v).
Scene with_lamp(Scene scene, Vec3 center, Vec3 u, Vec3 v, Rgb albedo = {});

// A brown floor, 20 by 20, with its middle in the origin, and these lights, which have no surface.
Scene floor_under(const std::vector<Light>& lights);

Scene floor_under_sky();

// A lamp, 2 by 2, at height 1 over the middle of the floor. The middle gets 0.554126 of the light that it would get from a white sky.
Scene floor_under_lamp();

// A ball that shines, of radius 1, with its centre 2 above the middle of the floor. The middle gets (1 / 2)^2 of the light that it
// would get from a white sky.
Scene floor_under_ball();

// A closed room from -1 to 1 along each axis. All its walls shine inwards, and have this albedo. A bounce multiplies the light by it.
Scene furnace(Rgb albedo);

// The inside of a ball of radius 1 with this albedo. A point light in its centre gives each point the irradiance pi, so the direct light
// is the albedo everywhere.
Scene ball_with_point_light(Rgb albedo);

// The point of the scene that one sees from `eye` towards `target`.
SurfacePoint seen(const Scene& scene, Vec3 eye, Vec3 target);

// The middle of the floor, seen from close above. In examples of trace_path, diffuse_sample draws uniform directions where a surface is
// seen from straight above, and cosine-weighted ones elsewhere: both are right.
SurfacePoint middle_of_floor(const Scene& scene);

// The light that a surface at p with the normal n gets from a rectangle of radiance 1, as a part of the light that it would get from a
// white sky: Lambert's formula. The whole rectangle lies above the surface, and p sees its bright side.
double share_of_sky(Vec3 p, Vec3 n, Vec3 center, Vec3 u, Vec3 v);

// A rectangle that shines, before black: what view_of sees is 1 where left <= x <= right and bottom <= y <= top, and 0 elsewhere. The
// whole picture is from -1 to 1 along both axes.
Scene bright(double left, double right, double bottom, double top, Rgb radiance = kWhite);

// A picture of 4 by 2 pixels. Pixel (x, y) covers -1 + x / 2 to -1 / 2 + x / 2 of the width, and -1 + y to y of the height. Only emission
// is seen.
View view_of(const Scene& scene);

}  // namespace pt::scenes
