#include "pt/scene/collada/triangulate.h"

#include <cmath>
#include <optional>
#include <utility>

namespace pt {

namespace {

// An ear is a corner whose triangle with its two neighbours lies in the polygon (Meisters 1975,
// "Polygons have ears"). As in Mapbox's earcut, only corners at which the polygon turns inwards are
// tested against the triangle. The tests per corner are limited, so that a file of any size ends.
constexpr std::size_t kMaxTests = 4000;

constexpr double kProductRounding = 1e-9;  // of the face's area

// Twice the area of the face along its normal, whatever its shape (Newell's method: Sutherland,
// Sproull, Schumacker 1974).
Vec3 doubled_area(std::span<const Vec3> face) {
  Vec3 sum{};
  for (std::size_t i = 1; i + 1 < face.size(); ++i) {
    sum += cross(face[i] - face[0], face[i + 1] - face[0]);
  }
  return sum;
}

Triangulation fan(std::size_t corners, bool crosses) {
  Triangulation result{{}, crosses};
  for (int i = 1; i + 1 < static_cast<int>(corners); ++i) {
    result.corners.insert(result.corners.end(), {0, i, i + 1});
  }
  return result;
}

// A fan covers the face if all of its triangles face one way.
bool is_covered_by_fan(std::span<const Vec3> face, Vec3 normal) {
  const double least = -kProductRounding * length_squared(normal);
  const bool has_normal = std::isnormal(length_squared(normal));
  for (std::size_t i = 1; i + 1 < face.size(); ++i) {
    const Vec3 triangle = cross(face[i] - face[0], face[i + 1] - face[0]);
    if (!(dot(triangle, normal) >= least)) return false;
    if (!has_normal && std::isnormal(length_squared(triangle))) return false;
  }
  return true;
}

// The polygon that remains: its corners run anticlockwise, in a plane.
struct Ring {
  std::vector<Vec2> at;
  std::vector<int> next, previous;

  // Twice the area of a triangle; above 0 if c is to the left of the line from a to b.
  double area(int a, int b, int c) const {
    return (at[b].x - at[a].x) * (at[c].y - at[a].y) - (at[c].x - at[a].x) * (at[b].y - at[a].y);
  }
  bool turns_left(int i) const { return area(previous[i], i, next[i]) > 0; }
};

// The face seen along the axis that is nearest to its normal.
Ring flatten(std::span<const Vec3> face, Vec3 normal) {
  const Vec3 size{std::abs(normal.x), std::abs(normal.y), std::abs(normal.z)};
  const int axis = size.x > size.y && size.x > size.z ? 0 : size.y > size.z ? 1 : 2;
  const int first = normal[axis] > 0 ? (axis + 1) % 3 : (axis + 2) % 3;
  const int second = 3 - axis - first;
  const int n = static_cast<int>(face.size());
  Ring ring;
  for (int i = 0; i < n; ++i) {
    ring.at.push_back({face[i][first], face[i][second]});
    ring.next.push_back((i + 1) % n);
    ring.previous.push_back((i + n - 1) % n);
  }
  return ring;
}

// The corners that may be cut off. Those on a straight line come last, and so do those that another
// part of the polygon touches.
enum class Ear { proper, any };

// Returns whether corner b is an ear, and counts the corners tested. Where a bridge joins a hole to
// the outline, corners coincide: then the new edge from c to a has to stay between the edges at
// its ends.
bool is_ear(const Ring& ring, int b, Ear kind, double rounding, std::size_t& tests) {
  const int a = ring.previous[b], c = ring.next[b];
  const bool proper = kind == Ear::proper;
  if (!(ring.area(a, b, c) > (proper ? rounding : -rounding))) return false;
  if (ring.turns_left(a) && ring.area(a, c, ring.previous[a]) < -rounding) return false;
  if (ring.turns_left(c) && ring.area(a, c, ring.next[c]) < -rounding) return false;
  const auto same = [&](int i, int j) {
    return ring.at[i].x == ring.at[j].x && ring.at[i].y == ring.at[j].y;
  };
  const double least = proper ? 0 : rounding;
  for (int i = ring.next[c]; i != a; i = ring.next[i]) {
    ++tests;
    if (ring.area(a, b, i) < least || ring.area(b, c, i) < least || ring.area(c, a, i) < least) {
      continue;
    }
    if (!ring.turns_left(i) && !same(i, a) && !same(i, b) && !same(i, c)) return false;
  }
  return true;
}

// Nothing if no ear is left, or if the tests are too many.
std::optional<std::vector<int>> cut_ears(Ring ring, double rounding) {
  const std::size_t corners = ring.at.size();
  std::vector<int> cut;
  std::size_t tests = 0, since_last = 0, left = corners;
  Ear kind = Ear::proper;
  for (int b = 0; left > 3;) {
    const int a = ring.previous[b], c = ring.next[b];
    if (is_ear(ring, b, kind, rounding, tests)) {
      cut.insert(cut.end(), {a, b, c});
      ring.next[a] = c;
      ring.previous[c] = a;
      --left;
      since_last = 0;
      kind = Ear::proper;
      b = ring.next[c];  // not c, so that the triangles do not all meet in one corner
      continue;
    }
    if (tests > kMaxTests * corners) return std::nullopt;
    b = c;
    if (++since_last <= left) continue;
    if (kind == Ear::any) return std::nullopt;
    kind = Ear::any;
    since_last = 0;
  }
  const int b = cut.empty() ? 0 : cut.back();
  const int last = ring.next[b];
  if (ring.area(ring.previous[b], b, last) < -rounding) return std::nullopt;
  cut.insert(cut.end(), {ring.previous[b], b, last});
  return cut;
}

}  // namespace

Triangulation triangulate(std::span<const Vec3> face) {
  if (face.size() <= 3) return fan(face.size(), false);
  const Vec3 normal = doubled_area(face);
  if (is_covered_by_fan(face, normal)) return fan(face.size(), false);
  if (!std::isnormal(length_squared(normal))) return fan(face.size(), true);
  const double rounding = kProductRounding * max_abs(normal);
  std::optional<std::vector<int>> cut = cut_ears(flatten(face, normal), rounding);
  if (!cut) return fan(face.size(), true);
  return {std::move(*cut), false};
}

}  // namespace pt
