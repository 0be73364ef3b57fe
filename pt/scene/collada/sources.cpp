#include "pt/scene/collada/sources.h"

#include "pt/scene/collada/numbers.h"

#include <algorithm>

#include <tinyxml2.h>

namespace pt {

namespace {

constexpr std::size_t kMaxOffset = 63;

const XMLElement* find_input(const XMLElement& parent, std::string_view semantic) {
  for (const XMLElement* input = parent.FirstChildElement("input"); input != nullptr;
       input = input->NextSiblingElement("input")) {
    const char* text = input->Attribute("semantic");
    if (text != nullptr && semantic == text) return input;
  }
  return nullptr;
}

// The layout of the array by its accessor; without an accessor, each vector is three numbers.
struct Accessor {
  std::size_t count, stride, offset;
};

Accessor read_accessor(const ColladaDocument& document, const XMLElement& source,
                       std::size_t numbers) {
  const XMLElement* common = source.FirstChildElement("technique_common");
  const XMLElement* element = common ? common->FirstChildElement("accessor") : nullptr;
  if (element == nullptr) return {numbers / 3, 3, 0};
  const std::size_t stride = read_count(document, *element, "stride").value_or(1);
  const std::size_t offset = read_count(document, *element, "offset").value_or(0);
  if (stride < 3)
    document.fail(*element, "positions and normals have 3 numbers; correct the stride");
  const std::size_t fit = offset > numbers ? 0 : (numbers - offset) / stride;
  const std::size_t count = read_count(document, *element, "count").value_or(fit);
  if (count > fit) {
    document.fail(*element, "<accessor> asks for " + std::to_string(count) + " vectors and the " +
                                "array has " + std::to_string(fit) +
                                "; correct the count, or copy the file again if it was cut off");
  }
  return {count, stride, offset};
}

std::vector<Vec3> read_vectors(const ColladaDocument& document, const XMLElement& source) {
  const XMLElement& array = document.child(source, "float_array");
  const std::vector<double> numbers = read_numbers(document, array);
  const std::size_t announced = read_count(document, array, "count").value_or(numbers.size());
  if (announced != numbers.size()) {
    document.fail(array, "<float_array> announces " + std::to_string(announced) +
                             " numbers and holds " + std::to_string(numbers.size()) +
                             "; correct the count, or copy the file again if it was cut off");
  }
  const Accessor accessor = read_accessor(document, source, numbers.size());
  std::vector<Vec3> vectors;
  vectors.reserve(accessor.count);
  for (std::size_t i = 0; i < accessor.count; ++i) {
    const double* v = numbers.data() + accessor.offset + i * accessor.stride;
    vectors.push_back({v[0], v[1], v[2]});
  }
  return vectors;
}

const std::vector<Vec3>* shared_vectors(const ColladaDocument& document, const XMLElement& input,
                                        Sources& sources) {
  const XMLElement& source = document.resolve(input, "source", "source");
  const auto known = sources.find(&source);
  if (known != sources.end()) return &known->second;
  return &sources.emplace(&source, read_vectors(document, source)).first->second;
}

int read_offset(const ColladaDocument& document, const XMLElement& input) {
  const std::optional<std::size_t> offset = read_count(document, input, "offset");
  if (!offset || *offset > kMaxOffset) {
    document.fail(input, "an input of a set of faces needs an offset from 0 to 63; write one");
  }
  return static_cast<int>(*offset);
}

Vec3 checked(const ColladaDocument& document, const XMLElement& at, const std::vector<Vec3>& from,
             int index, const char* what) {
  if (index < 0 || static_cast<std::size_t>(index) >= from.size()) {
    document.fail(at, std::string("a face asks for ") + what + " " + std::to_string(index) +
                          " of " + std::to_string(from.size()) +
                          " (counted from 0); export the mesh again");
  }
  return from[static_cast<std::size_t>(index)];
}

}  // namespace

FaceInputs read_inputs(const ColladaDocument& document, const XMLElement& faces, Sources& sources) {
  FaceInputs inputs;
  for (const XMLElement* input = faces.FirstChildElement("input"); input != nullptr;
       input = input->NextSiblingElement("input")) {
    inputs.stride = std::max(inputs.stride, read_offset(document, *input) + 1);
  }
  const XMLElement* vertex = find_input(faces, "VERTEX");
  if (vertex == nullptr) document.fail(faces, "the faces have no input VERTEX; add it");
  const XMLElement& vertices = document.resolve(*vertex, "source", "vertices");
  const XMLElement* position = find_input(vertices, "POSITION");
  if (position == nullptr) document.fail(vertices, "<vertices> has no input POSITION; add it");
  inputs.positions = shared_vectors(document, *position, sources);
  inputs.position_offset = read_offset(document, *vertex);

  if (const XMLElement* normal = find_input(faces, "NORMAL")) {
    inputs.normals = shared_vectors(document, *normal, sources);
    inputs.normal_offset = read_offset(document, *normal);
  } else if (const XMLElement* vertex_normal = find_input(vertices, "NORMAL")) {
    inputs.normals = shared_vectors(document, *vertex_normal, sources);
    inputs.normal_offset = inputs.position_offset;
  }
  return inputs;
}

Vec3 FaceInputs::position(const ColladaDocument& document, const XMLElement& at,
                          const int* corner) const {
  return checked(document, at, *positions, corner[position_offset], "position");
}

Vec3 FaceInputs::normal(const ColladaDocument& document, const XMLElement& at,
                        const int* corner) const {
  if (normals == nullptr || normals->empty()) return {};
  return checked(document, at, *normals, corner[normal_offset], "normal");
}

}  // namespace pt
