#pragma once

#include "writeup/figure.h"

#include <string>

#include <nlohmann/json.hpp>

// The exports of ./run view for one pixel, and drawings of them (draw_path.cpp, draw_ray.cpp).

namespace writeup {

// The export for a figure. The problems of `drawn` say what is not there, and then it cannot be used.
nlohmann::json exported(const Plan& plan, const Figure& figure, Drawn& drawn);

// A number of the export, where those that are not finite are texts; and how it is shown.
double value_in(const nlohmann::json& value);
std::string number_in(const nlohmann::json& value);

inline constexpr double kDrawingWidth = 480;
std::string svg(double height, const std::string& content);

}  // namespace writeup
