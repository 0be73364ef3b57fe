#include "pt/accel/wide_bvh.h"

#include "pt/accel/binary_tree.h"

#include <cassert>
#include <cmath>

namespace pt {

namespace {

bool is_usable(const Box& box) {
  return !box.is_empty() && is_finite(box.min) && is_finite(box.max);
}

// The frame in which the box is the cube [-1, 1]^3 or less, and no smaller than half of it.
WideFrame frame_of(const Box& box) {
  if (box.is_empty()) return {};
  const Vec3 center = 0.5 * box.min + 0.5 * box.max;
  const double half = std::max(max_abs(box.max - center), max_abs(box.min - center));
  int exponent = 0;
  std::frexp(half, &exponent);
  return {center, half > 0 ? std::ldexp(1.0, -exponent) : 1};
}

// A sphere that dwarfs all else (a ground that is one) would leave the rest no digits of single
// precision. It stays out of the tree, and every query asks it.
bool dwarfs(const Sphere& sphere, const Box& others) {
  return !others.is_empty() && sphere.radius > 32 * max_abs(others.extent());
}

// The box of all triangles.
Box bounds_of_triangles(const Primitives& primitives) {
  Box box;
  for (const Triangle& triangle : primitives.triangles) {
    const Box b = bounds(triangle);
    if (is_usable(b)) box.grow(b);
  }
  return box;
}

// The outward normal of a sphere; the corner normals by their weights.
Vec3 normal(const Primitives& primitives, int primitive, const Ray& ray, const ExactHit& hit) {
  if (!primitives.is_triangle(primitive)) {
    return normalize(ray.at(hit.t) - primitives.sphere(primitive).center);
  }
  const Triangle& t = primitives.triangle(primitive);
  return normalize(hit.b0 * t.n0 + hit.b1 * t.n1 + hit.b2 * t.n2);
}

FloatBox to_frame(const Box& box, const WideFrame& frame) {
  const Vec3 min = frame(box.min), max = frame(box.max);
  FloatBox result;
  for (int a = 0; a < 3; ++a) {
    result.min[a] = static_cast<float>(min[a]);
    result.max[a] = static_cast<float>(max[a]);
  }
  return result;
}

}  // namespace

WideBvh WideBvh::build(const Primitives& primitives, const Kernel& kernel) {
  WideBvh bvh;
  bvh.kernel_ = &kernel;
  const Box triangles = bounds_of_triangles(primitives);
  Box all = triangles;
  for (const Sphere& sphere : primitives.spheres) {
    if (!dwarfs(sphere, triangles) && is_usable(bounds(sphere))) all.grow(bounds(sphere));
  }
  bvh.frame_ = frame_of(all);

  std::vector<BoxedPrimitive> boxed;
  boxed.reserve(primitives.size());
  for (int i = 0; i < primitives.size(); ++i) {
    const auto index = static_cast<std::uint32_t>(i);
    const Box box = bounds(primitives, i);
    if (!is_usable(box)) continue;
    if (!primitives.is_triangle(i) && dwarfs(primitives.sphere(i), triangles)) {
      bvh.beside_.push_back(index);
    } else {
      boxed.push_back({to_frame(box, bvh.frame_), index});
    }
  }
  const BinaryTree binary = build_binary_tree(std::move(boxed), kBlock);
  if (kernel.width == 16) {
    bvh.tree_ = collapse<16>(binary, primitives, bvh.frame_);
  } else {
    bvh.tree_ = collapse<8>(binary, primitives, bvh.frame_);
  }
  return bvh;
}

WideView WideBvh::view(const Primitives& primitives) const {
  const auto make = [&](const auto& tree) {
    return WideView{tree.nodes.data(),
                    tree.blocks.data(),
                    tree.root,
                    frame_.center,
                    frame_.scale,
                    beside_.data(),
                    static_cast<std::uint32_t>(beside_.size()),
                    primitives.triangles.data(),
                    primitives.spheres.data(),
                    static_cast<std::uint32_t>(primitives.triangles.size())};
  };
  const auto* wide16 = std::get_if<WideTree<16>>(&tree_);
  return wide16 ? make(*wide16) : make(*std::get_if<WideTree<8>>(&tree_));
}

std::optional<Hit> WideBvh::closest(const Primitives& primitives, const Ray& ray) const {
  if (!kernel_) return std::nullopt;
  const WideHit found = kernel_->closest(view(primitives), ray);
  if (found.primitive == kNothing) return std::nullopt;
  const int primitive = static_cast<int>(found.primitive);
  return Hit{found.hit.t, normal(primitives, primitive, ray, found.hit), primitive};
}

bool WideBvh::occluded(const Primitives& primitives, const Ray& ray) const {
  return kernel_ && kernel_->occluded(view(primitives), ray);
}

std::uint32_t WideBvh::occluded(const Primitives& primitives, std::span<const Ray> rays) const {
  assert(rays.size() <= 32);
  if (!kernel_) return 0;
  return kernel_->occluded_batch(view(primitives), rays.data(), static_cast<int>(rays.size()));
}

std::size_t WideBvh::bytes() const {
  const auto count = [](const auto& tree) {
    return tree.nodes.size() * sizeof(tree.nodes[0]) + tree.blocks.size() * sizeof(tree.blocks[0]);
  };
  return std::visit(count, tree_) + beside_.size() * sizeof(beside_[0]);
}

}  // namespace pt
