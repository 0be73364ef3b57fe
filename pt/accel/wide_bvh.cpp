#include "pt/accel/wide_bvh.h"

#include "pt/accel/binary_tree.h"
#include "pt/accel/collapse.h"

#include <cassert>
#include <cmath>
#include <variant>

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

// A sphere far larger than everything else (the ground, for example) would leave the rest no digits
// of single precision. It stays out of the tree, and every query tests it.
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

// The outward normal of a sphere, or the weighted corner normals of a triangle.
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

struct WideBvh::Tree {
  const Kernel& kernel;
  WideFrame frame;
  std::variant<WideTree<8>, WideTree<16>> wide;  // as the kernel is
  std::vector<std::uint32_t> beside;             // primitives too large for the frame
  WideView view{};                               // of the members above
};

namespace {

template <int W>
WideView view_of(const WideTree<W>& wide, const WideFrame& frame) {
  const Vec3 c = frame.center;
  return {wide.nodes.data(),
          wide.blocks.data(),
          wide.root,
          {c.x, c.y, c.z, 0},
          frame.scale,
          {},
          {},
          {},
          {}};
}

}  // namespace

WideBvh WideBvh::build(const Primitives& primitives, const Kernel& kernel) {
  const Box triangles = bounds_of_triangles(primitives);
  Box all = triangles;
  for (const Sphere& sphere : primitives.spheres) {
    if (!dwarfs(sphere, triangles) && is_usable(bounds(sphere))) all.grow(bounds(sphere));
  }
  const auto tree = std::make_shared<Tree>(Tree{kernel, frame_of(all), {}, {}});
  std::vector<BoxedPrimitive> boxed;
  boxed.reserve(primitives.size());
  for (int i = 0; i < primitives.size(); ++i) {
    const auto index = static_cast<std::uint32_t>(i);
    const Box box = bounds(primitives, i);
    if (!is_usable(box)) continue;
    if (!primitives.is_triangle(i) && dwarfs(primitives.sphere(i), triangles)) {
      tree->beside.push_back(index);
    } else {
      boxed.push_back({to_frame(box, tree->frame), index});
    }
  }
  const BinaryTree binary = build_binary_tree(std::move(boxed), kernel.width);
  if (kernel.width == 16) {
    const auto& wide = tree->wide.emplace<1>(collapse<16>(binary, primitives, tree->frame));
    tree->view = view_of(wide, tree->frame);
  } else {
    const auto& wide = tree->wide.emplace<0>(collapse<8>(binary, primitives, tree->frame));
    tree->view = view_of(wide, tree->frame);
  }
  tree->view.beside = tree->beside.data();
  tree->view.beside_count = static_cast<std::uint32_t>(tree->beside.size());
  tree->view.triangle_count = static_cast<std::uint32_t>(primitives.triangles.size());
  tree->view.has_spheres = primitives.spheres.size() > tree->beside.size();
  WideBvh bvh;
  bvh.tree_ = tree;
  return bvh;
}

WideQuery WideBvh::query(const Primitives& primitives) const {
  return {tree_->view, primitives.triangles.data(), primitives.spheres.data()};
}

std::optional<Hit> WideBvh::closest(const Primitives& primitives, const Ray& ray) const {
  if (!tree_) return std::nullopt;
  const WideHit found = tree_->kernel.closest(query(primitives), ray);
  if (found.primitive == kNothing) return std::nullopt;
  const int primitive = static_cast<int>(found.primitive);
  return Hit{found.hit.t, normal(primitives, primitive, ray, found.hit), primitive};
}

bool WideBvh::occluded(const Primitives& primitives, const Ray& ray) const {
  return tree_ && tree_->kernel.occluded(query(primitives), ray);
}

std::uint32_t WideBvh::occluded(const Primitives& primitives, std::span<const Ray> rays) const {
  assert(rays.size() <= 32);
  if (!tree_) return 0;
  return tree_->kernel.occluded_batch(query(primitives), rays.data(),
                                      static_cast<int>(rays.size()));
}

std::size_t WideBvh::bytes() const {
  if (!tree_) return 0;
  const auto count = [](const auto& tree) {
    return tree.nodes.size() * sizeof(tree.nodes[0]) + tree.blocks.size() * sizeof(tree.blocks[0]);
  };
  return std::visit(count, tree_->wide) + tree_->beside.size() * sizeof(tree_->beside[0]);
}

}  // namespace pt
