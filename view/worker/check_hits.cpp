#include "grader/tasks/hit_sphere/truth.h"
#include "grader/tasks/hit_triangle/truth.h"
#include "pt/tasks/hit_box.h"
#include "view/worker/check.h"

namespace view {

namespace {

using namespace grader::check::hit_sphere_inputs;
using namespace grader::check::hit_triangle_inputs;

struct Blame {
  std::string task, promise, text;
};

// A ray that is nearly parallel to a surface, or whose range ends near it, may hit or miss.
bool is_clear(const pt::Primitives& primitives, const pt::Ray& ray, const pt::Hit& hit) {
  const pt::Vec3 p = ray.at(hit.t), d = normalize(ray.direction);
  const double room = 1e-6 * std::max(hit.t, max_abs(p) / length(ray.direction));
  if (!(hit.t > ray.t_min + room && hit.t < ray.t_max - room)) return false;
  if (!primitives.is_triangle(hit.primitive)) return std::abs(dot(hit.n, d)) > 1e-3;
  const pt::Triangle& triangle = primitives.triangle(hit.primitive);
  return std::abs(dot(normalize(geometric_normal(triangle)), d)) > 1e-4 &&
         place_of(triangle, p).least() > 1e-5;
}

const char* task_of(const pt::Primitives& primitives, int primitive) {
  return primitives.is_triangle(primitive) ? "hit_triangle" : "hit_sphere";
}

// Returns why a hit of one primitive breaks the contract of its task; nothing if it does not.
std::optional<Blame> wrong_hit(const pt::Primitives& primitives, const pt::Ray& ray,
                               const pt::SurfaceHit& hit, int primitive) {
  const std::string task = task_of(primitives, primitive);
  const pt::Vec3 p = ray.at(hit.t);
  if (!(hit.t >= ray.t_min * (1 - 1e-9) && hit.t <= ray.t_max * (1 + 1e-9))) {
    return Blame{task, "keeps_t_inside_the_ray", "t is outside the range of the ray"};
  }
  const bool is_unit = std::abs(length(hit.n) - 1) <= 2e-5;
  if (!primitives.is_triangle(primitive)) {
    const pt::Sphere& sphere = primitives.sphere(primitive);
    const auto [off_point, off_normal] = off(sphere, ray, hit);
    const double slack = 1e-5 + 1e-12 * max_abs(p) / sphere.radius;
    if (!(off_point <= slack)) {
      return Blame{task, "hits_where_it_is_aimed", "the point at t is not on the sphere"};
    }
    if (!is_unit || !(off_normal <= 1e-4 + slack)) {
      return Blame{task, "returns_the_outward_unit_normal", "n is not the outward unit normal"};
    }
    return std::nullopt;
  }
  const pt::Triangle& triangle = primitives.triangle(primitive);
  const Place place = place_of(triangle, p);
  const double size =
      std::max({max_abs(triangle.p0), max_abs(triangle.p1), max_abs(triangle.p2), max_abs(p)});
  const double off_plane = dot(p - triangle.p0, normalize(geometric_normal(triangle)));
  if (!(std::abs(off_plane) <= 1e-6 * size)) {
    return Blame{task, "hits_where_it_is_aimed", "the point at t is not on the triangle's plane"};
  }
  if (!(place.least() >= -1e-4)) {
    return Blame{task, "misses_outside", "the point at t is outside the triangle"};
  }
  if (!is_unit) return Blame{task, "returns_a_unit_normal", "n does not have length 1"};
  const pt::Vec3 n = rounded(normal_at(triangle, place));
  if (length(hit.n - n) <= 1e-3) return std::nullopt;
  const bool is_flipped = length(hit.n + n) <= 1e-3;
  return Blame{task, is_flipped ? "never_flips_the_normal" : "interpolates_the_corner_normals",
               is_flipped ? "n is turned to the other side"
                          : "n is not the mean of the corner normals at the point"};
}

// The nodes from the root down to the leaf of a primitive; none if there is no such leaf.
std::vector<int> way_to(const pt::Bvh& bvh, int primitive) {
  std::vector<int> parent(bvh.nodes.size(), -1);
  int leaf = -1;
  for (std::size_t i = 0; i < bvh.nodes.size(); ++i) {
    const pt::BvhNode& node = bvh.nodes[i];
    if (!node.is_leaf()) {
      for (const int child : {node.left, node.right}) {
        if (child > static_cast<int>(i) && child < static_cast<int>(parent.size())) {
          parent[child] = static_cast<int>(i);
        }
      }
      continue;
    }
    for (int k = node.first; k < node.first + node.count; ++k) {
      if (k >= 0 && k < static_cast<int>(bvh.order.size()) && bvh.order[k] == primitive) {
        leaf = static_cast<int>(i);
      }
    }
  }
  std::vector<int> way;
  for (int i = leaf; i >= 0; i = parent[i]) way.push_back(i);
  return way;
}

bool contains(const pt::Box& outer, const pt::Box& inner) {
  const pt::Vec3 low = min(outer.min, inner.min), high = max(outer.max, inner.max);
  return low == outer.min && high == outer.max;
}

// Which call hides a primitive that the ray meets: that of the primitive, of a box above it, or the tree, or the search.
Blame blame_miss(const pt::Scene& scene, const pt::Ray& ray, const pt::Hit& truth,
                 const char* promise) {
  const pt::Primitives& primitives = scene.primitives;
  const std::string which = "primitive " + std::to_string(truth.primitive);
  const auto alone = hit_primitive(primitives, truth.primitive, ray);
  if (!alone || !close(alone->t, truth.t, 1e-6)) {
    return {task_of(primitives, truth.primitive), "hits_where_it_is_aimed",
            "the ray meets " + which + " at t = " + std::to_string(truth.t)};
  }
  const std::vector<int> way = way_to(scene.tracer.bvh(), truth.primitive);
  if (way.empty()) return {"build_bvh", "keeps_every_primitive_once", which + " is in no leaf"};
  for (const int node : way) {
    const pt::Box& box = scene.tracer.bvh().nodes[node].box;
    if (!contains(box, bounds(primitives, truth.primitive))) {
      return {"build_bvh", "covers_its_primitives",
              "the box of node " + std::to_string(node) + " does not contain " + which};
    }
    if (!hit_box(box, ray)) {
      return {"hit_box", "hits_where_it_is_aimed",
              "the ray meets " + which + " in the box of node " + std::to_string(node)};
    }
  }
  return {"hit_bvh", promise, "the ray meets " + which + " at t = " + std::to_string(truth.t)};
}

std::optional<Blame> check_closest(const pt::Scene& scene, const pt::Tracer& exact,
                                   const pt::Ray& ray, const std::optional<pt::Hit>& hit) {
  const pt::Primitives& primitives = scene.primitives;
  if (hit) {
    if (!(hit->primitive >= 0 && hit->primitive < primitives.size())) {
      return Blame{"hit_bvh", "says_which_primitive", "there is no such primitive"};
    }
    const auto alone = hit_primitive(primitives, hit->primitive, ray);
    if (alone && alone->t == hit->t && alone->n == hit->n) {
      if (auto wrong = wrong_hit(primitives, ray, *alone, hit->primitive)) return wrong;
    } else if (wrong_hit(primitives, ray, {hit->t, hit->n}, hit->primitive)) {
      return Blame{"hit_bvh", "says_which_primitive",
                   "t and n are not those of primitive " + std::to_string(hit->primitive)};
    }
  }
  const auto truth = exact.closest(primitives, ray);
  const bool is_missed = truth && (!hit || hit->t > truth->t * (1 + 1e-6));
  if (!is_missed || !is_clear(primitives, ray, *truth)) return std::nullopt;
  return blame_miss(scene, ray, *truth, "finds_the_nearest_hit");
}

std::optional<Blame> check_occluded(const pt::Scene& scene, const pt::Tracer& exact,
                                    const pt::Ray& ray, bool is_hidden) {
  const pt::Primitives& primitives = scene.primitives;
  const auto truth = exact.closest(primitives, ray);
  if (!is_hidden) {
    if (!truth || !is_clear(primitives, ray, *truth)) return std::nullopt;
    return blame_miss(scene, ray, *truth, "finds_any_hit");
  }
  if (truth) return std::nullopt;
  for (int i = 0; i < primitives.size(); ++i) {
    if (const auto hit = hit_primitive(primitives, i, ray))
      return wrong_hit(primitives, ray, *hit, i);
  }
  return Blame{"hit_bvh", "finds_any_hit", "nothing is in the way"};
}

}  // namespace

void check_hits(const pt::Scene& scene, const pt::Tracer& exact, Path& path) {
  // The other engines call no task of part 2.
  if (scene.tracer.engine() == pt::Engine::wide) return;
  int bounce = 0;
  std::size_t direct_ends = 0;  // the calls before it belong to direct light
  for (std::size_t i = 0; i < path.calls.size(); ++i) {
    const pt::Call& call = path.calls[i];
    if (call.name.starts_with("direct_")) direct_ends = std::max(direct_ends, call.end);
    const bool is_light = i < direct_ends;
    std::optional<Blame> blame;
    if (call.name == "closest") {
      const auto& [of, ray] = std::any_cast<const std::tuple<const pt::Scene*, pt::Ray>&>(call.in);
      const auto hit = std::any_cast<std::optional<pt::Hit>>(call.out);
      if (!is_light) ++bounce;
      blame = check_closest(scene, exact, ray, hit);
    } else if (call.name == "occluded") {
      const auto& [of, ray] = std::any_cast<const std::tuple<const pt::Scene*, pt::Ray>&>(call.in);
      blame = check_occluded(scene, exact, ray, std::any_cast<bool>(call.out));
    }
    if (!blame) continue;
    path.findings.push_back(
        {bounce, is_light ? "direct" : "point", blame->task, blame->promise, blame->text});
  }
}

}  // namespace view
