#include "pt/scene/collada/transforms.h"

#include "pt/scene/collada/numbers.h"

#include <algorithm>
#include <cmath>

#include <tinyxml2.h>

namespace pt {

namespace {

Vec3 read_vec3(const Document& document, const XMLElement& element) {
  const std::vector<double> v = read_numbers(document, element, 3);
  return {v[0], v[1], v[2]};
}

// Exporters compute the matrix in single precision, and so its last row.
constexpr double kRounding = 1e-5;

// The distance of the last row from 0 0 0 1.
double off_affine(const std::vector<double>& m) {
  return std::max({std::abs(m[12]), std::abs(m[13]), std::abs(m[14]), std::abs(m[15] - 1)});
}

// An object at `eye` has its -z axis towards `interest`, and its y axis as near to `up` as possible
// (COLLADA 1.4.1, "lookat").
Transform read_lookat(const Document& document, const XMLElement& lookat) {
  const std::vector<double> v = read_numbers(document, lookat, 9);
  const Vec3 eye{v[0], v[1], v[2]}, interest{v[3], v[4], v[5]}, up{v[6], v[7], v[8]};
  const Vec3 backwards = eye - interest;
  if (!std::isnormal(length_squared(backwards))) {
    document.fail(lookat, "<lookat> looks at its own place; write an eye and another point");
  }
  const Frame frame =
      upright_frame(document, normalize(backwards), up,
                    "a <lookat> has an up direction along its view: another is taken.");
  return {frame.x, frame.y, frame.z, eye};
}

// About an axis by an angle in degrees, anticlockwise seen from the axis' tip (Rodrigues, 1840).
Transform read_rotate(const Document& document, const XMLElement& rotate) {
  const std::vector<double> r = read_numbers(document, rotate, 4);
  const Vec3 axis{r[0], r[1], r[2]};
  const double squared = length_squared(axis);
  if (!std::isnormal(squared)) {
    if (r[3] != 0) {
      document.note("a <rotate> has an axis without a direction (" + line(rotate) +
                    "): it turns nothing.");
    }
    return {};
  }
  const Vec3 k = axis / std::sqrt(squared);
  const double angle = r[3] * (kPi / 180);
  const double c = std::cos(angle), s = std::sin(angle);
  const auto turned = [&](Vec3 v) { return c * v + s * cross(k, v) + (1 - c) * dot(k, v) * k; };
  return {turned({1, 0, 0}), turned({0, 1, 0}), turned({0, 0, 1}), {}};
}

}  // namespace

// The last row is 0 0 0 1. (One of the course's files lacks a number of a camera's matrix; its rows
// are then shifted, so that the last row means nothing.)
Transform read_matrix(const Document& document, const XMLElement& matrix, bool holds_camera) {
  std::vector<double> m = read_numbers(document, matrix);
  if (m.size() == 15 && holds_camera) {
    document.note("the camera's matrix has 15 numbers: a 1 is added as the 16th.");
    m.push_back(1);
  } else if (m.size() != 16) {
    document.fail(matrix, "<matrix> holds " + std::to_string(m.size()) + " numbers; write 16");
  } else if (const double off = off_affine(m); off != 0) {
    if (!(off <= kRounding)) {
      document.fail(matrix,
                    "the last row of <matrix> is not 0 0 0 1; write an affine map, row by row");
    }
    document.note("a <matrix> ends in a row that is 0 0 0 1 but for rounding: it is read as that.");
  }
  return {{m[0], m[4], m[8]}, {m[1], m[5], m[9]}, {m[2], m[6], m[10]}, {m[3], m[7], m[11]}};
}

Transform node_transform(const Document& document, const XMLElement& node) {
  const bool holds_camera = node.FirstChildElement("instance_camera") != nullptr;
  Transform map;
  for (const XMLElement* step : children(node)) {
    const std::string_view kind = step->Name();
    if (kind == "matrix") {
      map = map * read_matrix(document, *step, holds_camera);
    } else if (kind == "translate") {
      map = map * Transform{.translation = read_vec3(document, *step)};
    } else if (kind == "rotate") {
      map = map * read_rotate(document, *step);
    } else if (kind == "scale") {
      const Vec3 s = read_vec3(document, *step);
      map = map * Transform{{s.x, 0, 0}, {0, s.y, 0}, {0, 0, s.z}, {}};
    } else if (kind == "lookat") {
      map = map * read_lookat(document, *step);
    } else if (kind == "skew") {
      document.fail(*step, "<skew> cannot be read; write a <matrix>");
    }
  }
  return map;
}

Frame upright_frame(const Document& document, Vec3 z, Vec3 up, const std::string& note) {
  Vec3 right = cross(up, z);
  if (!(length(right) > 1e-6 * length(up))) {
    document.note(note);
    right = cross(Vec3{0, 1, 0}, z);
    if (!(length(right) > 1e-6)) right = {1, 0, 0};
  }
  const Vec3 x = normalize(right);
  return {x, cross(z, x), z};
}

void check_finite(const Document& document, const XMLElement& at, const Transform& map) {
  for (const Vec3 v : {map.x, map.y, map.z, map.translation}) {
    if (!(is_finite(v) && max_abs(v) <= kMaxCoordinate)) {
      document.fail(at, "node " + label(at) + " is placed with numbers beyond 1e30; scale it down");
    }
  }
}

}  // namespace pt
