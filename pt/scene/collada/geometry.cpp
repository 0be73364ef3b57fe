#include "pt/scene/collada/geometry.h"

#include "pt/scene/collada/faces.h"
#include "pt/scene/collada/numbers.h"
#include "pt/scene/collada/triangulate.h"

#include <utility>

#include <tinyxml2.h>

namespace pt {

namespace {

double read_sphere(const Document& document, const XMLElement& sphere) {
  const XMLElement& element = document.child(sphere, "radius");
  const double radius = read_number(document, element);
  if (!(radius > 0)) {
    document.fail(element, "a sphere's radius must be above 0; write such a number");
  }
  return radius;
}

void note_count(const Document& document, const XMLElement& set, const std::string& name,
                std::size_t count, const char* what) {
  if (count == 0) return;
  document.note("geometry " + name + " has " + std::to_string(count) + " faces " + what +
                " (the set in " + line(set) + ").");
}

void read_set(const Document& document, const XMLElement& set, const std::string& name,
              Geometry& geometry) {
  const int stride = read_stride(document, set);
  const Faces faces = read_faces(document, set, stride);
  if (faces.corners.empty()) {
    document.note("geometry " + name + " has a set of no faces, which is left out.");
    return;
  }
  MeshPart part{std::string(attribute(&set, "material")),
                read_inputs(document, set, geometry.sources)};
  std::size_t triangles = 0;
  for (const int corners : faces.corners) triangles += corners < 3 ? 0 : corners - 2;
  part.corners.reserve(3 * triangles);

  std::size_t without_surface = 0, crossing = 0;
  std::vector<Corner> face;
  std::vector<Vec3> points;
  const int* indices = faces.indices.data();
  for (const int corners : faces.corners) {
    face.clear();
    points.clear();
    for (int i = 0; i < corners; ++i, indices += stride) {
      if (corners < 3) continue;
      face.push_back(part.inputs.corner(document, set, indices));
      points.push_back((*part.inputs.positions)[face.back().position]);
    }
    const Triangulation cut = triangulate(points);
    for (const int corner : cut.corners) part.corners.push_back(face[corner]);
    without_surface += corners < 3 ? 1 : 0;
    crossing += cut.crosses ? 1 : 0;
  }
  note_count(document, set, name, without_surface,
             "of fewer than three corners, which are left out");
  note_count(document, set, name, crossing,
             "that cross themselves, or are far from flat: each is shown as a fan around its first "
             "corner");
  if (part.size() > 0) geometry.parts.push_back(std::move(part));
}

}  // namespace

FileTriangle MeshPart::triangle(std::size_t i) const {
  FileTriangle triangle;
  for (int k = 0; k < 3; ++k) {
    const Corner corner = corners[3 * i + static_cast<std::size_t>(k)];
    triangle.p[k] = (*inputs.positions)[corner.position];
    if (inputs.normals) triangle.n[k] = (*inputs.normals)[corner.normal];
  }
  return triangle;
}

Geometry read_geometry(const Document& document, const XMLElement& geometry) {
  Geometry result;
  if (const XMLElement* sphere = course_child(geometry, "sphere")) {
    result.sphere_radius = read_sphere(document, *sphere);
    return result;
  }
  const std::string name = label(geometry);
  const XMLElement* mesh = geometry.FirstChildElement("mesh");
  if (mesh == nullptr) mesh = geometry.FirstChildElement("convex_mesh");
  if (mesh == nullptr) {
    document.note("geometry " + name +
                  " is neither a mesh nor a sphere and is left out; convert it to a mesh.");
    return result;
  }
  bool has_some = false;
  for (const XMLElement* set : children(*mesh)) {
    const std::string kind = set->Name();
    if (is_set_of_faces(*set)) {
      read_set(document, *set, name, result);
    } else if (kind == "lines" || kind == "linestrips") {
      document.note("geometry " + name + " has " + kind +
                    ", which have no surface and are ignored.");
    } else {
      continue;
    }
    has_some = true;
  }
  if (!has_some) document.note("geometry " + name + " has no faces and is left out.");
  return result;
}

}  // namespace pt
