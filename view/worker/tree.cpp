#include "view/worker/tree.h"

#include "pt/scene/recorder.h"
#include "pt/tasks/hit_box.h"
#include "view/worker/json.h"

#include <algorithm>

namespace view {

using nlohmann::json;

namespace {

constexpr std::size_t kMostNodes = 20000;  // that are drawn
constexpr std::size_t kMostTests = 1000;   // of a ray that are listed

double area(const pt::Box& box) {
  const pt::Vec3 e = box.extent();
  return 2 * (e.x * e.y + e.y * e.z + e.z * e.x);
}

// A node's distance from the root, or -1 if it is not below it, and whether it is a right child.
struct Place {
  int level = -1;
  bool is_right = false;
};

bool is_child(const pt::Bvh& bvh, int child, int parent) {
  return child > parent && child < static_cast<int>(bvh.nodes.size());
}

std::vector<Place> places_of(const pt::Bvh& bvh) {
  std::vector<Place> places(bvh.nodes.size());
  if (!places.empty()) places[0].level = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const pt::BvhNode& node = bvh.nodes[i];
    if (places[i].level < 0 || node.is_leaf()) continue;
    for (const int child : {node.left, node.right}) {
      if (!is_child(bvh, child, static_cast<int>(i))) continue;
      places[child] = {places[i].level + 1, child == node.right};
    }
  }
  return places;
}

bool is_same(const pt::Box& a, const pt::Box& b) { return a.min == b.min && a.max == b.max; }

// The nodes of boxes that were tested one after the other. Most are children of nodes that were tested before. -1: no node has the box.
std::vector<int> nodes_of(const pt::Bvh& bvh, const std::vector<pt::Box>& boxes) {
  std::vector<int> found, next{0};
  for (const pt::Box& box : boxes) {
    const auto has_box = [&](int node) { return is_same(bvh.nodes[node].box, box); };
    auto near = std::ranges::find_if(next, has_box);
    int node = -1;
    if (near != next.end()) {
      node = *near;
      next.erase(near);
    } else {
      for (int i = 0; node < 0 && i < static_cast<int>(bvh.nodes.size()); ++i) {
        if (has_box(i)) node = i;
      }
    }
    found.push_back(node);
    if (node < 0 || bvh.nodes[node].is_leaf()) continue;
    for (const int child : {bvh.nodes[node].left, bvh.nodes[node].right}) {
      if (is_child(bvh, child, node)) next.push_back(child);
    }
  }
  return found;
}

bool was_tested(const pt::Tested& tested, const pt::Primitives& primitives, int i) {
  if (!primitives.is_triangle(i)) {
    return std::ranges::any_of(tested.spheres, [&](const pt::Sphere& sphere) {
      return sphere.center == primitives.sphere(i).center &&
             sphere.radius == primitives.sphere(i).radius;
    });
  }
  const pt::Triangle& one = primitives.triangle(i);
  return std::ranges::any_of(tested.triangles, [&](const pt::Triangle& triangle) {
    return triangle.p0 == one.p0 && triangle.p1 == one.p1 && triangle.p2 == one.p2;
  });
}

// Lists the tests of this thread while it exists.
class Listing {
 public:
  explicit Listing(pt::Tested& tested) { pt::recorder.tested = &tested; }
  ~Listing() { pt::recorder.tested = nullptr; }
  Listing(const Listing&) = delete;
  Listing& operator=(const Listing&) = delete;
};

// The primitives of a leaf that were tested, each with its t, or none.
json primitives_of(const pt::Scene& scene, const pt::BvhNode& leaf, const pt::Tested& tested,
                   const pt::Ray& ray) {
  const pt::Bvh& bvh = scene.tracer.bvh();
  json all = json::array();
  for (int k = leaf.first; k < leaf.first + leaf.count; ++k) {
    if (k < 0 || k >= static_cast<int>(bvh.order.size())) continue;
    const int i = bvh.order[k];
    if (i < 0 || i >= scene.primitives.size() || !was_tested(tested, scene.primitives, i)) continue;
    const auto hit = hit_primitive(scene.primitives, i, ray);
    all.push_back({i, hit ? to_json(hit->t) : json()});
  }
  return all;
}

}  // namespace

json tree_of(const pt::Bvh& bvh) {
  const std::vector<Place> places = places_of(bvh);
  json nodes = json::array();
  int depth = 0, leaves = 0, largest = 0;
  double boxes = 1, primitives = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (places[i].level < 0) continue;
    const pt::BvhNode& node = bvh.nodes[i];
    const double part = area(node.box) / area(bvh.nodes[0].box);
    depth = std::max(depth, places[i].level);
    if (node.is_leaf()) {
      ++leaves;
      largest = std::max(largest, node.count);
      primitives += part * node.count;
    } else {
      boxes += 2 * part;
    }
    if (nodes.size() < kMostNodes) {
      nodes.push_back({to_json(node.box.min), to_json(node.box.max), places[i].level,
                       static_cast<int>(places[i].is_right), node.is_leaf() ? node.count : 0});
    }
  }
  return {{"nodes", std::move(nodes)},
          {"count", bvh.nodes.size()},
          {"depth", depth},
          {"leaves", leaves},
          {"largest", largest},
          {"boxes", to_json(boxes)},
          {"primitives", to_json(primitives)}};
}

json tests_of(const pt::Scene& scene, const pt::Ray& ray) {
  const pt::Bvh& bvh = scene.tracer.bvh();
  pt::Tested tested;
  const std::optional<pt::Hit> hit = [&] {
    const Listing listing(tested);
    return scene.closest(ray);
  }();
  const std::size_t boxes = tested.boxes.size();
  tested.boxes.resize(std::min(boxes, kMostTests));
  const std::vector<int> nodes = nodes_of(bvh, tested.boxes);
  const std::vector<Place> places = places_of(bvh);
  json tests = json::array();
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    const pt::Box& box = tested.boxes[k];
    const auto in = hit_box(box, ray);
    json test{{"low", to_json(box.min)}, {"high", to_json(box.max)}, {"node", nodes[k]}};
    test["opened"] = false;
    test["t"] = in ? json{to_json(in->min), to_json(in->max)} : json();
    if (nodes[k] >= 0) {
      const pt::BvhNode& node = bvh.nodes[nodes[k]];
      test["level"] = places[nodes[k]].level;
      if (node.is_leaf()) test["primitives"] = primitives_of(scene, node, tested, ray);
      test["opened"] =
          node.is_leaf() ? !test["primitives"].empty() : std::ranges::any_of(nodes, [&](int other) {
            return other == node.left || other == node.right;
          });
    }
    tests.push_back(std::move(test));
  }
  return {{"origin", to_json(ray.origin)},
          {"direction", to_json(ray.direction)},
          {"t", hit ? to_json(hit->t) : json()},
          {"primitive", hit ? hit->primitive : -1},
          {"tests", std::move(tests)},
          {"boxes", boxes},
          {"primitives", tested.triangles.size() + tested.spheres.size()},
          {"all", scene.primitives.size()}};
}

}  // namespace view
