#include "pt/sampling/sampler.h"
#include "site/live/exchange.h"

namespace site::live {

extern "C" {

// Number of bars, their heights, samples, seed -> for each sample x in [0, 1), chosen with a density as high as the bars, and the
// sample g(x) / p(x) of the integral of g(x) = x^2. Nothing if all bars are 0.
int live_density() {
  Given in;
  const int bars = in.whole();
  std::vector<double> up_to;  // the sum of the bars up to each
  double sum = 0;
  for (int i = 0; i < bars; ++i) up_to.push_back(sum += in.number());
  const int samples = in.whole();
  pt::Sampler sampler(static_cast<std::uint64_t>(in.whole()));
  begin();
  for (int i = 0; i < samples && sum > 0; ++i) {
    const pt::Vec2 xi = sampler.next_2d();
    std::size_t bar = 0;
    while (!(xi.x * sum < up_to[bar])) ++bar;
    const double height = up_to[bar] - (bar > 0 ? up_to[bar - 1] : 0);
    const double x = (static_cast<double>(bar) + xi.y) / bars;
    add(x);
    add(x * x / (height / sum * bars));
  }
  return count();
}
}

}  // namespace site::live
