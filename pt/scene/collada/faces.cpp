#include "pt/scene/collada/faces.h"

#include "pt/scene/collada/numbers.h"

#include <string>

#include <tinyxml2.h>

namespace pt {

namespace {

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

// The corners of each <p>, one after the other: a face, a strip or a fan.
Faces read_lists(const Document& document, const XMLElement& set, int stride) {
  if (const XMLElement* holed = set.FirstChildElement("ph")) {
    document.fail(*holed, "a face with holes (<ph>) cannot be read; triangulate the mesh");
  }
  Faces lists;
  for (const XMLElement* p : children(set, "p")) {
    const std::vector<int> indices = read_integers(document, *p);
    if (indices.size() % static_cast<std::size_t>(stride) != 0) {
      document.fail(*p, "<p> ends in the middle of a corner; write " + std::to_string(stride) +
                            " indices per corner");
    }
    lists.corners.push_back(static_cast<int>(indices.size()) / stride);
    lists.indices.insert(lists.indices.end(), indices.begin(), indices.end());
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

}  // namespace

bool is_set_of_faces(const XMLElement& element) {
  const std::string_view kind = element.Name();
  return kind == "polylist" || kind == "triangles" || kind == "polygons" || kind == "tristrips" ||
         kind == "trifans";
}

Faces read_faces(const Document& document, const XMLElement& set, int stride) {
  const std::string_view kind = set.Name();
  const bool is_one_list = kind == "polylist" || kind == "triangles";
  const Faces faces =
      is_one_list ? read_one_list(document, set, stride) : read_lists(document, set, stride);
  check_face_count(document, set, faces.corners.size());
  check_sizes(document, set, faces, stride);
  if (kind == "tristrips" || kind == "trifans") return unfold(faces, stride, kind == "tristrips");
  return faces;
}

}  // namespace pt
