#pragma once

#include "pt/geometry/ray.h"
#include "pt/math/rgb.h"
#include "pt/math/vec3.h"

#include <cstddef>
#include <vector>

// Pages call the functions of this folder, each of which is named live_... and has C linkage. They have no arguments: the page writes
// numbers to numbers_in(), and reads as many from numbers_out() as the function returns. The same numbers in give the same numbers out.

namespace site::live {

inline std::vector<double> given, answer;

// Takes the given numbers one after another.
class Given {
 public:
  double number() { return given.at(next_++); }
  int whole() { return static_cast<int>(number()); }
  pt::Vec3 vector() {
    const double x = number(), y = number(), z = number();
    return {x, y, z};
  }
  // Origin, direction, t_min, t_max.
  pt::Ray ray() {
    pt::Ray ray;
    ray.origin = vector();
    ray.direction = vector();
    ray.t_min = number();
    ray.t_max = number();
    return ray;
  }

 private:
  std::size_t next_ = 0;
};

inline void begin() { answer.clear(); }
inline void add(double number) { answer.push_back(number); }
inline void add(pt::Vec3 v) { answer.insert(answer.end(), {v.x, v.y, v.z}); }
inline void add(pt::Rgb c) { answer.insert(answer.end(), {c.r, c.g, c.b}); }
inline int count() { return static_cast<int>(answer.size()); }

}  // namespace site::live
