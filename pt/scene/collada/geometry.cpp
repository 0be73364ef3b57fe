#include "pt/scene/collada/geometry.h"

#include "pt/scene/collada/document.h"
#include "pt/scene/collada/numbers.h"
#include "pt/scene/collada/triangulate.h"

#include <numeric>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include <tinyxml2.h>

namespace pt {

namespace {

// The lists of indices of one set of faces: corner i of the set reads its indices at
// i * stride + offset, and face j has corners[j] of them.
struct Faces {
  std::vector<int> corners;
  std::vector<int> indices;
  // Of the faces with holes: the corners of the outline, then of each hole.
  std::unordered_map<std::size_t, std::vector<int>> rings{};
};

void check_face_count(const Document& document, const XMLElement& set, std::size_t faces_found) {
  const std::optional<std::size_t> count = read_count(document, set, "count");
  if (count && *count != faces_found) {
    document.fail(set, tag(set) + " announces " + std::to_string(*count) + " faces and holds " +
                           std::to_string(faces_found) +
                           "; correct the count, or copy the file again if it was cut off");
  }
}

// <triangles>, or a <polylist>, which has the number of corners of each face.
Faces read_one_list(const Document& document, const XMLElement& set, int stride) {
  Faces faces;
  if (const XMLElement* p = set.FirstChildElement("p")) faces.indices = read_integers(document, *p);
  if (std::string_view(set.Name()) == "triangles") {
    faces.corners.assign(faces.indices.size() / (3 * static_cast<std::size_t>(stride)), 3);
  } else if (const XMLElement* vcount = set.FirstChildElement("vcount")) {
    faces.corners = read_integers(document, *vcount);
  }
  return faces;
}

// Appends the indices of a <p> or an <h>, and returns the number of its corners.
int append_corners(const Document& document, const XMLElement& list, int stride, Faces& faces) {
  const std::vector<int> indices = read_integers(document, list);
  if (indices.size() % static_cast<std::size_t>(stride) != 0) {
    document.fail(list, tag(list) + " ends in the middle of a corner; write " +
                            std::to_string(stride) + " indices per corner");
  }
  faces.indices.insert(faces.indices.end(), indices.begin(), indices.end());
  return static_cast<int>(indices.size()) / stride;
}

// The corners of each <p>, one after the other: a face, a strip or a fan. A <ph> is a face with holes: a <p> and an <h> for each.
Faces read_lists(const Document& document, const XMLElement& set, int stride) {
  Faces lists;
  for (const XMLElement* face : children(set)) {
    const std::string_view kind = face->Name();
    if (kind == "p") lists.corners.push_back(append_corners(document, *face, stride, lists));
    if (kind != "ph") continue;
    std::vector<int> rings{append_corners(document, document.child(*face, "p"), stride, lists)};
    for (const XMLElement* hole : children(*face, "h")) {
      rings.push_back(append_corners(document, *hole, stride, lists));
    }
    lists.corners.push_back(std::accumulate(rings.begin(), rings.end(), 0));
    lists.rings.emplace(lists.corners.size() - 1, std::move(rings));
  }
  return lists;
}

// The triangles of strips (A B C, C B D, C D E, ...) or of fans (A B C, A C D, ...). A list of
// fewer than three corners stays, so that it is counted.
Faces unfold(const Faces& lists, int stride, bool are_strips) {
  Faces triangles;
  const auto add = [&](const int* corner) {
    triangles.indices.insert(triangles.indices.end(), corner, corner + stride);
  };
  const int* list = lists.indices.data();
  for (const int corners : lists.corners) {
    if (corners < 3) {
      triangles.corners.push_back(corners);
      for (int i = 0; i < corners; ++i) add(list + i * stride);
    }
    for (int i = 0; i + 2 < corners; ++i) {
      const bool is_turned = are_strips && i % 2 == 1;
      const int first = are_strips ? i : 0;
      for (const int corner : {is_turned ? i + 1 : first, is_turned ? first : i + 1, i + 2}) {
        add(list + corner * stride);
      }
      triangles.corners.push_back(3);
    }
    list += corners * stride;
  }
  return triangles;
}

void check_sizes(const Document& document, const XMLElement& set, const Faces& faces, int stride) {
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

// Returns whether the element is a set of faces: <polylist>, <triangles>, <polygons>, <tristrips>
// or <trifans>.
bool is_set_of_faces(const XMLElement& element) {
  const std::string_view kind = element.Name();
  return kind == "polylist" || kind == "triangles" || kind == "polygons" || kind == "tristrips" ||
         kind == "trifans";
}

// The faces of a set with `stride` indices per corner. Strips and fans are unfolded to triangles.
Faces read_faces(const Document& document, const XMLElement& set, int stride) {
  const std::string_view kind = set.Name();
  const bool is_one_list = kind == "polylist" || kind == "triangles";
  Faces faces =
      is_one_list ? read_one_list(document, set, stride) : read_lists(document, set, stride);
  check_face_count(document, set, faces.corners.size());
  check_sizes(document, set, faces, stride);
  if (kind == "tristrips" || kind == "trifans") return unfold(faces, stride, kind == "tristrips");
  return faces;
}

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
  for (std::size_t which = 0; which < faces.corners.size(); ++which) {
    const int corners = faces.corners[which];
    face.clear();
    points.clear();
    for (int i = 0; i < corners; ++i, indices += stride) {
      if (corners < 3) continue;
      face.push_back(part.inputs.corner(document, set, indices));
      points.push_back((*part.inputs.positions)[face.back().position]);
    }
    const auto rings = faces.rings.find(which);
    const Triangulation cut = rings == faces.rings.end() || corners < 3
                                  ? triangulate(points)
                                  : triangulate_with_holes(points, rings->second);
    for (const int corner : cut.corners) part.corners.push_back(face[corner]);
    without_surface += corners < 3 ? 1 : 0;
    crossing += cut.crosses ? 1 : 0;
  }
  note_count(document, set, name, without_surface,
             "of fewer than three corners, which are left out");
  note_count(document, set, name, crossing,
             "that cross themselves or a hole, or are far from flat: each is shown as a fan around "
             "its first corner, or without its holes");
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
