#include "grader/pictures/recipes/recipes.h"

#include "grader/base/json_text.h"
#include "grader/pictures/recipes/read_recipe.h"
#include "pt/error.h"
#include "pt/file.h"

#include <algorithm>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

namespace grader::pictures {

namespace {

constexpr std::size_t kMaxRecipeBytes = 1 << 20;

void require_unique(const std::vector<Recipe>& recipes, const std::filesystem::path& file) {
  std::set<std::string> names;
  std::set<std::uint64_t> seeds;
  for (const Recipe& recipe : recipes) {
    const auto fail = [&](const std::string& what) {
      throw pt::Error(fmt::format("{}: recipe '{}': {}", file.string(), recipe.name, what));
    };
    if (!names.insert(recipe.name).second) fail("two recipes have this name; rename one");
    if (!seeds.insert(recipe.seed).second) {
      fail(fmt::format("another recipe already has the seed {}; choose a new one", recipe.seed));
    }
  }
}

}  // namespace

std::vector<Recipe> load_recipes(const std::filesystem::path& file) {
  const nlohmann::json all = base::parse_json(pt::read_file(file, kMaxRecipeBytes), file.string());
  if (!all.is_object() || all.size() != 1 || !all.contains("recipes") ||
      !all["recipes"].is_array() || all["recipes"].empty()) {
    throw pt::Error(file.string() + ": write one object, {\"recipes\": [...]}, with a list of " +
                    "recipes and nothing else");
  }
  std::vector<Recipe> recipes;
  for (const nlohmann::json& each : all["recipes"]) {
    recipes.push_back(read_recipe(each, file, recipes.size() + 1));
  }
  require_unique(recipes, file);
  return recipes;
}

const Recipe& find(const std::vector<Recipe>& recipes, const std::string& name) {
  std::vector<std::string> names;
  for (const Recipe& recipe : recipes) {
    if (recipe.name == name) return recipe;
    names.push_back(recipe.name);
  }
  throw pt::Error(
      fmt::format("there is no recipe '{}'; choose one of {}", name, fmt::join(names, ", ")));
}

}  // namespace grader::pictures
