#pragma once

#include "grader/pictures/recipes.h"
#include "pt/image/film.h"

#include <filesystem>
#include <string>
#include <vector>

// Checks of goldens: a sentence for each fault.

namespace grader::pictures {

// Compares a picture with the radiance that theory gives for every pixel. It fails by more than
// five standard errors on average, or six and a half at one pixel.
std::vector<std::string> against_closed_form(const pt::Film& film, pt::Rgb radiance);

// Checks the golden of one recipe: its files are there, of the right size, with enough samples, made from the recipe
// and the scene as they are now, and agree with the closed form where there is one.
std::vector<std::string> check_golden(const Recipe& recipe, const std::filesystem::path& folder);

// Checks the goldens of all recipes, and names files in the folder that belong to no recipe.
std::vector<std::string> check_goldens(const std::vector<Recipe>& recipes,
                                       const std::filesystem::path& folder);

}  // namespace grader::pictures
