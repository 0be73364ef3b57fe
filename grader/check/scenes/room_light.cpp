#include "grader/check/language/property.h"
#include "grader/check/scenes/channels.h"
#include "grader/check/scenes/rooms.h"

#include <vector>

// The light that leaves the point of a room, and the noise of a path tracer there.

namespace grader::check {

using pt::Rgb;

namespace {

// The light that a path finds from bounce k on, per place.
using Moments = std::vector<Rgb>;

Rgb expected_next(const Place& place, const Moments& next) {
  Rgb sum;
  for (std::size_t i = 0; i < next.size(); ++i) sum += place.leads[i] * next[i];
  return sum;
}

// The mean light after exactly one more bounce.
Moments one_bounce_more(const std::vector<Place>& places, const Moments& radiance) {
  Moments all;
  all.reserve(places.size());
  for (const Place& place : places) {
    all.push_back(place.albedo * expected_next(place, radiance));
  }
  return all;
}

template <class Visit>
void each_bounce(const Room& room, int from, int to, Visit visit) {
  Moments radiance;
  for (const Place& place : room.places) radiance.push_back(place.direct);
  for (int k = 1; k <= to; ++k) {
    if (k >= from) visit(k, radiance[0]);
    radiance = one_bounce_more(room.places, radiance);
  }
}

// The variance of one estimate of the direct light at any point of the place. Light without noise
// stays without noise.
Rgb variance_of_direct(const Place& place, int samples, const PathNoise& noise) {
  Rgb one = place.variance_of_a_sample;
  if (noise.most_of_direct > 0 && !is_black(one)) {
    const Rgb mean = squared(place.direct);
    const double factor = noise.most_of_direct * noise.most_of_direct;
    one = factor * larger(one, mean);
  }
  return place.variance + one / samples;
}

}  // namespace

Rgb Room::sum(int from, int to) const {
  Rgb sum;
  each_bounce(*this, from, to, [&](int, Rgb radiance) { sum += radiance; });
  return sum;
}

// Bounce k has k - 1 factors f, cos and pdf. The direct light has the same three factors once more.
double Room::precision(int from, int to) const {
  double sum = 0;
  each_bounce(*this, from, to,
              [&](int k, Rgb radiance) { sum += 4 * k * kColorPrecision * max_channel(radiance); });
  return sum;
}

// D is the direct light at a place, w the throughput of a bounce, and X' the light from the next
// bounce on. Then X = D + w X', and D does not depend on w X':
//   E X = E D + E w E X'    E X^2 = E D^2 + 2 E D E w E X' + E w^2 E X'^2
Rgb deviation(const Room& room, const pt::PathSettings& settings, const PathNoise& noise) {
  const std::size_t n = room.places.size();
  Moments mean(n), mean_square(n);
  for (int k = settings.to; k >= 1; --k) {
    const Moments later = mean, later_square = mean_square;
    const double survival = k == 1 ? 1 : noise.survival;
    for (std::size_t i = 0; i < n; ++i) {
      const Place& place = room.places[i];
      const Rgb rest = place.albedo * expected_next(place, later);
      mean[i] = rest;
      mean_square[i] = squared(place.albedo) * expected_next(place, later_square) *
                       (noise.mean_square / survival);
      if (k < settings.from) continue;
      mean[i] += place.direct;
      mean_square[i] += squared(place.direct) + 2 * place.direct * rest +
                        variance_of_direct(place, settings.light_samples, noise);
    }
  }
  return square_root(mean_square[0] - squared(mean[0]));
}

}  // namespace grader::check
