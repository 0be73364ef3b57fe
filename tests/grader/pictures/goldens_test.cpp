#include "grader/pictures/goldens/check_golden.h"
#include "grader/pictures/goldens/provenance.h"
#include "pt/file.h"
#include "pt/image/image_io.h"

#include <cmath>
#include <filesystem>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

// The project's goldens, as they are in golden/.

namespace grader::pictures {
namespace {

namespace fs = std::filesystem;

const fs::path kRoot = FIRSTLIGHT_ROOT;

std::vector<Recipe> recipes() { return load_recipes(kRoot / "scenes/recipes.json"); }

TEST(Goldens, are_what_the_recipes_ask_for) {
  EXPECT_THAT(check_goldens(recipes(), kRoot / "golden"), testing::IsEmpty());
}

TEST(Goldens, are_small) {
  std::uintmax_t bytes = 0;
  for (const auto& entry : fs::directory_iterator(kRoot / "golden")) bytes += entry.file_size();
  EXPECT_LT(bytes, 20'000'000u);
}

TEST(Goldens, have_a_row_and_a_title_in_the_handbook_of_recipes) {
  const std::string page = pt::read_file(kRoot / "docs/recipes.md", 1 << 20);
  for (const Recipe& recipe : recipes()) {
    EXPECT_NE(page.find("| " + recipe.name), std::string::npos) << recipe.name;
    EXPECT_NE(page.find(recipe.title), std::string::npos) << recipe.name;
  }
}

// The radiance E (1 - a^(m + 1)) / (1 - a) in a closed room of emission E and albedo a, from the
// scene's own materials.
TEST(Goldens, of_the_furnace_are_its_closed_form) {
  const std::vector<Recipe> all = recipes();
  const Recipe& recipe = find(all, "global_furnace");
  const pt::Material wall = load_scene(recipe, pt::Engine::linear).scene.materials.at(0);
  ASSERT_TRUE(recipe.uniform);
  pt::Rgb truth;
  for (int c = 0; c < 3; ++c) {
    truth[c] = wall.emission[c] * (1 - std::pow(wall.albedo[c], recipe.settings.to + 1)) /
               (1 - wall.albedo[c]);
    EXPECT_NEAR((*recipe.uniform)[c], truth[c], 1e-12);
  }
  const fs::path film = golden_files(kRoot / "golden", recipe.name).film;
  EXPECT_THAT(against_closed_form(pt::read_exr(film), truth), testing::IsEmpty());
}

// A flat floor under the whole sky reflects albedo times radiance; more bounces add nothing.
TEST(Goldens, of_the_floor_are_albedo_times_sky) {
  const std::vector<Recipe> all = recipes();
  const Recipe& recipe = find(all, "global_floor_under_sky");
  const RecipeScene scene = load_scene(recipe, pt::Engine::linear);
  ASSERT_EQ(scene.scene.lights.size(), 1u);
  const pt::Rgb truth = scene.scene.materials.at(0).albedo *
                        std::get<pt::AmbientLight>(scene.scene.lights[0]).radiance;
  ASSERT_TRUE(recipe.uniform);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR((*recipe.uniform)[c], truth[c], 1e-12);
  const fs::path film = golden_files(kRoot / "golden", recipe.name).film;
  EXPECT_THAT(against_closed_form(pt::read_exr(film), truth), testing::IsEmpty());
}

}  // namespace
}  // namespace grader::pictures
