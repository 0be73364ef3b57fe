#include "pt/scene/collada/sources.h"

#include "pt/scene/collada/numbers.h"

#include <algorithm>
#include <array>

#include <tinyxml2.h>

namespace pt {

namespace {

constexpr std::size_t kMaxOffset = 63;

const XMLElement* find_input(const XMLElement& parent, std::string_view semantic) {
  for (const XMLElement* input : children(parent, "input")) {
    if (attribute(input, "semantic") == semantic) return input;
  }
  return nullptr;
}

// Vector i of a source is made of the numbers offset + i * stride + slots[0..2] of its array.
struct Accessor {
  std::size_t count, stride, offset;
  std::array<std::size_t, 3> slots{0, 1, 2};
};

// The numbers of a vector that the file gives a name: the specification skips those without. Where
// no number has a name, all count.
std::array<std::size_t, 3> named_slots(const Document& document, const XMLElement& accessor,
                                       std::size_t stride) {
  std::vector<std::size_t> slots;
  std::size_t slot = 0;
  for (const XMLElement* param : children(accessor, "param")) {
    if (!attribute(param, "name").empty() && slot < stride) slots.push_back(slot);
    ++slot;
  }
  const std::string where = " (" + line(accessor) + ").";
  if (slots.empty()) {
    if (slot > 0) document.note("no <param> of an <accessor> has a name: all are read" + where);
    return {0, 1, 2};
  }
  if (slots.size() < 3) {
    document.fail(accessor, "<accessor> names " + std::to_string(slots.size()) +
                                " numbers of a vector; name three with <param name>");
  }
  if (slots[2] != 2) {
    document.note("an <accessor> skips numbers, because their <param> has no name" + where);
  }
  return {slots[0], slots[1], slots[2]};
}

// Without an accessor, each vector is three numbers.
Accessor read_accessor(const Document& document, const XMLElement* element, std::size_t numbers) {
  if (element == nullptr) return {numbers / 3, 3, 0};
  const std::size_t stride = read_count(document, *element, "stride").value_or(1);
  const std::size_t offset = read_count(document, *element, "offset").value_or(0);
  if (stride < 2)
    document.fail(*element, "positions and normals have 3 numbers; correct the stride");
  const std::size_t fit = offset > numbers ? 0 : (numbers - offset) / stride;
  const std::size_t count = read_count(document, *element, "count").value_or(fit);
  if (count > fit) {
    document.fail(*element, "<accessor> asks for " + std::to_string(count) +
                                " vectors and the array has " + std::to_string(fit) +
                                "; correct the count, or copy the file again if it was cut off");
  }
  if (stride > 2) return {count, stride, offset, named_slots(document, *element, stride)};
  document.note("positions or normals of two numbers: the third is 0.");
  return {count, stride, offset};
}

// The array that the accessor names, which may be that of another source; else the source's own.
const XMLElement& find_array(const Document& document, const XMLElement& source,
                             const XMLElement* accessor) {
  const std::string_view url = attribute(accessor, "source");
  const XMLElement* own = source.FirstChildElement("float_array");
  if (url.empty()) return document.child(source, "float_array");
  const std::string_view id = attribute(own, "id");
  if (!id.empty() && url == "#" + std::string(id)) return *own;
  if (own == nullptr || document.find(accessor, "source", "float_array").first != nullptr) {
    return document.resolve(*accessor, "source", "float_array");
  }
  document.note("an <accessor> names no array of the file (" + quoted(url) +
                "): the array of its own source is read.");
  return *own;
}

std::vector<Vec3> read_vectors(const Document& document, const XMLElement& source) {
  const XMLElement* element = find_below(&source, {"technique_common", "accessor"});
  const XMLElement& array = find_array(document, source, element);
  const std::vector<double> numbers = read_numbers(document, array);
  const std::size_t announced = read_count(document, array, "count").value_or(numbers.size());
  const std::string both = "<float_array> announces " + std::to_string(announced) +
                           " numbers and holds " + std::to_string(numbers.size());
  if (announced > numbers.size()) {
    document.fail(array, both + "; correct the count, or copy the file again if it was cut off");
  }
  if (announced < numbers.size()) document.note("a " + both + ": all are read.");
  const Accessor accessor = read_accessor(document, element, numbers.size());
  std::vector<Vec3> vectors;
  vectors.reserve(accessor.count);
  for (std::size_t i = 0; i < accessor.count; ++i) {
    const double* v = numbers.data() + accessor.offset + i * accessor.stride;
    const double z = accessor.slots[2] < accessor.stride ? v[accessor.slots[2]] : 0;
    vectors.push_back({v[accessor.slots[0]], v[accessor.slots[1]], z});
  }
  return vectors;
}

const std::vector<Vec3>* shared_vectors(const Document& document, const XMLElement& input,
                                        Sources& sources) {
  const XMLElement& source = document.resolve(input, "source", "source");
  const auto known = sources.find(&source);
  if (known != sources.end()) return &known->second;
  return &sources.emplace(&source, read_vectors(document, source)).first->second;
}

int read_offset(const Document& document, const XMLElement& input) {
  const std::optional<std::size_t> offset = read_count(document, input, "offset");
  if (!offset || *offset > kMaxOffset) {
    document.fail(input, "an input of a set of faces needs an offset from 0 to 63; write one");
  }
  return static_cast<int>(*offset);
}

int checked(const Document& document, const XMLElement& at, const std::vector<Vec3>& from,
            int index, const char* what) {
  if (index < 0 || static_cast<std::size_t>(index) >= from.size()) {
    document.fail(at, std::string("a face asks for ") + what + " " + std::to_string(index) +
                          " of " + std::to_string(from.size()) +
                          " (counted from 0); export the mesh again");
  }
  return index;
}

}  // namespace

int read_stride(const Document& document, const XMLElement& faces) {
  int stride = 1;
  for (const XMLElement* input : children(faces, "input")) {
    stride = std::max(stride, read_offset(document, *input) + 1);
  }
  return stride;
}

FaceInputs read_inputs(const Document& document, const XMLElement& faces, Sources& sources) {
  const XMLElement* vertex = find_input(faces, "VERTEX");
  if (vertex == nullptr) document.fail(faces, "the faces have no input VERTEX; add it");
  const XMLElement& vertices = document.resolve(*vertex, "source", "vertices");
  const XMLElement* position = find_input(vertices, "POSITION");
  if (position == nullptr) document.fail(vertices, "<vertices> has no input POSITION; add it");
  FaceInputs inputs;
  inputs.positions = shared_vectors(document, *position, sources);
  inputs.position_offset = read_offset(document, *vertex);

  const XMLElement* own = find_input(faces, "NORMAL");
  if (const XMLElement* normal = own ? own : find_input(vertices, "NORMAL")) {
    inputs.normals = shared_vectors(document, *normal, sources);
    inputs.normal_offset = own ? read_offset(document, *own) : inputs.position_offset;
    if (inputs.normals->empty()) inputs.normals = nullptr;
  }
  if (find_input(faces, "COLOR") != nullptr || find_input(vertices, "COLOR") != nullptr) {
    document.note("a mesh has colours at its corners (" + line(faces) + "), which are ignored.");
  }
  return inputs;
}

Corner FaceInputs::corner(const Document& document, const XMLElement& at,
                          const int* indices) const {
  const int position = checked(document, at, *positions, indices[position_offset], "position");
  if (normals == nullptr) return {position, 0};
  return {position, checked(document, at, *normals, indices[normal_offset], "normal")};
}

}  // namespace pt
