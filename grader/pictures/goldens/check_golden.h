#pragma once

#include "grader/pictures/recipes/recipes.h"
#include "pt/image/film.h"

#include <filesystem>
#include <string>
#include <vector>

// Checks of goldens: a sentence for each fault.

namespace grader::pictures {

// Compares a picture with the radiance that theory gives for every pixel. It may be off by five
// standard errors on average, and by six and a half at one pixel.
std::vector<std::string> against_closed_form(const pt::Film& film, pt::Rgb radiance);

// Checks the golden of one recipe: its files exist, have the right size and enough samples, were made from the
// current recipe and scene, and agree with the closed form if there is one.
std::vector<std::string> check_golden(const Recipe& recipe, const std::filesystem::path& folder);

// Checks the goldens of all recipes, and names files in the folder that do not belong to a recipe.
std::vector<std::string> check_goldens(const std::vector<Recipe>& recipes,
                                       const std::filesystem::path& folder);

}  // namespace grader::pictures
