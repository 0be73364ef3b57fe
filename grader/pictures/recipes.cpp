#include "grader/pictures/recipes.h"

#include "grader/pictures/read_recipe.h"
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

// nlohmann's message starts with its own number and place; ours has the line in front.
nlohmann::json parse(const std::string& text, const std::filesystem::path& file) {
  try {
    return nlohmann::json::parse(text);
  } catch (const nlohmann::json::parse_error& error) {
    const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(error.byte, text.size()));
    const std::string message = error.what();
    const std::size_t reason = message.find("syntax error");
    throw pt::Error(fmt::format("{}:{}: this is not JSON ({}); mend it here or just before",
                                file.string(), 1 + std::count(text.begin(), end, '\n'),
                                reason == std::string::npos ? message : message.substr(reason)));
  } catch (const nlohmann::json::exception& error) {  // a number that no double holds
    throw pt::Error(fmt::format("{}: {}; write another number", file.string(), error.what()));
  }
}

void require_unique(const std::vector<Recipe>& recipes, const std::filesystem::path& file) {
  std::set<std::string> names;
  std::set<std::uint64_t> seeds;
  for (const Recipe& recipe : recipes) {
    const auto fail = [&](const std::string& what) {
      throw pt::Error(fmt::format("{}: recipe '{}': {}", file.string(), recipe.name, what));
    };
    if (!names.insert(recipe.name).second) fail("there are two of this name; rename one");
    if (!seeds.insert(recipe.seed).second) {
      fail(fmt::format("another recipe has the seed {} too; take one of its own", recipe.seed));
    }
  }
}

}  // namespace

std::vector<Recipe> load_recipes(const std::filesystem::path& file) {
  const nlohmann::json all = parse(pt::read_file(file, kMaxRecipeBytes), file);
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
      fmt::format("there is no recipe '{}'; take one of {}", name, fmt::join(names, ", ")));
}

}  // namespace grader::pictures
