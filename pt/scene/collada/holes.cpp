#include "pt/math/frame.h"
#include "pt/scene/collada/triangulate.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace pt {

namespace {

// Each hole looks at the whole outline, so that a face of many holes would take very long.
constexpr std::size_t kMaxHoles = 1000;

using CornerList = std::vector<int>;  // indices of corners
using FlatPoints = std::vector<Vec2>;

// Twice the area of a triangle; above 0 if c is to the left of the line from a to b.
double area(Vec2 a, Vec2 b, Vec2 c) {
  return (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
}

double area(const FlatPoints& at, const CornerList& ring) {
  double sum = 0;
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
    sum += area(at[ring[0]], at[ring[i]], at[ring[i + 1]]);
  }
  return sum;
}

// Returns whether p lies within the angle of the outline at its corner i. Where bridges end, corners coincide, and p
// lies within the angle of one of them.
bool is_within_angle(const FlatPoints& at, const CornerList& outline, std::size_t i, Vec2 p) {
  const std::size_t n = outline.size();
  const Vec2 a = at[outline[(i + n - 1) % n]], b = at[outline[i]], c = at[outline[(i + 1) % n]];
  const bool left_of_first = area(a, b, p) >= 0, left_of_second = area(b, c, p) >= 0;
  return area(a, b, c) > 0 ? left_of_first && left_of_second : left_of_first || left_of_second;
}

// The corner of the outline that p sees, near the direction of x (Eberly 1998, "Triangulation by
// ear clipping"). Nothing if p is not inside.
std::optional<std::size_t> visible_corner(const FlatPoints& at, const CornerList& outline, Vec2 p) {
  const std::size_t n = outline.size();
  Vec2 met{kInfinity, p.y}, end{};  // the nearest edge in that direction, and its further end
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 a = at[outline[i]], b = at[outline[(i + 1) % n]];
    if (!(a.y < b.y && a.y <= p.y && p.y <= b.y)) continue;
    const double x = a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x);
    if (!(x >= p.x && x < met.x)) continue;
    met.x = x;
    end = a.x > b.x ? a : b;
  }
  // A corner in the triangle of p and this edge hides what is behind it.
  const bool is_below = end.y < p.y;
  std::optional<std::size_t> best;
  double least_slope = kInfinity, nearest = kInfinity;
  for (std::size_t i = 0; i < n && met.x < kInfinity; ++i) {
    const Vec2 r = at[outline[i]];
    const bool is_end = r.x == end.x && r.y == end.y;
    const bool is_inside = is_below ? area(p, end, r) >= 0 && area(end, met, r) >= 0 && r.y <= p.y
                                    : area(end, p, r) >= 0 && area(met, end, r) >= 0 && r.y >= p.y;
    if (!(is_end || is_inside) || r.x < p.x || !is_within_angle(at, outline, i, p)) continue;
    const double slope = r.y == p.y ? 0 : std::abs(r.y - p.y) / (r.x - p.x);
    if (!(slope < least_slope || (slope == least_slope && r.x < nearest))) continue;
    least_slope = slope;
    nearest = r.x;
    best = i;
  }
  return best;
}

bool lies_left(const FlatPoints& at, int a, int b) { return at[a].x < at[b].x; }

// The outline with a bridge to the hole, and back.
std::optional<CornerList> joined(const FlatPoints& at, const CornerList& outline, CornerList hole) {
  const auto lies_left_here = [&](int a, int b) { return lies_left(at, a, b); };
  std::rotate(hole.begin(), std::max_element(hole.begin(), hole.end(), lies_left_here), hole.end());
  const std::optional<std::size_t> corner = visible_corner(at, outline, at[hole[0]]);
  if (!corner) return std::nullopt;
  const auto split = outline.begin() + static_cast<std::ptrdiff_t>(*corner);
  CornerList ring(outline.begin(), split + 1);
  ring.insert(ring.end(), hole.begin(), hole.end());
  ring.push_back(hole[0]);
  ring.insert(ring.end(), split, outline.end());
  return ring;
}

// The corners as they lie in the plane of the outline, which runs anticlockwise there.
FlatPoints flattened(std::span<const Vec3> corners, std::size_t outline) {
  Vec3 normal{};
  for (std::size_t i = 1; i + 1 < outline; ++i) {
    normal += cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
  }
  const Frame frame =
      frame_from_normal(length_squared(normal) > 0 ? normalize(normal) : Vec3{0, 0, 1});
  FlatPoints at;
  for (const Vec3 p : corners) {
    at.push_back({dot(p - corners[0], frame.x), dot(p - corners[0], frame.y)});
  }
  return at;
}

}  // namespace

Triangulation triangulate_with_holes(std::span<const Vec3> corners, std::span<const int> rings) {
  const FlatPoints at = flattened(corners, static_cast<std::size_t>(rings[0]));
  std::vector<CornerList> holes;
  int first = 0;
  for (const int size : rings) {
    CornerList ring;
    for (int i = 0; i < size; ++i) ring.push_back(first++);
    // A hole runs clockwise.
    if (!holes.empty() && area(at, ring) > 0) std::reverse(ring.begin(), ring.end());
    if (holes.empty() || size >= 3) holes.push_back(ring);
  }
  const CornerList alone = holes[0];
  CornerList outline = alone;
  holes.erase(holes.begin());
  const auto right_end = [&](const CornerList& ring) {
    return *std::max_element(ring.begin(), ring.end(),
                             [&](int a, int b) { return lies_left(at, a, b); });
  };
  std::sort(holes.begin(), holes.end(), [&](const CornerList& a, const CornerList& b) {
    return lies_left(at, right_end(b), right_end(a));
  });
  bool fits = holes.size() <= kMaxHoles;
  for (std::size_t i = 0; fits && i < holes.size(); ++i) {
    const std::optional<CornerList> more = joined(at, outline, holes[i]);
    fits = more.has_value();
    if (more) outline = *more;
  }
  if (!fits) outline = alone;
  std::vector<Vec3> points;
  for (const int corner : outline) points.push_back(corners[corner]);
  Triangulation cut = triangulate(points);
  for (int& corner : cut.corners) corner = outline[corner];
  cut.crosses = cut.crosses || !fits;
  return cut;
}

}  // namespace pt
