#pragma once

#include "grader/pictures/recipes/recipes.h"
#include "pt/image/picture.h"

#include <filesystem>
#include <string>
#include <vector>

// Shows the goldens to a person: all in one picture, and in a table.

namespace grader::pictures {

inline constexpr const char* kSheetName = "contact_sheet.png";

// A picture of all goldens that exist, with their names below. The program bless writes it as kSheetName, beside the
// goldens.
pt::Picture contact_sheet(const std::vector<Recipe>& recipes, const std::filesystem::path& folder);

// Returns a table in Markdown, a row per recipe: its content, the tasks that it judges, the
// deviation of one sample, and the time of a first verdict.
std::string golden_table(const std::vector<Recipe>& recipes, const std::filesystem::path& folder);

}  // namespace grader::pictures
