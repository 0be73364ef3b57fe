#include "grader/property/generators.h"

#include <cmath>

namespace grader {

namespace {

// An integer in [-2^19, 2^19], whatever RapidCheck's size is; shrinks towards 0.
rc::Gen<int> steps() {
  return rc::gen::resize(rc::kNominalSize, rc::gen::inRange(-(1 << 19), (1 << 19) + 1));
}

}  // namespace

rc::Gen<double> real(double low, double high) {
  return rc::gen::map(
      steps(), [=](int i) { return 0.5 * (low + high) + 0.5 * (high - low) * (i * 0x1p-19); });
}

rc::Gen<double> magnitude(double low, double high) {
  return rc::gen::map(real(std::log(low), std::log(high)), [](double x) { return std::exp(x); });
}

rc::Gen<pt::Vec3> point(double size) {
  return rc::gen::map(rc::gen::tuple(real(-size, size), real(-size, size), real(-size, size)),
                      [](const std::tuple<double, double, double>& p) {
                        return pt::Vec3{std::get<0>(p), std::get<1>(p), std::get<2>(p)};
                      });
}

rc::Gen<pt::Vec3> direction() {
  return rc::gen::map(rc::gen::pair(real(-1, 1), real(-pt::kPi, pt::kPi)),
                      [](const std::pair<double, double>& at) {
                        const double r = std::sqrt(1 - at.first * at.first);
                        return pt::Vec3{r * std::cos(at.second), r * std::sin(at.second), at.first};
                      });
}

rc::Gen<pt::Frame> rotation() {
  return rc::gen::map(rc::gen::pair(direction(), real(-pt::kPi, pt::kPi)),
                      [](const std::pair<pt::Vec3, double>& at) {
                        const pt::Frame f = pt::frame_from_normal(at.first);
                        const double c = std::cos(at.second), s = std::sin(at.second);
                        return pt::Frame{c * f.x + s * f.y, c * f.y - s * f.x, f.z};
                      });
}

rc::Gen<pt::Rgb> color(double low, double high) {
  return rc::gen::map(rc::gen::tuple(real(low, high), real(low, high), real(low, high)),
                      [](const std::tuple<double, double, double>& c) {
                        return pt::Rgb{std::get<0>(c), std::get<1>(c), std::get<2>(c)};
                      });
}

rc::Gen<std::uint64_t> sampler_seed() {
  return rc::gen::noShrink(rc::gen::resize(
      rc::kNominalSize, rc::gen::inRange<std::uint64_t>(0, std::uint64_t{1} << 40)));
}

}  // namespace grader
