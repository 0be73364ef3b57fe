#include "grader/mistakes/battery.h"

#include "grader/check/language/repeat.h"
#include "grader/mistakes/patches.h"
#include "grader/tasks/diffuse_bsdf/inputs.h"
#include "pt/tasks/diffuse_bsdf.h"

#include <cmath>

// The density of the samples is free, so the answers show only whether the samples and the pdf
// agree.

namespace grader::mistakes {
namespace {

using namespace check;
using namespace diffuse_bsdf_inputs;

void ask(Battery& battery, Rgb albedo, double out, double in) {
  battery.ask([&] { return numbers(pt::diffuse_f(albedo, at(out, 1), at(in, 3))); });
}

void values(Battery& battery) {
  for (const auto& [out, in] : kHeightsOfPairs) ask(battery, kAlbedo, out, in);
  ask(battery, {}, .5, .6);
  ask(battery, {5e-5, 3e-5, 2e-5}, .5, .6);
  ask(battery, kAlbedo, 1e-8, 1e-8);
}

// The integral of the pdf over one hemisphere. The sum is exact for a pdf that is linear in z.
void density(Battery& battery) {
  const std::vector<Vec3> directions = grid(12, 12);
  for (const double out : {0.9, 0.2, -0.6}) {
    for (const bool below : {false, true}) {
      battery.ask([&]() -> Battery::Numbers {
        double sum = 0;
        for (const Vec3 wi : directions) {
          sum += pt::diffuse_pdf(at(out, 0.4), below ? mirrored(wi) : wi);
        }
        return {sum * 2 * pt::kPi / static_cast<double>(directions.size())};
      });
    }
  }
}

// Asks whether the pdf sums to one in steps so small that some are below one degree.
void density_of_low_directions(Battery& battery) {
  constexpr int kSteps = 64;
  battery.ask([]() -> Battery::Numbers {
    double sum = 0;
    for (int i = 0; i < kSteps; ++i) {
      sum += pt::diffuse_pdf(at(.9, .4), at((i + 0.5) / kSteps, 3));
    }
    return {flag(std::abs(sum * 2 * pt::kPi / kSteps - 1) < 3e-4)};
  });
}

// Asks whether two samples of a black surface are the same.
void black_samples(Battery& battery) {
  battery.ask([]() -> Battery::Numbers {
    pt::Sampler sampler(5);
    const Vec3 first = pt::diffuse_sample({}, at(.9, .7), sampler).wi;
    return {flag(pt::diffuse_sample({}, at(.9, .7), sampler).wi == first)};
  });
}

// Returns, for each of some small parts of the hemisphere, cos(wi) / pdf if the sample is in it, else
// 0. With this weight, the means are the same for all densities.
Battery::Numbers places(const pt::BsdfSample& s) {
  const double z = s.wi.z, weight = s.pdf > 0 ? z / s.pdf : 0;
  const double degrees = std::atan2(s.wi.y, s.wi.x) * 180 / pt::kPi;
  const auto between = [](double low, double a, double high) { return flag(low < a && a < high); };
  return {weight * between(-18, degrees, 0),
          weight * flag(std::abs(degrees - std::round(degrees)) < 0.05),
          weight * between(0, z, 0.02),
          weight * between(0.0215, z, 0.0235),
          weight * between(0.03, z, 0.054),
          weight * flag(z > 1 - 1e-9)};
}

// Takes so many samples that some are less than one degree above the horizon.
void many_samples(Battery& battery) {
  const Vec3 wo = at(.6, .7);
  battery.mean(100000, [&](int n, std::uint64_t seed) {
    std::vector<Battery::Numbers> rows;
    for (const auto& sample : repeat<pt::diffuse_sample>(n, seed, kAlbedo, wo)) {
      rows.push_back(places(sample));
    }
    return rows;
  });
}

Battery::Numbers about(const pt::BsdfSample& s, Vec3 wo) {
  const Rgb f = pt::diffuse_f(kAlbedo, wo, s.wi);
  const double pdf = pt::diffuse_pdf(wo, s.wi), z = s.wi.z;
  const bool f_agrees = std::abs(s.f.r - f.r) + std::abs(s.f.b - f.b) < 1e-4 * (f.r + f.b + 1e-9);
  const bool pdf_agrees = std::abs(s.pdf - pdf) < 1e-4 * (pdf + 1e-9);
  const double over = s.pdf > 0 ? 1 / s.pdf : 0;
  return {s.f.r * std::abs(z) * over,
          s.f.b * std::abs(z) * over,
          std::abs(z) * over,
          z * z * over,
          z * s.wi.x * over,
          z * s.wi.y * over,
          z * s.wi.x * s.wi.x * over,
          flag(z > 0),
          flag(std::abs(length(s.wi) - 1) < 1e-4),
          flag(f_agrees),
          flag(pdf_agrees)};
}

void sampler(Battery& battery) {
  battery.ask([] {
    return use_of_sampler([](pt::Sampler& sampler) {
      return numbers(pt::diffuse_sample(kAlbedo, at(.9, .7), sampler).wi);
    });
  });
}

}  // namespace

void run_battery(Battery& battery) {
  values(battery);
  density(battery);
  sampler(battery);
  for (const double out : {0.9, 0.2}) {
    const Vec3 wo = at(out, 0.7);
    battery.mean(1500, [&](int n, std::uint64_t seed) {
      std::vector<Battery::Numbers> rows;
      for (const auto& sample : repeat<pt::diffuse_sample>(n, seed, kAlbedo, wo)) {
        rows.push_back(about(sample, wo));
      }
      return rows;
    });
  }
  density_of_low_directions(battery);
  black_samples(battery);
  many_samples(battery);
}

}  // namespace grader::mistakes
