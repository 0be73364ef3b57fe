// right: from the leaves up. Of the clusters in Morton order, each one looks for the neighbour with which
// its box is smallest, and two that have found each other are merged (Meister and Bittner 2018, PLOC).
#include "pt/tasks/build_bvh.h"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

namespace pt {

namespace {

constexpr int kBits = 21, kReach = 8;

std::uint64_t morton_code(Vec3 p, const Box& around) {
  const Vec3 e = around.extent();
  const double size = std::max({e.x, e.y, e.z});
  std::uint64_t code = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double part = size > 0 ? (p[axis] - around.min[axis]) / size : 0;
    const auto place = static_cast<std::uint64_t>(part * ((1 << kBits) - 1));
    for (int bit = 0; bit < kBits; ++bit) code |= (place >> bit & 1) << (3 * bit + axis);
  }
  return code;
}

struct Cluster {
  Box box;
  int node = 0;
};

// Half of the surface of the box around both. Where that is nothing, the longest side decides.
double size_of(const Cluster& a, const Cluster& b) {
  Box both = a.box;
  both.grow(b.box);
  const Vec3 e = both.extent();
  return e.x * e.y + e.y * e.z + e.z * e.x;
}

int nearest(const std::vector<Cluster>& all, int i) {
  const int first = std::max(0, i - kReach), end = std::min<int>(std::ssize(all), i + kReach + 1);
  int best = i > 0 ? i - 1 : 1;
  double least = kInfinity;
  for (int k = first; k < end; ++k) {
    if (k == i) continue;
    // Of equal ones, a pair with an even first place: so many pairs find each other.
    const double size = size_of(all[i], all[k]);
    if (size < least || (size == least && k == (i ^ 1))) least = size, best = k;
  }
  return best;
}

}  // namespace

Bvh build_bvh(std::span<const Box> boxes, int max_leaf) {
  if (boxes.empty()) return {};
  Box centroids;
  for (const Box& box : boxes) centroids.grow(box.center());
  std::vector<std::uint64_t> codes;
  for (const Box& box : boxes) codes.push_back(morton_code(box.center(), centroids));
  std::vector<int> order(boxes.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, {}, [&](int i) { return codes[i]; });

  BvhBuilder tree(boxes);
  std::vector<Cluster> clusters;
  const auto most = static_cast<std::size_t>(std::min(max_leaf, 2));
  for (std::span<const int> left = order; !left.empty();) {
    const std::span<const int> some = left.first(std::min(most, left.size()));
    left = left.subspan(some.size());
    Cluster cluster{{}, tree.leaf(some)};
    for (const int i : some) cluster.box.grow(boxes[i]);
    clusters.push_back(cluster);
  }
  while (clusters.size() > 1) {
    const int n = static_cast<int>(clusters.size());
    std::vector<int> wish(clusters.size());
    for (int i = 0; i < n; ++i) wish[i] = nearest(clusters, i);
    std::vector<Cluster> next;
    for (int i = 0; i < n; ++i) {
      const int other = wish[i];
      if (wish[other] != i) {
        next.push_back(clusters[i]);
      } else if (i < other) {
        Cluster both{clusters[i].box, tree.inner(clusters[i].node, clusters[other].node)};
        both.box.grow(clusters[other].box);
        next.push_back(both);
      }
    }
    if (std::ssize(next) == n) {  // a ring of equal sizes: merge two all the same
      next[0].box.grow(next[1].box);
      next[0].node = tree.inner(next[0].node, next[1].node);
      next.erase(next.begin() + 1);
    }
    clusters = std::move(next);
  }
  return tree.finish(clusters[0].node);
}

}  // namespace pt
