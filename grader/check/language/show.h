#pragma once

#include "pt/geometry/box.h"
#include "pt/geometry/hit.h"
#include "pt/geometry/ray.h"
#include "pt/geometry/sphere.h"
#include "pt/geometry/surface_point.h"
#include "pt/geometry/triangle.h"
#include "pt/math/rgb.h"
#include "pt/math/vec3.h"
#include "pt/scene/camera.h"

#include <array>
#include <ostream>
#include <string>

// Writes inputs and answers for people. Each number has just as many digits as are needed to read
// it back exactly.

namespace grader::check {

std::string show(double value);
std::string show(pt::Vec2 v);
std::string show(pt::Vec3 v);
std::string show(pt::Rgb c);
std::string show(const pt::Ray& ray);
std::string show(const pt::Triangle& triangle);
std::string show(const pt::Sphere& sphere);
std::string show(const pt::Box& box);
std::string show(const pt::SurfaceHit& hit);
std::string show(const pt::SurfacePoint& point);
std::string show(const pt::Camera& camera);

// The same, rounded to five digits. For answers and scenes that people read and do not run again.
std::string brief(double value);
std::string brief(pt::Vec3 v);
std::string brief(pt::Rgb c);

// The channels of an Rgb, in words.
inline constexpr std::array kChannels{"red", "green", "blue"};

// Writes each value on its own line.
template <class... Values>
void show_lines(std::ostream& out, const Values&... values) {
  const char* separator = "";
  ((out << separator << show(values), separator = "\n"), ...);
}

}  // namespace grader::check

// RapidCheck finds this function by the namespace of its argument.
namespace pt {

template <class T>
requires requires(const T& value) { grader::check::show(value); } && std::is_class_v<T>
void showValue(const T& value, std::ostream& out) { out << grader::check::show(value); }

}  // namespace pt
