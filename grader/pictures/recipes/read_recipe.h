#pragma once

#include "grader/pictures/recipes/recipes.h"

#include <cstddef>
#include <filesystem>

#include <nlohmann/json_fwd.hpp>

namespace grader::pictures {

// Reads the entry with this number of the list in `file`. Throws pt::Error with its name, or its
// number if it has no name.
Recipe read_recipe(const nlohmann::json& json, const std::filesystem::path& file,
                   std::size_t number);

}  // namespace grader::pictures
