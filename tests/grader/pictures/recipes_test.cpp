#include "grader/pictures/recipes/recipes.h"

#include "grader/pictures/recipes/judge_recipe.h"
#include "pt/error.h"
#include "pt/file.h"
#include "pt/image/sample_map.h"
#include "tests/fixtures/pixels_depend_on.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

namespace grader::pictures {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;

const fs::path kRoot = FIRSTLIGHT_ROOT;

// A usable recipe with one part replaced.
const std::string kRecipe = R"({
  "name": "box", "title": "a box", "scene": "box_empty.dae", "camera": "file", "size": [8, 6],
  "bounces": [0, 2], "direct": "lights", "light_samples": 4, "survival": 0.5,
  "adaptive": {"max_samples": 64, "batch": 16, "tolerance": 0.1},
  "seed": 7, "tasks": ["trace_path", "hit_bvh"], "noisy": true, "most_noise": 12,
  "uniform": [1, 2, 3]
})";

std::string with(const std::string& old, const std::string& now) {
  std::string text = kRecipe;
  const std::size_t at = text.find(old);
  EXPECT_NE(at, std::string::npos) << old;
  return at == std::string::npos ? text : text.replace(at, old.size(), now);
}

class RecipeFile : public ::testing::Test {
 protected:
  void SetUp() override {
    fs::create_directories(folder_);
    fs::copy_file(kRoot / "scenes/box_empty.dae", folder_ / "box_empty.dae");
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::vector<Recipe> load(const std::string& recipes) {
    return load_text("{\"recipes\": [" + recipes + "]}");
  }

  std::vector<Recipe> load_text(const std::string& text) {
    pt::write_file(file_, text);
    return load_recipes(file_);
  }

  // The error message about a file with these recipes, without the file's path.
  std::string complaint(const std::string& recipes) {
    return complaint_about("{\"recipes\": [" + recipes + "]}");
  }

  std::string complaint_about(const std::string& text) {
    try {
      load_text(text);
    } catch (const pt::Error& error) {
      const std::string said = error.what();
      EXPECT_EQ(said.rfind(file_.string() + ":", 0), 0u) << said;
      return said.substr(file_.string().size());
    }
    ADD_FAILURE() << "no complaint about " << text;
    return {};
  }

  const fs::path folder_ = fs::temp_directory_path() / ("recipes_test." + std::to_string(getpid()));
  const fs::path file_ = folder_ / "recipes.json";
};

TEST_F(RecipeFile, says_all_that_a_picture_needs) {
  const Recipe recipe = load(kRecipe).at(0);
  EXPECT_EQ(recipe.name, "box");
  EXPECT_EQ(recipe.title, "a box");
  EXPECT_EQ(recipe.scene, folder_ / "box_empty.dae");
  EXPECT_EQ(recipe.width, 8);
  EXPECT_EQ(recipe.height, 6);
  EXPECT_EQ(recipe.settings.from, 0);
  EXPECT_EQ(recipe.settings.to, 2);
  EXPECT_EQ(recipe.settings.direct, pt::PathSettings::Direct::lights);
  EXPECT_EQ(recipe.settings.light_samples, 4);
  EXPECT_EQ(recipe.settings.survival, .5);
  EXPECT_FALSE(recipe.settings.show_normals);
  ASSERT_TRUE(recipe.adaptive);
  EXPECT_EQ(recipe.adaptive->max_samples, 64);
  EXPECT_EQ(recipe.adaptive->batch, 16);
  EXPECT_EQ(recipe.adaptive->tolerance, .1);
  EXPECT_EQ(recipe.seed, 7u);
  EXPECT_EQ(recipe.tasks, (std::vector<std::string>{"trace_path", "hit_bvh"}));
  EXPECT_TRUE(recipe.noisy);
  EXPECT_EQ(recipe.most_noise, 12);
  EXPECT_EQ(recipe.uniform, (pt::Rgb{1, 2, 3}));
}

TEST_F(RecipeFile, leaves_out_what_is_usual) {
  const Recipe recipe =
      load(R"({"name": "n", "title": "t", "scene": "box_empty.dae", "normals": true,
               "seed": 1, "tasks": ["hit_box"]})")
          .at(0);
  EXPECT_EQ(recipe.width, 96);
  EXPECT_EQ(recipe.height, 72);
  EXPECT_TRUE(recipe.settings.show_normals);
  EXPECT_EQ(recipe.framing, pt::Framing::file);
  EXPECT_FALSE(recipe.adaptive);
  EXPECT_FALSE(recipe.noisy);
  EXPECT_EQ(recipe.most_noise, 0);
  EXPECT_FALSE(recipe.uniform);
}

