// right: each sample has a row and a column of its own, in an order shuffled with whole numbers that
// are drawn by rejection, so that all are equally likely.
#include "pt/render/radiance.h"
#include "pt/tasks/camera_ray.h"
#include "pt/tasks/estimate_pixel.h"

#include <bit>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace pt {

namespace {

// A whole number below n: of so many bits as n needs, drawn until one is below n.
std::uint32_t below(std::uint32_t n, Sampler& sampler) {
  const int bits = std::bit_width(n - 1);
  for (;;) {
    const auto drawn =
        static_cast<std::uint32_t>(sampler.next_1d() * static_cast<double>(1u << bits));
    if (drawn < n) return drawn;
  }
}

std::vector<int> shuffled(int n, Sampler& sampler) {
  std::vector<int> order(static_cast<std::size_t>(n));
  std::iota(order.begin(), order.end(), 0);
  for (std::size_t i = order.size(); i > 1; --i) {
    std::swap(order[i - 1], order[below(static_cast<std::uint32_t>(i), sampler)]);
  }
  return order;
}

}  // namespace

Rgb estimate_pixel(const View& view, int x, int y, int samples, Sampler& sampler) {
  const std::vector<int> columns = shuffled(samples, sampler), rows = shuffled(samples, sampler);
  Rgb sum;
  for (int i = 0; i < samples; ++i) {
    const auto k = static_cast<std::size_t>(i);
    Vec2 at{0.5, 0.5};
    if (samples > 1) {
      const Vec2 xi = sampler.next_2d();
      at = {(columns[k] + xi.x) / samples, (rows[k] + xi.y) / samples};
    }
    const Ray ray = camera_ray(view.camera, (x + at.x) / view.width, (y + at.y) / view.height);
    sum += radiance(view.scene, ray, view.settings, sampler);
  }
  return sum / samples;
}

}  // namespace pt
