#include "grader/check/exact.h"
#include "pt/tasks/hit_box.h"
#include "pt/tasks/hit_sphere.h"
#include "pt/tasks/hit_triangle.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

// The inputs on which the reference was furthest from exact arithmetic, as ./run stability --search found
// them (docs/stability.md). Other code, or the same with a remedy undone, is much worse there.

namespace pt::proof {
namespace {

using grader::check::Exact;
using grader::check::Exact3;
using grader::check::rounded;

struct AtTriangle {
  Triangle triangle;
  Ray ray;
};

const AtTriangle kTriangles[] = {
    {{{60.36557704191306, 16.907303134909295, 86.7046429643837},
      {60.51107366264933, 16.907303134909295, 86.70464296425112},
      {60.45469207750895, 17.052799755645562, 86.70464296439084},
      {0.11920168206223572, 0.005348818068494709, -0.9928556537275717},
      {0.1474469863216822, 0.020008580781398545, -0.9888675558029841},
      {0.16577652197889098, 0.00010707134365360897, -0.9861633400691338}},
     {{40.46881693900817, 67.08652250638627, 221.82626124785114},
      {1.969663447477527e-09, -4.940684746080715e-09, -1.3319526911998668e-08}}},
    {{{26615.23810762722, -24565.140665690138, 25715.301192179784},
      {26556.694148916682, -24579.567435268582, 25792.92976900444},
      {26609.044387250095, -24477.1663797113, 25770.816728596474},
      {0.37611401397327854, 0.9206314922772303, -0.10476594828620744},
      {-0.9230782950307216, -0.028603535159057333, -0.3835469971458267},
      {-0.9230782951673434, -0.028603534828020936, -0.383546996841708}},
     {{-2858.9812079657822, -41278.51693905998, 59814.65132793578},
      {4.227091999049988e-08, 2.4024713540476308e-08, -4.887508381612272e-08}}},
};

struct Meeting {
  Exact t = 0;
  Vec3 n;
};

Meeting meet(const AtTriangle& at) {
  const Triangle& triangle = at.triangle;
  const Exact3 p0 = triangle.p0, d = at.ray.direction;
  const Exact3 e1 = Exact3(triangle.p1) - p0, e2 = Exact3(triangle.p2) - p0;
  const Exact3 s = Exact3(at.ray.origin) - p0, h = cross(d, e2), q = cross(s, e1);
  const Exact determinant = dot(e1, h);
  const Exact b1 = dot(s, h) / determinant, b2 = dot(d, q) / determinant;
  const Exact3 n =
      (1 - b1 - b2) * Exact3(triangle.n0) + b1 * Exact3(triangle.n1) + b2 * Exact3(triangle.n2);
  return {dot(e2, q) / determinant, normalize(rounded(n))};
}

// A length: the contract's limit for a point.
double allowed(const AtTriangle& at, double t) {
  const Triangle& triangle = at.triangle;
  const double edge = length(triangle.p1 - triangle.p0), way = t * length(at.ray.direction);
  const Vec3 twice_area = geometric_normal(triangle);
  const double sine = std::abs(dot(normalize(twice_area), normalize(at.ray.direction)));
  const double thin = std::max(1.0, edge * edge / length(twice_area));
  return 1e-9 * std::max({max_abs(at.ray.at(t)), edge, way}) * thin / sine;
}

// The worst was a millionth of it; a thousandth leaves room for another compiler.
TEST(WorstInputs, triangles_keep_far_more_digits_than_promised) {
  for (const AtTriangle& at : kTriangles) {
    const Meeting right = meet(at);
    const auto hit = hit_triangle(at.triangle, at.ray);
    ASSERT_TRUE(hit);
    const double off = std::abs(rounded(Exact(hit->t) - right.t)) * length(at.ray.direction);
    EXPECT_LE(off, 1e-3 * allowed(at, hit->t));
    EXPECT_LE(length(hit->n - right.n), 1e-8);
  }
}

struct AtSphere {
  Sphere sphere;
  Ray ray;
};

// The distance in radii.
double off_the_sphere(const AtSphere& at, double t) {
  const Exact3 p =
      Exact3(at.ray.origin) + Exact(t) * Exact3(at.ray.direction) - Exact3(at.sphere.center);
  const Exact radius = at.sphere.radius;
  return std::abs(rounded((dot(p, p) - radius * radius) / (2 * radius * radius)));
}

// Spheres at most a thousand radii away.
const AtSphere kSpheres[] = {
    {{{-6565417.690410527, 11951187.386336766, -5682787.735812953}, 12009.695186021176},
     {{-18555048.959142637, 11558373.889895052, -5506672.828470255},
      {4.235627537092276e-08, 1.3877087836796897e-09, -6.221685509032903e-10}}},
    {{{-6565417.690410527, 11951187.386336766, -975951.9333196989}, 12009.695186021176},
     {{-18555048.959142637, 11558373.889895052, -799837.0259770015},
      {4.235627537092276e-08, 1.3877087836796897e-09, -6.221685509032903e-10}}},
};

TEST(WorstInputs, spheres_keep_far_more_digits_than_promised) {
  for (const AtSphere& at : kSpheres) {
    const auto hit = hit_sphere(at.sphere, at.ray);
    ASSERT_TRUE(hit);
    EXPECT_LE(off_the_sphere(at, hit->t), 1e-11);
  }
}

// Millions of radii away, where the textbook's discriminant has lost all digits.
const AtSphere kFarSpheres[] = {
    {{{218090.62301635748, -182760.97767448425, -21274.71237564091}, 31586.180302497676},
     {{-301808896413.0452, -22034221978.608856, -39173715220.09016},
      {0.9890925718993354, 0.07221022100311117, 0.12838056004021714}}},
};

TEST(WorstInputs, far_spheres_keep_the_promise) {
  for (const AtSphere& at : kFarSpheres) {
    const auto hit = hit_sphere(at.sphere, at.ray);
    ASSERT_TRUE(hit);
    EXPECT_LE(off_the_sphere(at, hit->t), 2e-8);
  }
}

struct AtBox {
  Box box;
  Ray ray;
};

// Rays exactly at an edge or a corner, with the shortest intervals that were found. Without the
// wider far planes (Ize 2013) they miss.
const AtBox kBoxes[] = {
    {{{-10.7688570022583, -233.5658473968506, 874.6993017196655},
      {-7.270764350891113, -227.7533187866211, 874.6993017196655}},
     {{-0.5831823348999023, -233.66873359680176, 864.5821657180786},
      {-10.185674667358398, 0.10288619995117188, 10.117136001586914}}},
    {{{-498408799.590991, 522240887.83771133, 466618869.9088154},
      {-498408799.590991, 522240889.4558754, 466618872.849617}},
     {{-498408782.39379597, 522240883.2267828, 466618881.2786102},
      {-17.197195053100586, 4.610928535461426, -11.369794845581055}}},
    {{{-3.5887041091918945, -1.4603242874145508, -0.871464729309082},
      {1.141714096069336, -1.4603242874145508, 1.591649055480957}},
     {{-13.575703620910645, 13.650209426879883, 0.15102100372314453},
      {9.98699951171875, -15.110533714294434, -1.0224857330322266}}},
    {{{-130064.28364562988, -81674.74041748047, 367527.5334186554},
      {-130059.63563251495, -81671.86996459961, 367529.9718389511}},
     {{-130074.10701560974, -81660.8562040329, 367528.9358224869},
      {12.14737606048584, -11.013760566711426, 1.0360164642333984}}},
};

TEST(WorstInputs, boxes_are_hit_at_their_edges) {
  for (const AtBox& at : kBoxes) {
    const auto hit = hit_box(at.box, at.ray);
    ASSERT_TRUE(hit);
    EXPECT_LE(hit->min, 1 + 1e-15);
    EXPECT_GE(hit->max, 1 - 1e-15);
  }
}

}  // namespace
}  // namespace pt::proof
