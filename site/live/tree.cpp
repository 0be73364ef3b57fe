#include "pt/scene/recorder.h"
#include "pt/tasks/build_bvh.h"
#include "pt/tasks/hit_bvh.h"
#include "site/live/exchange.h"

namespace site::live {

namespace {

// Discs in the plane z = 0, in a picture of width 2 and height 1: spheres around points of the plane.
pt::Primitives discs(int count, int seed) {
  pt::Primitives all;
  pt::Sampler sampler(static_cast<std::uint64_t>(seed));
  for (int i = 0; i < count; ++i) {
    const pt::Vec2 xi = sampler.next_2d();
    const double radius = 0.012 + 0.028 * sampler.next_1d();
    all.spheres.push_back({{0.06 + 1.88 * xi.x, 0.06 + 0.88 * xi.y, 0}, radius});
  }
  return all;
}

pt::Bvh tree_of(const pt::Primitives& primitives, int max_leaf) {
  std::vector<pt::Box> boxes;
  for (int i = 0; i < primitives.size(); ++i) boxes.push_back(bounds(primitives, i));
  return pt::build_bvh(boxes, max_leaf);
}

void add_in_plane(const pt::Box& box) {
  for (const double each : {box.min.x, box.min.y, box.max.x, box.max.y}) add(each);
}

}  // namespace

extern "C" {

// Number of discs, seed, largest leaf -> number of nodes; for each disc x, y, radius; for each node its box in the plane, the two
// children and the number of discs in it, if it is a leaf.
int live_tree() {
  Given in;
  const int size = in.whole(), seed = in.whole();
  const pt::Primitives primitives = discs(size, seed);
  const pt::Bvh tree = tree_of(primitives, in.whole());
  begin();
  add(static_cast<double>(tree.nodes.size()));
  for (const pt::Sphere& disc : primitives.spheres)
    add(pt::Vec3{disc.center.x, disc.center.y, disc.radius});
  for (const pt::BvhNode& node : tree.nodes) {
    add_in_plane(node.box);
    for (const int each : {node.left, node.right, node.count}) add(each);
  }
  return count();
}

// The same and a ray -> the disc or -1, t, the number of discs that were tested; for each tested box its place in the plane.
int live_walk() {
  Given in;
  const int size = in.whole(), seed = in.whole();
  const pt::Primitives primitives = discs(size, seed);
  const pt::Bvh tree = tree_of(primitives, in.whole());
  pt::Tested tested;
  pt::recorder.tested = &tested;
  const std::optional<pt::Hit> hit = pt::hit_bvh(tree, primitives, in.ray());
  pt::recorder.tested = nullptr;
  begin();
  add(hit ? hit->primitive : -1);
  add(hit ? hit->t : 0);
  add(static_cast<double>(tested.spheres.size()));
  for (const pt::Box& box : tested.boxes) add_in_plane(box);
  return count();
}
}

}  // namespace site::live
