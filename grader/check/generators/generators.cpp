#include "grader/check/generators/generators.h"

#include "grader/check/language/choices.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <vector>

namespace grader::check {

namespace {

Choices* chosen = nullptr;
bool is_simple = false;

}  // namespace

void choose_from(Choices* choices) { chosen = choices; }

void choose_simply(bool simply) { is_simple = simply; }

double next_choice(std::uint64_t random) {
  const double usual = static_cast<double>(random >> 11) * 0x1p-53;
  if (chosen == nullptr) return usual;
  if (chosen->taken == chosen->numbers.size()) chosen->numbers.push_back(usual);
  return chosen->numbers[chosen->taken++];
}

namespace {

// Returns one of the first values, half of the time the first.
template <class T>
T one_of_the_first(std::size_t count, const std::vector<T>& values, rc::Random random) {
  const std::uint64_t number = random.next();
  return number % 2 == 0 ? values[0] : values[number / 2 % std::min(count, values.size())];
}

// Makes a generator from two functions. `make` turns a random number into a value. `simpler` lists
// the values that are simpler than a value, the simplest first.
template <class Make, class Simpler>
auto shrinking(Make make, Simpler simpler) {
  using T = decltype(make(0.0));
  constexpr std::size_t kFirst = 2;  // the target, and a number of one digit
  return rc::Gen<T>([=](rc::Random random, int) {
    T value = make(next_choice(random.next()));
    if (is_simple) {
      if (const auto all = simpler(value); !all.empty())
        value = one_of_the_first(kFirst, all, random);
    }
    return rc::shrinkable::shrinkRecur(
        value, [=](const T& now) { return rc::seq::fromContainer(simpler(now)); });
  });
}

constexpr int kDigits = 4;  // how many roundings shrinking tries

double rounded(double x, double unit) {
  // Division by a whole number gives the double closest to a decimal; multiplication by 0.1 does
  // not.
  return unit < 1 ? std::round(x * std::round(1 / unit)) / std::round(1 / unit)
                  : std::round(x / unit) * unit;
}

// Lists roundings of x: first to multiples of `unit`, then with one more digit each time. If x
// itself is such a multiple, the list goes on with steps of that unit between `target` and x.
std::vector<double> simpler(double x, double target, double unit, double low, double high) {
  std::vector<double> all;
  if (x == target) return all;
  all.push_back(target);
  for (int digit = 0; digit < kDigits; ++digit, unit /= 10) {
    const double near = rounded(x, unit);
    if (near == x) {
      for (double step = std::trunc((x - target) / unit) / 2; std::abs(step) >= 0.5; step /= 2) {
        all.push_back(rounded(x - std::ceil(std::abs(step)) * std::copysign(unit, step), unit));
      }
      break;
    }
    all.push_back(near);
  }
  std::erase_if(all, [=](double y) { return !(y >= low && y <= high) || y == x; });
  return all;
}

double power_of_ten(double x) { return std::pow(10, std::floor(std::log10(x))); }

// Lists roundings of x to more and more leading digits. A power of ten goes to the next power of
// ten.
std::vector<double> simpler_magnitude(double x, double target, double low, double high) {
  std::vector<double> all;
  if (x == target) return all;
  all.push_back(target);
  const double power = power_of_ten(x);
  if (power == x) {
    const double next = target < x ? x / 10 : x * 10;
    if ((target < next) == (target < x)) all.push_back(next);
  } else {
    all.push_back(power);
    for (int digit = 0; digit < kDigits; ++digit) {
      const double near = rounded(x, power * std::pow(10, -digit));
      if (near == x) break;
      all.push_back(near);
    }
  }
  std::erase_if(all, [=](double y) { return !(y >= low && y <= high) || y == x; });
  return all;
}

constexpr std::size_t kAlongAxes = 6;

// Directions that are easy to read, the simplest first: those along an axis, and others.
const std::vector<pt::Vec3>& simple_directions() {
  static const std::vector<pt::Vec3> all = [] {
    std::vector<pt::Vec3> list{{0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {0, 0, -1}, {-1, 0, 0}, {0, -1, 0}};
    for (const pt::Vec3 v : {pt::Vec3{0.6, 0.8, 0}, pt::Vec3{0.48, 0.6, 0.64}}) {
      for (const double sx : {1.0, -1.0}) {
        for (const double sy : {1.0, -1.0}) {
          list.push_back({sx * v.x, sy * v.y, v.z});
          list.push_back({v.z, sx * v.x, sy * v.y});
          list.push_back({sy * v.y, v.z, sx * v.x});
        }
      }
    }
    return list;
  }();
  return all;
}

std::vector<pt::Vec3> simpler_direction(pt::Vec3 v) {
  const auto& simple = simple_directions();
  return {simple.begin(), std::find(simple.begin(), simple.end(), v)};
}

}  // namespace

rc::Gen<double> real(double low, double high) {
  const double unit = power_of_ten(high > low ? high - low : 1);
  const double middle = 0.5 * low + 0.5 * high, near = rounded(middle, unit);
  const double target = near >= low && near <= high ? near : middle;
  return shrinking([=](double xi) { return low + xi * (high - low); },
                   [=](double x) { return simpler(x, target, unit, low, high); });
}

rc::Gen<double> magnitude(double low, double high) {
  const double target = low <= 1 && 1 <= high ? 1 : std::sqrt(low * high);
  return shrinking([=](double xi) { return std::clamp(low * std::pow(high / low, xi), low, high); },
                   [=](double x) { return simpler_magnitude(x, target, low, high); });
}

rc::Gen<int> whole(int low, int high) {
  const rc::Gen<int> usual = rc::gen::resize(rc::kNominalSize, rc::gen::inRange(low, high + 1));
  return rc::Gen<int>([=](const rc::Random& random, int size) {
    if (is_simple && high > low) {
      const int most = std::min(high - low, 2);
      return rc::gen::resize(rc::kNominalSize, rc::gen::inRange(low, low + most + 1))(random, size);
    }
    if (chosen == nullptr) return usual(random, size);
    const double part = next_choice(rc::Random(random).next());
    return rc::shrinkable::just(low + static_cast<int>(part * (high - low + 1.0)));
  });
}

rc::Gen<pt::Vec3> point(double size) {
  return rc::gen::map(rc::gen::tuple(real(-size, size), real(-size, size), real(-size, size)),
                      [](const std::tuple<double, double, double>& p) {
                        return pt::Vec3{std::get<0>(p), std::get<1>(p), std::get<2>(p)};
                      });
}

rc::Gen<pt::Vec3> direction() {
  return rc::Gen<pt::Vec3>([](const rc::Random& random, int) {
    rc::Random first(random);
    rc::Random second = first.split();
    const double z = 2 * next_choice(first.next()) - 1;
    const double phi = 2 * pt::kPi * next_choice(second.next());
    const double r = std::sqrt(1 - z * z);
    const pt::Vec3 any{r * std::cos(phi), r * std::sin(phi), z};
    return rc::shrinkable::shrinkRecur(
        is_simple ? one_of_the_first(kAlongAxes, simple_directions(), second) : any,
        [](pt::Vec3 v) { return rc::seq::fromContainer(simpler_direction(v)); });
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

pt::Frame axis_frame(int number) {
  pt::Vec3 x, y;
  const int axis = number % 3, other = (axis + 1 + number / 3 % 2) % 3;
  x[axis] = number / 6 % 2 == 0 ? 1 : -1;
  y[other] = number / 12 == 0 ? 1 : -1;
  return {x, y, cross(x, y)};
}

rc::Gen<pt::Frame> rotation_of_axes() {
  return rc::gen::map(whole(0, kAxisFrames - 1), [](int number) {
    pt::Frame frame = axis_frame(number);
    frame.z += pt::Vec3{};  // the sum has no -0
    return frame;
  });
}

rc::Gen<pt::Rgb> color(double low, double high) {
  return rc::gen::map(rc::gen::tuple(real(low, high), real(low, high), real(low, high)),
                      [](const std::tuple<double, double, double>& c) {
                        return pt::Rgb{std::get<0>(c), std::get<1>(c), std::get<2>(c)};
                      });
}

rc::Gen<double> brightness() {
  return rc::gen::oneOf(magnitude(1e-4, 1e6), rc::gen::element(1e-4, 1e6));
}

rc::Gen<pt::Rgb> hue() {
  return rc::gen::map(whole(1, 7), [](int bits) {
    return pt::Rgb{1.0 * (bits & 1), 1.0 * (bits >> 1 & 1), 1.0 * (bits >> 2)};
  });
}

rc::Gen<std::uint64_t> sampler_seed() {
  return rc::gen::noShrink(rc::gen::resize(
      rc::kNominalSize, rc::gen::inRange<std::uint64_t>(0, std::uint64_t{1} << 40)));
}

}  // namespace grader::check
