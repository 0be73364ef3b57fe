#pragma once

#include "grader/pictures/recipes.h"

#include <cstddef>
#include <filesystem>

#include <nlohmann/json_fwd.hpp>

namespace grader::pictures {

// One entry of the list in `file`, the number-th. Throws pt::Error with its name, or its number
// where it has none.
Recipe read_recipe(const nlohmann::json& json, const std::filesystem::path& file,
                   std::size_t number);

}  // namespace grader::pictures
