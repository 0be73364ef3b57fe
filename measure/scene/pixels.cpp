#include "measure/scene/pixels.h"

#include "pt/sampling/sampler.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace measure::scene {

std::vector<PixelAt> spread_pixels(int width, int height, int wanted, std::uint64_t seed) {
  const double all = static_cast<double>(width) * height;
  const int side = std::max(1, static_cast<int>(std::floor(std::sqrt(all / wanted))));
  pt::Sampler sampler(seed);
  std::vector<PixelAt> pixels;
  for (int y = 0; y < height; y += side) {
    for (int x = 0; x < width; x += side) {
      const int across = std::min(side, width - x), up = std::min(side, height - y);
      const auto [u, v] = sampler.next_2d();
      pixels.push_back({x + static_cast<int>(u * across), y + static_cast<int>(v * up)});
    }
  }
  return pixels;
}

long long RenderedPixels::all_samples() const {
  return std::accumulate(samples.begin(), samples.end(), 0LL);
}

}  // namespace measure::scene
