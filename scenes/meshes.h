#pragma once

#include "pt/geometry/primitives.h"
#include "pt/math/vec3.h"

#include <array>
#include <string_view>
#include <vector>

// Meshes of any size from formulas, for the scenes, tests and benchmarks. The same call gives the
// same mesh.

namespace scenes {

// Triangles with shared corners. Y is up, and all points lie within [-1.1, 1.1] on each axis.
struct Mesh {
  std::vector<pt::Vec3> points;
  std::vector<pt::Vec3> normals;          // normals[i] is the unit normal at points[i]
  std::vector<std::array<int, 3>> faces;  // indices of points, anticlockwise seen from outside
};

// For `triangles` from 100 to 10,000,000 (else pt::Error), all functions promise at most this
// number of triangles, fewer by less than 3 sqrt(triangles), each with an area. From 1,000
// triangles on, the corner normals are on the face's own side.

// The unit sphere, with the grid of a cube around it: no poles, triangles of similar size. Closed.
Mesh make_sphere(int triangles);

// A smooth, star-shaped blob with five broad lobes and forty small bumps. Closed.
Mesh make_blob(int triangles);

// A thin tube that winds around a ring fourteen times, back into itself. The ring is upright and
// faces the z axis. Closed, with holes and overlaps from every side.
Mesh make_coil(int triangles);

// A hollow vase with a wall, a surface of revolution around the y axis. Closed.
Mesh make_vase(int triangles);

// Three cut stones on the ground, with flat facets without shared points. The stones have equal
// numbers of faces, one stone after the other. Each stone is closed if equal points are joined.
Mesh make_gems(int triangles);

// Hills: a height for every x and z of [-1, 1]. Open; outside is above.
Mesh make_terrain(int triangles);

// Exactly this number of thin triangles, .8 long and .005 wide, criss-cross in a cube: boxes around
// them overlap in every hierarchy. Open, without shared points.
Mesh make_slivers(int triangles);

// All of the above, by name.
struct Kind {
  std::string_view name;
  Mesh (*make)(int triangles);
  std::string_view purpose;  // a sentence for the top of a scene file
};
const std::vector<Kind>& kinds();

// The mesh as triangles for the renderer.
pt::Primitives to_primitives(const Mesh& mesh);

}  // namespace scenes