TEST_F(RecipeFile, that_is_no_json_is_refused_with_its_line) {
  const std::string said = complaint_about("{\n \"recipes\": [\n  {\"name\" \"box\"}\n ]\n}\n");
  EXPECT_THAT(said, AllOf(HasSubstr(":3: this is not JSON ("), HasSubstr("correct it")));
  EXPECT_THAT(complaint_about("{\n\n"), HasSubstr(":3: this is not JSON"));
  EXPECT_THAT(complaint_about("{\"recipes\": [1e999]}"), HasSubstr("write another number"));
  for (const char* text : {"[]", "{}", "{\"recipes\": []}", "{\"recipes\": 3}",
                           "{\"pictures\": []}", "{\"recipes\": [{}], \"more\": 1}"}) {
    EXPECT_THAT(complaint_about(text), HasSubstr("write one object, {\"recipes\": [...]}")) << text;
  }
}

struct Slip {
  std::string right, wrong, sentence;
};

TEST_F(RecipeFile, slips_are_named_with_the_recipe) {
  const std::vector<Slip> slips{
      {"\"name\": \"box\"", "\"name\": \"Box\"", "lower-case letters"},
      {"\"title\": \"a box\"", "\"title\": 3", "'title' must be a text"},
      {"\"title\": \"a box\",", "", "'title' is missing; add it"},
      {"box_empty.dae", "boxes.dae", "there is no scene"},
      {"\"camera\": \"file\"", "\"camera\": \"far\"", "one of course, file, fit, not \"far\""},
      {"[8, 6]", "[8]", "'size' must be a list of 2 numbers, not [8]"},
      {"[8, 6]", "[8, 0]", "'size' takes whole numbers from 1 to 1024, not 0"},
      {"[8, 6]", "[8, 6.5]", "not 6.5"},
      {"[0, 2]", "[2, 0]", "write the smaller first"},
      {"[0, 2]", "[0, -1]", "'bounces' takes whole numbers"},
      {"\"bounces\": [0, 2],", "", "'bounces' is missing; add it"},
      {"\"bounces\": [0, 2]", "\"normals\": 1", "'normals' must be true or false"},
      {"\"bounces\": [0, 2]", "\"normals\": true", "normals show no light: remove 'direct'"},
      {"\"lights\"", "\"light\"", "'direct' must be one of hemisphere, lights"},
      {"\"light_samples\": 4", "\"light_samples\": 0", "'light_samples' takes whole numbers"},
      {"\"survival\": 0.5", "\"survival\": 0",
       "'survival' must be a number above 0 and up to 1, not 0"},
      {"\"batch\": 16", "\"batch\": 65", "'adaptive': 'batch' takes whole numbers from 2 to 64"},
      {"\"batch\": 16,", "", "'adaptive': 'batch' is missing"},
      {"\"batch\": 16", "\"batch\": 16, \"n\": 1", "'adaptive': there is no field 'n' here"},
      {"\"tolerance\": 0.1", "\"tolerance\": \"0.1\"", "'tolerance' must be a number"},
      {"\"seed\": 7", "\"seed\": 0", "'seed' takes whole numbers from 1 to 2147483647, not 0"},
      {"\"seed\": 7", "\"seed\": 3000000000", "not 3000000000"},
      {"\"seed\": 7", "\"seed\": -4", "not -4"},
      {"\"seed\": 7", "\"seed\": 18446744073709551615", "not 18446744073709551615"},
      {"\"hit_bvh\"", "\"hit_tree\"", "there is no task 'hit_tree'; take some of estimate_pixel"},
      {"\"hit_bvh\"", "\"trace_path\"", "'tasks' names trace_path twice"},
      {"[\"trace_path\", \"hit_bvh\"]", "[]", "name at least one"},
      {"[1, 2, 3]", "[1, 2]", "'uniform' must be a list of 3 numbers"},
      {"[1, 2, 3]", "[1, 2, -3]", "none below zero"},
      {"\"noisy\"", "\"noise\"", "there is no field 'noise' here"},
  };
  for (const Slip& slip : slips) {
    const std::string said = complaint(with(slip.right, slip.wrong));
    EXPECT_THAT(said, HasSubstr(slip.sentence)) << slip.wrong;
    const std::string name = slip.wrong == "\"name\": \"Box\"" ? "Box" : "box";
    EXPECT_EQ(said.rfind(": recipe '" + name + "': ", 0), 0u) << said;
  }
  EXPECT_EQ(complaint("{}"), ": recipe number 1: 'name' is missing; add it");
  EXPECT_EQ(complaint(kRecipe + ", 3"), ": recipe number 2: write an object, {...}");
}

