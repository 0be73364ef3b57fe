// Arithmetic, random numbers and special functions.
#include <algorithm>
#include <bit>
#include <cfenv>
#include <cfloat>
#include <cmath>
#include <complex>
#include <cstdint>
#include <cstdlib>
#include <iterator>
#include <limits>
#include <numbers>
#include <numeric>
#include <random>
#include <ratio>
#include <vector>

namespace pt {

namespace {

double ask = 0.3;  // hidden from the compiler

template <class Number>
double functions() {
  const Number x = static_cast<Number>(ask);
  int exponent = 0, quotient = 0;
  Number whole = 0;
  const Number sum =
      std::sin(x) + std::cos(x) + std::tan(x) + std::asin(x) + std::acos(x) + std::atan2(x, x) +
      std::sinh(x) + std::cosh(x) + std::tanh(x) + std::asinh(x) + std::acosh(1 + x) +
      std::atanh(x) + std::exp(x) + std::exp2(x) + std::expm1(x) + std::log(x) + std::log2(x) +
      std::log10(x) + std::log1p(x) + std::pow(x, x) + std::sqrt(x) + std::cbrt(x) +
      std::hypot(x, x) + std::hypot(x, x, x) + std::erf(x) + std::erfc(x) + std::tgamma(x) +
      std::lgamma(x) + std::floor(x) + std::ceil(x) + std::trunc(x) + std::round(x) +
      std::nearbyint(x) + std::rint(x) + std::fmod(x, Number(2)) + std::remainder(x, Number(2)) +
      std::fma(x, x, x) + std::fdim(x, Number(1)) + std::fmax(x, Number(0)) + std::copysign(x, -x) +
      std::nextafter(x, Number(1)) + std::nexttoward(x, 1.0L) + std::frexp(x, &exponent) +
      std::ldexp(x, 2) + std::scalbn(x, 2) + std::logb(x) + std::modf(x, &whole) +
      std::remquo(x, Number(2), &quotient) + std::fabs(x);
  return double(sum) + double(std::lround(x) + std::llrint(x) + std::ilogb(x)) + std::isnan(x) +
         std::isfinite(x) + std::signbit(x) + std::fpclassify(x) + std::isnormal(x);
}

double special() {
  const double x = ask;
  return std::cyl_bessel_j(1, x) + std::cyl_neumann(1, x) + std::sph_bessel(2, x) +
         std::legendre(3, x) + std::assoc_legendre(3, 1, x) + std::sph_legendre(3, 1, x) +
         std::hermite(3, x) + std::laguerre(2, x) + std::beta(x, x) + std::ellint_1(x, x) +
         std::comp_ellint_2(x) + std::expint(x) + std::riemann_zeta(2 + x);
}

double complex_numbers() {
  const std::complex<double> z(ask, 1);
  const std::complex<float> f(0.5f, static_cast<float>(ask));
  const std::complex<double> w = std::exp(z) * std::log(z) / std::sqrt(z) + std::pow(z, 2.5) +
                                 std::sin(z) + std::polar(1., ask);
  return std::abs(w) + std::arg(z) + std::norm(z) + static_cast<double>(std::abs(f * f / f));
}

double random_numbers() {
  std::mt19937 small(7);
  std::seed_seq seeds{1, 2, 3};
  std::mt19937_64 engine(seeds);
  std::minstd_rand simple;
  std::ranlux48 luxury;
  double sum =
      std::uniform_real_distribution<double>(0, 1)(engine) +
      std::uniform_int_distribution<int>(1, 6)(small) + std::normal_distribution<float>()(engine) +
      std::exponential_distribution<>()(small) + std::poisson_distribution<>(3)(simple) +
      std::gamma_distribution<>(2, 1)(engine) + std::discrete_distribution<>{1, 2, 3}(engine) +
      std::bernoulli_distribution()(small) + std::geometric_distribution<>()(engine) +
      std::binomial_distribution<>()(engine) + std::generate_canonical<double, 53>(luxury) +
      std::cauchy_distribution<>()(engine);
  std::vector<int> order{1, 2, 3, 4, 5};
  std::shuffle(order.begin(), order.end(), engine);
  std::vector<int> two;
  std::sample(order.begin(), order.end(), std::back_inserter(two), 2, engine);
  std::random_device* unused = nullptr;  // the type may be named
  return sum + order[0] + static_cast<double>(two.size()) + (unused == nullptr);
}

double whole_numbers() {
  const auto x = static_cast<std::uint64_t>(ask * 1e19);
  __extension__ using Wide = unsigned __int128;
  const Wide wide = Wide(x) * x / 7 % 1000003;
  const auto bits = std::bit_cast<std::uint64_t>(ask);
  return static_cast<double>(wide) + std::popcount(x) + std::countl_zero(x) +
         static_cast<double>(std::bit_ceil(x >> 3) % 7 + std::rotl(bits, 3) % 5 +
                             std::gcd(x, bits)) +
         static_cast<double>(static_cast<long double>(x) * 3.5L) + std::abs(-3) +
         std::div(7, 2).rem + std::fegetround() + std::numbers::pi +
         std::numeric_limits<double>::epsilon() + static_cast<double>(static_cast<float>(wide)) +
         DBL_MAX / DBL_MAX;
}

}  // namespace

double task() {
  return functions<double>() + functions<float>() + functions<long double>() + special() +
         complex_numbers() + random_numbers() + whole_numbers();
}

}  // namespace pt
