#include "grader/pictures/statistics/flip.h"

#include "pt/image/tone_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

// Numbers without a name are those of the paper, and of the program of its authors.

namespace grader::pictures {

namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kPixelsPerDegree = 3840 * kPi / 180;

using Plane = std::vector<double>;
using Triple = std::array<double, 3>;

constexpr Triple kToXyz[] = {{10135552. / 24577794, 8788810. / 24577794, 4435075. / 24577794},
                             {2613072. / 12288897, 8788810. / 12288897, 887015. / 12288897},
                             {1425312. / 73733382, 8788810. / 73733382, 70074185. / 73733382}};
constexpr Triple kToRgb[] = {{3.241003275, -1.537398934, -.498615861},
                             {-.969224334, 1.875930071, .041554224},
                             {.055639423, -.204011202, 1.057148933}};

Triple times(const Triple (&m)[3], const Triple& v) {
  Triple out{};
  for (int i = 0; i < 3; ++i) out[i] = m[i][0] * v[0] + m[i][1] * v[1] + m[i][2] * v[2];
  return out;
}

const Triple kWhite = times(kToXyz, {1, 1, 1});

// The light of the screen: the picture is encoded by ./run render's power, and decoded by that of sRGB.
double shown(double linear) {
  const double code = linear > 0 ? std::pow(std::min(linear, 1.0), 1 / pt::kGamma) : 0;
  return code > .04045 ? std::pow((code + .055) / 1.055, 2.4) : code / 12.92;
}

// Y from 0 to 1, and the opponents Cx and Cz, in which the eye has other resolutions.
std::array<Plane, 3> opponents(const pt::Image& image) {
  std::array<Plane, 3> planes;
  for (const pt::Rgb& pixel : image.pixels) {
    const pt::Rgb c = is_finite(pixel) ? pixel : pt::Rgb{};
    const Triple xyz = times(kToXyz, {shown(c.r), shown(c.g), shown(c.b)});
    const double y = xyz[1] / kWhite[1];
    planes[0].push_back(y);
    planes[1].push_back(xyz[0] / kWhite[0] - y);
    planes[2].push_back(y - xyz[2] / kWhite[2]);
  }
  return planes;
}

// Weights of neighbours at distances in pixels: positive ones have the sum 1, negative ones -1.
Plane weights(double reach, const std::function<double(double)>& at) {
  Plane all;
  double above = 0, below = 1e-300;
  const int most = static_cast<int>(std::ceil(reach));
  for (int x = -most; x <= most; ++x) all.push_back(at(x));
  for (const double w : all) (w > 0 ? above : below) += std::abs(w);
  for (double& w : all) w /= w > 0 ? above : below;
  return all;
}

// The sums over neighbours in rows, then in columns. The picture goes on beyond its edges.
Plane filtered(const Plane& plane, int width, const Plane& across, const Plane& up) {
  const int height = static_cast<int>(plane.size()) / width;
  const auto sums = [&](const Plane& from, const Plane& w, int dx, int dy) {
    const int reach = static_cast<int>(w.size()) / 2;
    Plane to(from.size());
    for (int i = 0; i < width * height; ++i) {
      for (int k = -reach; k <= reach; ++k) {
        const int x = std::clamp(i % width + k * dx, 0, width - 1);
        const int y = std::clamp(i / width + k * dy, 0, height - 1);
        to[i] += w[k + reach] * from[y * width + x];
      }
    }
    return to;
  };
  return sums(sums(plane, across, 1, 0), up, 0, 1);
}

// Returns a plane as the eye still sees it: blurred by a sum of a sqrt(pi / b) exp(-pi^2 x^2 / b) for {a, b}; x in degrees.
Plane seen(const Plane& plane, int width, const std::vector<std::array<double, 2>>& terms) {
  const double reach = 3 * std::sqrt(.04 / 2) / kPi * kPixelsPerDegree;
  Plane sum(plane.size());
  double total = 0;
  for (const auto& [a, b] : terms) {
    const auto gaussian = [b = b](double x) {
      return std::exp(-std::pow(kPi * x / kPixelsPerDegree, 2) / b);
    };
    const Plane line = weights(reach, gaussian);
    // The middle weight of a normalised line is 1 / its sum.
    const double share = a * std::sqrt(kPi / b) / std::pow(line[line.size() / 2], 2);
    const Plane part = filtered(plane, width, line, line);
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += share * part[i];
    total += share;
  }
  for (double& value : sum) value /= total;
  return sum;
}

// L, and a and b, which count less where it is dark (Hunt's effect), of linear light.
Triple lab(const Triple& rgb) {
  Triple f = times(kToXyz, rgb);
  for (int i = 0; i < 3; ++i) {
    const double t = f[i] / kWhite[i], bend = 6. / 29;
    f[i] = t > bend * bend * bend ? std::cbrt(t) : t / (3 * bend * bend) + 4. / 29;
  }
  const double l = 116 * f[1] - 16;
  return {l, .01 * l * 500 * (f[0] - f[1]), .01 * l * 200 * (f[1] - f[2])};
}

double distance(const Triple& a, const Triple& b) {
  return std::pow(std::abs(a[0] - b[0]) + std::hypot(a[1] - b[1], a[2] - b[2]), .7);
}

std::vector<Triple> colors(const std::array<Plane, 3>& planes, int width) {
  const Plane y = seen(planes[0], width, {{1, .0047}}), cx = seen(planes[1], width, {{1, .0053}}),
              cz = seen(planes[2], width, {{34.1, .04}, {13.5, .025}});
  std::vector<Triple> all;
  for (std::size_t i = 0; i < y.size(); ++i) {
    Triple rgb =
        times(kToRgb, {kWhite[0] * (y[i] + cx[i]), kWhite[1] * y[i], kWhite[2] * (y[i] - cz[i])});
    for (double& channel : rgb) channel = std::clamp(channel, 0.0, 1.0);
    all.push_back(lab(rgb));
  }
  return all;
}

// Returns the strength of the edge, and that of the line or point, that each pixel is in.
std::array<Plane, 2> features(const Plane& y, int width) {
  const double deviation = .5 * .082 * kPixelsPerDegree;
  const auto bell = [&](double x) { return std::exp(-x * x / (2 * deviation * deviation)); };
  const auto edge = [&](double x) { return -x * bell(x); };
  const auto point = [&](double x) { return (x * x / (deviation * deviation) - 1) * bell(x); };
  const Plane line = weights(3 * deviation, bell);
  std::array<Plane, 2> all;
  for (int k = 0; k < 2; ++k) {
    const Plane slope = k == 0 ? weights(3 * deviation, edge) : weights(3 * deviation, point);
    const Plane across = filtered(y, width, slope, line), up = filtered(y, width, line, slope);
    for (std::size_t i = 0; i < y.size(); ++i) all[k].push_back(std::hypot(across[i], up[i]));
  }
  return all;
}

}  // namespace

double flip(const pt::Image& a, const pt::Image& b) {
  static const double most = distance(lab({0, 1, 0}), lab({0, 0, 1})), bend = .4 * most;
  const std::array<Plane, 3> planes_a = opponents(a), planes_b = opponents(b);
  const auto colors_a = colors(planes_a, a.width), colors_b = colors(planes_b, b.width);
  const auto features_a = features(planes_a[0], a.width),
             features_b = features(planes_b[0], b.width);
  double sum = 0;
  for (std::size_t i = 0; i < colors_a.size(); ++i) {
    const double off = distance(colors_a[i], colors_b[i]);
    const double color = off < bend ? off * .95 / bend : .95 + .05 * (off - bend) / (most - bend);
    const double feature = std::max(std::abs(features_a[0][i] - features_b[0][i]),
                                    std::abs(features_a[1][i] - features_b[1][i]));
    sum += std::pow(color, 1 - std::sqrt(feature / std::sqrt(2.0)));
  }
  return sum / static_cast<double>(colors_a.size());
}

}  // namespace grader::pictures
