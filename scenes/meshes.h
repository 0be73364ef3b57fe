#pragma once

#include "pt/geometry/primitives.h"
#include "pt/math/vec3.h"

#include <array>
#include <string_view>
#include <vector>

// Meshes of any size from a formula: for the scenes, for tests and for benchmarks. The same call
// gives the same mesh.

namespace scenes {

// Triangles with shared corners. Y is up, and all points lie within [-1.1, 1.1] on each axis.
struct Mesh {
  std::vector<pt::Vec3> points;
  std::vector<pt::Vec3> normals;          // normals[i] is the unit normal at points[i]
  std::vector<std::array<int, 3>> faces;  // indices of points, anticlockwise seen from outside
};

// All of them promise, for `triangles` from 100 to 10,000,000 (else pt::Error): at most that
// many triangles, short of it by less than 3 sqrt(triangles), each with an area. From 1,000
// triangles on, the corner normals lie on the face's own side.

// The unit sphere, cut by the grid on a cube around it: no poles, triangles alike in size. Closed.
Mesh make_sphere(int triangles);

// A smooth, star-shaped blob with five broad lobes and forty small bumps. Closed.
Mesh make_blob(int triangles);

// A thin tube wound around a ring fourteen times, back into itself. The ring stands upright and
// faces the z axis. Closed; holes and overlaps seen from everywhere.
Mesh make_coil(int triangles);

// A hollow vase with a wall, a surface of revolution around the y axis. Closed.
Mesh make_vase(int triangles);

// Three cut stones lying on the ground, flat facets without shared points. The stones have equally
// many faces and follow each other in the list; each is closed once equal points are joined.
Mesh make_gems(int triangles);

// Hills: a height for every x and z of [-1, 1]. Open; outside is above.
Mesh make_terrain(int triangles);

// Exactly that many thin triangles, .8 long and .005 wide, criss-cross in a cube: boxes around them
// overlap whatever the hierarchy. Open, without shared points.
Mesh make_slivers(int triangles);

// All of the above, by name.
struct Kind {
  std::string_view name;
  Mesh (*make)(int triangles);
  std::string_view purpose;  // a sentence for the top of a scene file
};
const std::vector<Kind>& kinds();

// The mesh as the renderer has it.
pt::Primitives to_primitives(const Mesh& mesh);

}  // namespace scenes
