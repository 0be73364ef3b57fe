#include "pt/scene/collada/geometry.h"

#include "pt/scene/collada/numbers.h"
#include "pt/scene/collada/sources.h"

#include <cstring>
#include <utility>

#include <tinyxml2.h>

namespace pt {

namespace {

// The lists of indices of one set of faces: corner i of the set reads its indices at
// i * inputs.stride + offset, and face j has corners[j] of them.
struct Faces {
  std::vector<int> corners;
  std::vector<int> indices;
};

void check_face_count(const ColladaDocument& document, const XMLElement& set,
                      std::size_t faces_found) {
  const std::optional<std::size_t> count = read_count(document, set, "count");
  if (count && *count != faces_found) {
    document.fail(set, std::string("<") + set.Name() + "> announces " + std::to_string(*count) +
                           " faces and holds " + std::to_string(faces_found) +
                           "; correct the count, or copy the file again if it was cut off");
  }
}

Faces read_polylist(const ColladaDocument& document, const XMLElement& set) {
  Faces faces;
  if (const XMLElement* vcount = set.FirstChildElement("vcount")) {
    faces.corners = read_integers(document, *vcount);
  }
  if (const XMLElement* p = set.FirstChildElement("p")) faces.indices = read_integers(document, *p);
  check_face_count(document, set, faces.corners.size());
  return faces;
}

Faces read_triangles(const ColladaDocument& document, const XMLElement& set, int stride) {
  Faces faces;
  if (const XMLElement* p = set.FirstChildElement("p")) faces.indices = read_integers(document, *p);
  faces.corners.assign(faces.indices.size() / (3 * static_cast<std::size_t>(stride)), 3);
  check_face_count(document, set, faces.corners.size());
  return faces;
}

Faces read_polygons(const ColladaDocument& document, const XMLElement& set, int stride) {
  if (const XMLElement* holed = set.FirstChildElement("ph")) {
    document.fail(*holed, "a face with holes (<ph>) cannot be read; triangulate the mesh");
  }
  Faces faces;
  for (const XMLElement* p = set.FirstChildElement("p"); p != nullptr;
       p = p->NextSiblingElement("p")) {
    const std::vector<int> indices = read_integers(document, *p);
    if (indices.size() % static_cast<std::size_t>(stride) != 0) {
      document.fail(*p, "<p> ends in the middle of a corner; write " + std::to_string(stride) +
                            " indices per corner");
    }
    faces.corners.push_back(static_cast<int>(indices.size()) / stride);
    faces.indices.insert(faces.indices.end(), indices.begin(), indices.end());
  }
  check_face_count(document, set, faces.corners.size());
  return faces;
}

void check_sizes(const ColladaDocument& document, const XMLElement& set, const Faces& faces,
                 int stride) {
  const auto held = static_cast<long long>(faces.indices.size());
  long long wanted = 0;
  for (const int corners : faces.corners) {
    if (corners < 0) {
      document.fail(set, "a face has " + std::to_string(corners) + " corners; write at least 3");
    }
    wanted += static_cast<long long>(corners) * stride;
    if (wanted > held) break;
  }
  if (wanted != held) {
    document.fail(set, std::string("the faces need ") + (wanted > held ? "more" : "fewer") +
                           " indices than the " + std::to_string(held) +
                           " there are; export the mesh again, or copy the file again if it was "
                           "cut off");
  }
}

MeshPart read_part(const ColladaDocument& document, const XMLElement& set, Sources& sources) {
  const FaceInputs inputs = read_inputs(document, set, sources);
  const bool is_polylist = std::strcmp(set.Name(), "polylist") == 0;
  const bool is_triangles = std::strcmp(set.Name(), "triangles") == 0;
  const Faces faces = is_polylist    ? read_polylist(document, set)
                      : is_triangles ? read_triangles(document, set, inputs.stride)
                                     : read_polygons(document, set, inputs.stride);
  check_sizes(document, set, faces, inputs.stride);

  MeshPart part;
  if (const char* symbol = set.Attribute("material")) part.material_symbol = symbol;
  part.triangles.reserve(faces.indices.size() / (3 * static_cast<std::size_t>(inputs.stride)));
  const int* corner = faces.indices.data();
  for (const int corners : faces.corners) {
    if (corners < 3) ++part.without_surface;
    for (int i = 1; i + 1 < corners; ++i) {
      FileTriangle& triangle = part.triangles.emplace_back();
      const int fan[3] = {0, i, i + 1};
      for (int k = 0; k < 3; ++k) {
        const int* indices = corner + fan[k] * inputs.stride;
        triangle.p[k] = inputs.position(document, set, indices);
        triangle.n[k] = inputs.normal(document, set, indices);
      }
    }
    corner += static_cast<std::ptrdiff_t>(corners) * inputs.stride;
  }
  return part;
}

double read_sphere(const ColladaDocument& document, const XMLElement& sphere) {
  const XMLElement& element = document.child(sphere, "radius");
  const double radius = read_number(document, element);
  if (!(radius > 0)) {
    document.fail(element, "a sphere's radius must be above 0; write such a number");
  }
  return radius;
}

}  // namespace

ColladaGeometry read_geometry(const ColladaDocument& document, const XMLElement& geometry) {
  ColladaGeometry result;
  if (const XMLElement* sphere = course_child(geometry, "sphere")) {
    result.sphere_radius = read_sphere(document, *sphere);
    return result;
  }
  const XMLElement* mesh = geometry.FirstChildElement("mesh");
  if (mesh == nullptr) {
    document.fail(geometry, "geometry " + label(geometry) +
                                " is neither a mesh nor a sphere; convert it to a mesh");
  }
  Sources sources;
  std::size_t without_surface = 0;
  for (const XMLElement* set = mesh->FirstChildElement(); set != nullptr;
       set = set->NextSiblingElement()) {
    const std::string_view kind = set->Name();
    if (kind == "polylist" || kind == "triangles" || kind == "polygons") {
      MeshPart part = read_part(document, *set, sources);
      without_surface += part.without_surface;
      if (!part.triangles.empty()) result.parts.push_back(std::move(part));
    } else if (kind == "lines" || kind == "linestrips") {
      result.notes.push_back("geometry " + label(geometry) + " has " + std::string(kind) +
                             ", which have no surface and are ignored.");
    } else if (kind == "tristrips" || kind == "trifans") {
      document.fail(*set, "<" + std::string(kind) + "> cannot be read; triangulate the mesh");
    }
  }
  if (without_surface > 0) {
    result.notes.push_back("geometry " + label(geometry) + " has " +
                           std::to_string(without_surface) +
                           " faces of fewer than three corners, which are left out.");
  }
  return result;
}

}  // namespace pt
