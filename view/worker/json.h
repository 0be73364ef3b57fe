#pragma once

#include "view/worker/path.h"

#include <nlohmann/json.hpp>

namespace view {

// Numbers that are not finite are texts: "nan", "inf", "-inf".
nlohmann::json to_json(double value);
nlohmann::json to_json(pt::Vec3 v);
nlohmann::json to_json(pt::Rgb color);

nlohmann::json to_json(const PixelPaths& pixel);
nlohmann::json to_json(const pt::Camera& camera);

}  // namespace view