TEST_F(RecipeFile, names_and_seeds_are_used_once) {
  EXPECT_EQ(complaint(kRecipe + "," + kRecipe),
            ": recipe 'box': two recipes have this name; rename one");
  EXPECT_EQ(complaint(kRecipe + "," + with("\"box\"", "\"box_2\"")),
            ": recipe 'box_2': another recipe already has the seed 7; choose a new one");
  EXPECT_NO_THROW(load(
      kRecipe + "," +
      std::regex_replace(with("\"box\"", "\"box_2\""), std::regex("\"seed\": 7"), "\"seed\": 8")));
}

TEST_F(RecipeFile, recipes_are_found_by_name) {
  const std::vector<Recipe> recipes = load(kRecipe);
  EXPECT_EQ(&find(recipes, "box"), &recipes[0]);
  try {
    find(recipes, "bax");
    ADD_FAILURE();
  } catch (const pt::Error& error) {
    EXPECT_STREQ(error.what(), "there is no recipe 'bax'; choose one of box");
  }
}

TEST(Recipes, of_the_project_load_and_can_be_rendered) {
  const std::vector<Recipe> recipes = load_recipes(kRoot / "scenes/recipes.json");
  for (const Recipe& recipe : recipes) {
    const RecipeScene scene = load_scene(recipe, pt::Engine::linear);
    EXPECT_GT(scene.scene.primitives.size(), 0) << recipe.name;
    const pt::View taken = view(recipe, scene);
    EXPECT_EQ(&taken.scene, &scene.scene);
    EXPECT_EQ(taken.width, recipe.width);
    EXPECT_EQ(taken.height, recipe.height);
    EXPECT_EQ(taken.settings.to, recipe.settings.to);
  }
}

TEST(Recipes, judge_every_task_by_a_few_pictures) {
  std::map<std::string, int> pictures;
  for (const Recipe& recipe : load_recipes(kRoot / "scenes/recipes.json")) {
    for (const std::string& task : recipe.tasks) ++pictures[task];
  }
  for (const std::string& task : task_slugs()) {
    EXPECT_TRUE(fs::exists(kRoot / "pt/tasks" / (task + ".h"))) << task;
    if (pixels_depend_on(task)) {
      EXPECT_GE(pictures[task], 1) << task;
    }
  }
}

// Renders nothing: the first round of six runs is asked for, with random numbers of their own, and the
// first run's counts are the sample map.
TEST(judge_recipe, asks_for_six_runs_of_an_adaptive_picture) {
  const std::vector<Recipe> recipes = load_recipes(kRoot / "scenes/recipes.json");
  const Recipe& recipe = find(recipes, "adaptive_odd");
  std::map<std::uint64_t, int> rows_of_seeds;
  std::vector<std::uint64_t> seeds;
  const RowRenderer rows = [&](const pt::View&, const pt::RowsRequest& asked) {
    if (rows_of_seeds[asked.seed] == 0) seeds.push_back(asked.seed);
    rows_of_seeds[asked.seed] += asked.rows;
    const std::size_t pixels = static_cast<std::size_t>(asked.rows) * recipe.width;
    const int run = static_cast<int>(seeds.size());
    return pt::PictureRows{
        std::vector(pixels, pt::gray(run)), std::vector<int>(pixels, 16 * run), {}};
  };
  const fs::path folder = fs::temp_directory_path() / fmt::format("runs.{}", getpid());
  fs::create_directories(folder);
  const fs::path golden = kRoot / "golden" / recipe.name;
  const results::PictureResult result = judge_recipe(
      recipe, {rows, pt::Engine::linear, {"x", 1}, 1},
      {golden.string() + ".exr", golden.string() + "_rates.json", folder / "render.exr",
       folder / "evidence.exr", folder / "counts.csv", folder / "usual.csv"});
  EXPECT_EQ(result.samples, 6);
  EXPECT_EQ(seeds.size(), 6u);
  for (const auto& [seed, asked] : rows_of_seeds) EXPECT_EQ(asked, recipe.height);
  EXPECT_EQ(pt::read_counts(folder / "counts.csv").counts,
            std::vector<int>(static_cast<std::size_t>(recipe.width) * recipe.height, 16));
  fs::remove_all(folder);
}

}  // namespace
}  // namespace grader::pictures
