#include "pt/math/frame.h"
#include "pt/math/transform.h"
#include "pt/sampling/sampler.h"

#include <cmath>

#include <gtest/gtest.h>

namespace pt {
namespace {

// Normals in all directions, also near +-z, where older constructions lose their digits.
TEST(Frame, is_orthonormal_and_right_handed_for_every_normal) {
  Sampler sampler(1);
  for (int i = 0; i < 10000; ++i) {
    const double z = 2 * sampler.next_1d() - 1;
    const double phi = 2 * kPi * sampler.next_1d();
    const double tilt = i % 2 == 0 ? std::sqrt(1 - z * z) : std::pow(10, -12 * sampler.next_1d());
    const Vec3 n = normalize({tilt * std::cos(phi), tilt * std::sin(phi), z});
    const Frame frame = frame_from_normal(n);
    EXPECT_EQ(frame.z, n);
    EXPECT_NEAR(length(frame.x), 1, 1e-14);
    EXPECT_NEAR(length(frame.y), 1, 1e-14);
    EXPECT_NEAR(dot(frame.x, frame.y), 0, 1e-14);
    EXPECT_NEAR(length(cross(frame.x, frame.y) - n), 0, 1e-14);
  }
}

TEST(Frame, goes_there_and_back) {
  const Frame frame = frame_from_normal(normalize({1, -2, -3}));
  const Vec3 v{0.3, -0.7, 2};
  EXPECT_NEAR(length(frame.to_local(frame.to_world(v)) - v), 0, 1e-15);
  EXPECT_NEAR(length(frame.to_world({0, 0, 1}) - frame.z), 0, 1e-15);
}

// A normal must stay perpendicular to its surface and on the face's own side.
TEST(Transform, keeps_normals_perpendicular_also_when_it_mirrors) {
  for (const Transform& map : {Transform{{2, 1, 0}, {0, 3, 0}, {0, 1, .5}, {4, 5, 6}},
                               Transform{{-1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {}}}) {
    const Vec3 a{1, 2, 3}, b{-2, 1, 1};
    const Vec3 mapped = map.normal(cross(a, b));
    EXPECT_NEAR(dot(mapped, map.direction(a)), 0, 1e-12);
    EXPECT_NEAR(dot(mapped, map.direction(b)), 0, 1e-12);
    EXPECT_NEAR(length(mapped - cross(map.direction(a), map.direction(b))), 0, 1e-12);
  }
}

TEST(Transform, applies_the_right_factor_first) {
  const Transform move{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 2, 3}};
  const Transform stretch{{2, 0, 0}, {0, 2, 0}, {0, 0, 2}, {}};
  EXPECT_EQ((move * stretch).point({1, 1, 1}), (Vec3{3, 4, 5}));
  EXPECT_EQ((stretch * move).point({1, 1, 1}), (Vec3{4, 6, 8}));
}

// The first outputs of xoshiro256++ from the state 1, 2, 3, 4, as printed by its authors' C program
// (prng.di.unimi.it/xoshiro256plusplus.c). A number in [0, 1) uses the upper 53 bits.
TEST(Sampler, gives_the_published_outputs) {
  Sampler sampler(Sampler::State{1, 2, 3, 4});
  for (const std::uint64_t bits :
       {std::uint64_t{41943041}, std::uint64_t{58720359}, std::uint64_t{3588806011781223},
        std::uint64_t{3591011842654386}, std::uint64_t{9228616714210784205u},
        std::uint64_t{9973669472204895162u}, std::uint64_t{14011001112246962877u},
        std::uint64_t{12406186145184390807u}, std::uint64_t{15849039046786891736u},
        std::uint64_t{10450023813501588000u}}) {
    EXPECT_EQ(sampler.next_1d(), std::ldexp(static_cast<double>(bits >> 11), -53));
  }
}

// SplitMix64 from the seed 1477776061723855037 (prng.di.unimi.it/splitmix64.c) fills the state.
TEST(Sampler, fills_its_state_as_published) {
  EXPECT_EQ(Sampler(1477776061723855037u).state(),
            (Sampler::State{1985237415132408290u, 2979275885539914483u, 13511426838097143398u,
                            8488337342461049707u}));
}

TEST(Sampler, goes_on_from_its_state) {
  Sampler a(7);
  a.next_2d();
  Sampler b(a.state());
  EXPECT_EQ(a.next_1d(), b.next_1d());
}

TEST(Sampler, gives_every_pixel_its_own_numbers) {
  EXPECT_NE(Sampler::for_pixel(1, 2, 3).next_1d(), Sampler::for_pixel(1, 3, 2).next_1d());
  EXPECT_NE(Sampler::for_pixel(1, 2, 3).next_1d(), Sampler::for_pixel(2, 2, 3).next_1d());
  EXPECT_EQ(Sampler::for_pixel(1, 2, 3).next_1d(), Sampler::for_pixel(1, 2, 3).next_1d());
}

}  // namespace
}  // namespace pt
