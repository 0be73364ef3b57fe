#pragma once

#include "pt/geometry/ray.h"
#include "pt/geometry/sphere.h"
#include "pt/geometry/triangle.h"

#if defined(__AVX2__) && defined(__FMA__)
#include <immintrin.h>
#endif

// Here the wide engine decides, in double precision, whether a ray meets a surface. Every hit that the
// engine finds in single precision is decided here, so its answers are the same as from testing
// every primitive in turn. Nothing here depends on the instruction set, so that all machines
// compute the same bits. Functions are internal, as this file is compiled for several sets.
//
// Coordinates, their differences and directions have to be zero or between 1e-75 and 1e75.

namespace pt {

// The decision: t, and for a triangle the weights of its corners (they sum to 1).
struct ExactHit {
  bool hit;
  double t;
  double b0;
  double b1;
  double b2;
};

namespace exact {

// The shear that maps the ray's direction to `axis`. This is the axis of the direction's largest
// component, so that all shears are at most 1.
struct Shear {
  int axis;
  int next;        // the axis after `axis`, in the order x y z x
  int last;        // the one after that
  double x;        // along `next`
  double y;        // along `last`
  double inverse;  // 1 / the direction's largest component; 0 where that is infinite
};

// They are not in the function, where g++ would copy them at each call.
constexpr int kNext[] = {1, 2, 0}, kLast[] = {2, 0, 1};

// No branch depends on the axis or on a sign: a processor could not foresee it.
static inline Shear shear_of(const Vec3& d) {
  const double x = __builtin_fabs(d.x), y = __builtin_fabs(d.y), z = __builtin_fabs(d.z);
  const int not_x = !((x >= y) & (x >= z)), not_y = !(y >= z);
  const int axis = not_x + (not_x & not_y);
  const int next = kNext[axis], last = kLast[axis];
  const double* components = &d.x;
  const double inverse = 1 / components[axis];
  return {axis, next, last, components[next] * inverse, components[last] * inverse, inverse};
}

// The weights of the corners p0, p1 and p2, not yet divided by their sum, and the corners'
// positions along the ray's axis.
struct Weights {
  bool inside;
  double w[3];
  double along[3];
};

// The triangle's plane, with n = (p1 - p0) x (p2 - p0): distance = n . (p0 - origin), det =
// n . direction, and `terms` is the sum of the sizes of the three products in `distance`.
struct Plane {
  double distance;
  double det;
  double terms;
};

static inline double magnitude(double a) { return __builtin_fabs(a); }

static inline bool in_range(double t, const Ray& ray) {
  return t >= ray.t_min && t <= ray.t_max && magnitude(t) < kInfinity;
}

#if defined(__AVX2__) && defined(__FMA__)

// The same as below, operation for operation, for all axes or for three corners at once.
static inline __m256d next_lanes(__m256d a) {  // y z x
  return _mm256_permute4x64_pd(a, _MM_SHUFFLE(3, 0, 2, 1));
}
static inline __m256d last_lanes(__m256d a) {  // z x y
  return _mm256_permute4x64_pd(a, _MM_SHUFFLE(3, 1, 0, 2));
}
static inline Plane plane(const Triangle& triangle, const Ray& ray) {
  const __m256d p = _mm256_loadu_pd(&triangle.p0.x);
  const __m256d a = _mm256_sub_pd(_mm256_loadu_pd(&triangle.p1.x), p);
  const __m256d b = _mm256_sub_pd(_mm256_loadu_pd(&triangle.p2.x), p);
  const __m256d c = _mm256_sub_pd(p, _mm256_loadu_pd(&ray.origin.x));
  const __m256d n = _mm256_sub_pd(_mm256_mul_pd(a, next_lanes(b)), _mm256_mul_pd(next_lanes(a), b));
  const __m256d terms = _mm256_mul_pd(n, last_lanes(c));  // in the order z x y
  const __m256d det_terms = _mm256_mul_pd(n, last_lanes(_mm256_loadu_pd(&ray.direction.x)));
  const __m256d zy = _mm256_unpacklo_pd(terms, det_terms);
  const __m128d x = _mm256_castpd256_pd128(_mm256_unpackhi_pd(terms, det_terms));
  const __m128d y = _mm256_extractf128_pd(zy, 1), z = _mm256_castpd256_pd128(zy);
  const __m128d sum = _mm_add_pd(_mm_add_pd(x, y), z);
  return {sum[0], sum[1], magnitude(x[0]) + magnitude(y[0]) + magnitude(z[0])};
}

static inline __m256d corners(const double* p) {
  const __m128d first = _mm_loadh_pd(_mm_load_sd(p), p + 3);
  return _mm256_insertf128_pd(_mm256_castpd128_pd256(first), _mm_load_sd(p + 6), 1);
}
static inline Weights weights(const Triangle& triangle, const Ray& ray, const Shear& s) {
  const double* p = &triangle.p0.x;
  const double* o = &ray.origin.x;
  const __m256d z = _mm256_sub_pd(corners(p + s.axis), _mm256_set1_pd(o[s.axis]));
  __m256d x = _mm256_sub_pd(corners(p + s.next), _mm256_set1_pd(o[s.next]));
  __m256d y = _mm256_sub_pd(corners(p + s.last), _mm256_set1_pd(o[s.last]));
  x = _mm256_sub_pd(x, _mm256_mul_pd(_mm256_set1_pd(s.x), z));
  y = _mm256_sub_pd(y, _mm256_mul_pd(_mm256_set1_pd(s.y), z));
  constexpr int kBefore = _MM_SHUFFLE(3, 1, 0, 2), kAfter = _MM_SHUFFLE(3, 0, 2, 1);
  const __m256d a = _mm256_permute4x64_pd(x, kBefore), b = _mm256_permute4x64_pd(y, kAfter);
  const __m256d c = _mm256_permute4x64_pd(y, kBefore), d = _mm256_permute4x64_pd(x, kAfter);
  const __m256d cd = _mm256_mul_pd(c, d);
  const __m256d rounding = _mm256_fnmadd_pd(c, d, cd);
  const __m256d w = _mm256_add_pd(_mm256_fmsub_pd(a, b, cd), rounding);
  const __m256d zero = _mm256_setzero_pd();
  const int positive = _mm256_movemask_pd(_mm256_cmp_pd(w, zero, _CMP_GE_OQ)) & 7;
  const int negative = _mm256_movemask_pd(_mm256_cmp_pd(w, zero, _CMP_LE_OQ)) & 7;
  const bool inside = (positive == 7) | (negative == 7);
  return {inside, {w[0], w[1], w[2]}, {z[0], z[1], z[2]}};
}

#else

static inline Plane plane(const Triangle& triangle, const Ray& ray) {
  const Vec3 &p = triangle.p0, &q = triangle.p1, &r = triangle.p2, &d = ray.direction;
  const double ax = q.x - p.x, ay = q.y - p.y, az = q.z - p.z;
  const double bx = r.x - p.x, by = r.y - p.y, bz = r.z - p.z;
  const double nx = ay * bz - az * by, ny = az * bx - ax * bz, nz = ax * by - ay * bx;
  const double x = nx * (p.x - ray.origin.x), y = ny * (p.y - ray.origin.y);
  const double z = nz * (p.z - ray.origin.z);
  const double det = nx * d.x + ny * d.y + nz * d.z;
  return {x + y + z, det, magnitude(x) + magnitude(y) + magnitude(z)};
}

// a b - c d with a relative error below two rounding errors. So its sign is right, and it is zero
// only if the exact value is (Kahan; Jeannerod, Louvet and Muller 2013, Further Analysis of Kahan's
// Algorithm for the Accurate Computation of 2 x 2 Determinants).
static inline double difference_of_products(double a, double b, double c, double d) {
  const double cd = c * d;
  const double rounding = __builtin_fma(-c, d, cd);
  return __builtin_fma(a, b, -cd) + rounding;
}

struct Sheared {
  double x;
  double y;
  double z;
};

static inline Sheared shear(Vec3 p, const Ray& ray, const Shear& s) {
  const double x = p.x - ray.origin.x;
  const double y = p.y - ray.origin.y;
  const double z = p.z - ray.origin.z;
  const double along = s.axis == 0 ? x : s.axis == 1 ? y : z;
  const double next = s.axis == 0 ? y : s.axis == 1 ? z : x;
  const double last = s.axis == 0 ? z : s.axis == 1 ? x : y;
  return {next - s.x * along, last - s.y * along, along};
}

static inline Weights weights(const Triangle& triangle, const Ray& ray, const Shear& s) {
  const Sheared a = shear(triangle.p0, ray, s);
  const Sheared b = shear(triangle.p1, ray, s);
  const Sheared c = shear(triangle.p2, ray, s);
  const double u = difference_of_products(c.x, b.y, c.y, b.x);
  const double v = difference_of_products(a.x, c.y, a.y, c.x);
  const double w = difference_of_products(b.x, a.y, b.y, a.x);
  const bool inside = ((u >= 0) & (v >= 0) & (w >= 0)) | ((u <= 0) & (v <= 0) & (w <= 0));
  return {inside, {u, v, w}, {a.z, b.z, c.z}};
}

#endif

// Returns whether the ray meets the triangle's plane so far outside its range that rounding does
// not matter: for example, it has just left this triangle or ends before it. Most decisions in a
// rendering are of this kind, and this is half the work. The margin is 2^13 rounding errors of the
// distance from the plane. (If det is only rounding error, and its sign may be wrong, a t in the
// range would be 2^12 times as far as the corner.)
static inline bool is_clearly_outside(const Triangle& triangle, const Ray& ray) {
  const Plane p = plane(triangle, ray);
  const double size = magnitude(p.det);
  const double t = __builtin_copysign(1.0, p.det) * p.distance;
  const double margin = 0x1p-40 * p.terms;
  return t < ray.t_min * size - margin || t > ray.t_max * size + margin;
}

// The triangle has no area: its geometric_normal is zero.
static inline bool is_degenerate(const Triangle& triangle) {
  const Vec3& p = triangle.p0;
  const double ax = triangle.p1.x - p.x, ay = triangle.p1.y - p.y, az = triangle.p1.z - p.z;
  const double bx = triangle.p2.x - p.x, by = triangle.p2.y - p.y, bz = triangle.p2.z - p.z;
  return ay * bz - az * by == 0 && az * bx - ax * bz == 0 && ax * by - ay * bx == 0;
}

// The answer for a triangle that has an area and for which is_clearly_outside is false.
static inline ExactHit meet(const Triangle& triangle, const Ray& ray) {
  const Shear shear = shear_of(ray.direction);
  const Weights q = weights(triangle, ray, shear);
  if (!(q.inside && shear.inverse != 0)) return {};
  const double sum = q.w[0] + q.w[1] + q.w[2];
  if (!(sum != 0)) return {};
  const double inverse = 1 / sum;
  const double b0 = q.w[0] * inverse, b1 = q.w[1] * inverse, b2 = q.w[2] * inverse;
  const double t = (b0 * q.along[0] + b1 * q.along[1] + b2 * q.along[2]) * shear.inverse;
  if (!in_range(t, ray)) return {};
  return {true, t, b0, b1, b2};
}

}  // namespace exact

// Woop, Benthin and Wald 2013 (Watertight Ray/Triangle Intersection, JCGT 2(1)): in the sheared
// space the ray is the third axis, and the corner weights are the areas that the corners span with
// the origin in the plane of the other two. A corner's image depends on the corner and the ray
// alone, and the sign of an area is exact, so two triangles that share an edge agree on which side
// of it the ray passes: none leaks. Edges and corners belong to the triangle.
//
// Each weight has a small relative error, and all have the same sign, so that t is a mean of the
// corners' own t. The answer is therefore right for a triangle whose corners are moved by at most
// 16 rounding errors (2^-53) of their largest distance from the origin, however thin it is and
// however flat the ray meets it. The engine's bounds are made for that.
static inline ExactHit exact_hit(const Triangle& triangle, const Ray& ray) {
  if (exact::is_clearly_outside(triangle, ray)) return {};
  const ExactHit hit = exact::meet(triangle, ray);
  return hit.hit && !exact::is_degenerate(triangle) ? hit : ExactHit{};
}

// The quadratic with the distance of the centre from the ray as discriminant, and the root that
// would cancel from the product of both (Haines et al. 2019, Ray Tracing Gems, chapter 7).
static inline ExactHit exact_hit(const Sphere& sphere, const Ray& ray) {
  const Vec3& d = ray.direction;
  const double x = sphere.center.x - ray.origin.x;
  const double y = sphere.center.y - ray.origin.y;
  const double z = sphere.center.z - ray.origin.z;
  const double radius_squared = sphere.radius * sphere.radius;
  const double a = d.x * d.x + d.y * d.y + d.z * d.z;
  const double b = x * d.x + y * d.y + z * d.z;
  const double c = x * x + y * y + z * z - radius_squared;
  const double s = b / a;
  const double px = x - s * d.x, py = y - s * d.y, pz = z - s * d.z;
  const double discriminant = a * (radius_squared - (px * px + py * py + pz * pz));
  if (!(discriminant >= 0)) return {};

  const double q = b + __builtin_copysign(__builtin_sqrt(discriminant), b);
  const double first = c / q, second = q / a;
  const double near = first < second ? first : second;
  const double far = first < second ? second : first;
  if (exact::in_range(near, ray)) return {true, near, 0, 0, 0};
  if (exact::in_range(far, ray)) return {true, far, 0, 0, 0};
  return {};
}

}  // namespace pt
