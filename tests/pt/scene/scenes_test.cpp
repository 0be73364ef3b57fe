#include "pt/file.h"
#include "pt/scene/load_collada.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <set>
#include <sstream>
#include <string>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <tinyxml2.h>
#include <unistd.h>

namespace pt {
namespace {

namespace fs = std::filesystem;

const fs::path kScenes = FIRSTLIGHT_SCENES;
constexpr std::size_t kMaxBytes = 10'000'000;

std::vector<fs::path> scene_files() {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(kScenes)) {
    if (entry.path().extension() == ".dae") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::string text_of(const fs::path& file) { return read_file(file, kMaxBytes); }

std::vector<std::string> lines_of(const fs::path& file) {
  std::istringstream text(text_of(file));
  std::vector<std::string> lines;
  for (std::string line; std::getline(text, line);) lines.push_back(line);
  return lines;
}

// Returns the comment at the file's beginning, or an empty text.
std::string purpose(const std::string& text) {
  if (text.rfind("<!-- ", 0) != 0) return {};
  return text.substr(5, text.find(" -->") - 5);
}

// Runs the generator and returns its exit status.
int generate(const std::string& arguments) {
  const std::string command = std::string(FIRSTLIGHT_GENERATE) + " " + arguments;
  return WEXITSTATUS(std::system((command + " >/dev/null 2>&1").c_str()));
}

// This test's own folder, removed afterwards.
class Scenes : public ::testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder_); }
  void TearDown() override { fs::remove_all(folder_); }

  const fs::path folder_ = fs::temp_directory_path() / ("scenes_test." + std::to_string(getpid()));
};

TEST_F(Scenes, open_with_their_purpose_and_are_well_formed) {
  ASSERT_GE(scene_files().size(), 16u);
  for (const fs::path& file : scene_files()) {
    const std::string text = text_of(file);
    EXPECT_GT(purpose(text).size(), 40u) << file;
    EXPECT_EQ(purpose(text).find("--"), std::string::npos) << file;
    tinyxml2::XMLDocument document;
    EXPECT_EQ(document.Parse(text.data(), text.size()), tinyxml2::XML_SUCCESS) << file;
    std::set<std::string> ids;
    for (std::size_t at = text.find(" id=\""); at != std::string::npos;
         at = text.find(" id=\"", at + 1)) {
      const std::size_t start = at + 5;
      const std::string id = text.substr(start, text.find('"', start) - start);
      EXPECT_TRUE(ids.insert(id).second) << file << " has two elements called " << id;
    }
  }
}

TEST_F(Scenes, that_were_generated_are_generated_again_byte_for_byte) {
  int generated = 0;
  for (const fs::path& file : scene_files()) {
    const std::string comment = purpose(text_of(file));
    const std::string intro = "Made by: generate mesh ";
    const std::size_t start = comment.find(intro);
    if (start == std::string::npos) continue;
    ++generated;
    const fs::path again = folder_ / file.filename();
    ASSERT_EQ(generate(comment.substr(start + intro.size()) + " -o " + again.string()), 0) << file;
    EXPECT_TRUE(text_of(again) == text_of(file)) << file << " is not what its command makes";
  }
  EXPECT_EQ(generated, 4);
}

TEST_F(Scenes, are_not_generated_from_what_cannot_be_used) {
  const std::string file = (folder_ / "mesh.dae").string();
  EXPECT_NE(generate("-k blob -n 99 -o " + file), 0);
  EXPECT_NE(generate("-k bunny -n 1000 -o " + file), 0);
  EXPECT_NE(generate("-k blob -n 1000 -o " + file + "/is/no/folder"), 0);
  EXPECT_TRUE(fs::is_empty(folder_));
}

// The conditions on a scene: the model is complete, no surface gains energy, and the corner normals
// are on the side of the winding order, which is also the side of emission.
TEST_F(Scenes, load_as_the_model_has_them) {
  for (const fs::path& file : scene_files()) {
    const LoadedScene loaded = load_collada(file);
    EXPECT_NO_THROW(require_supported(loaded, file));
    EXPECT_TRUE(loaded.camera) << file;
    EXPECT_FALSE(loaded.scene.lights.empty()) << file;
    for (const Material& material : loaded.scene.materials) {
      EXPECT_LE(max_channel(material.albedo), .8) << file;
    }
    for (const Triangle& triangle : loaded.scene.primitives.triangles) {
      const Vec3 n = geometric_normal(triangle);
      ASSERT_GT(std::min({dot(n, triangle.n0), dot(n, triangle.n1), dot(n, triangle.n2)}), 0)
          << file;
    }
  }
}

// Each light node is the same light as the quad on which it is placed.
TEST_F(Scenes, have_no_light_twice) {
  for (const fs::path& file : scene_files()) {
    const std::string text = text_of(file);
    std::size_t nodes = 0;
    for (std::size_t at = text.find("<instance_light"); at != std::string::npos;
         at = text.find("<instance_light", at + 1)) {
      ++nodes;
    }
    EXPECT_EQ(load_collada(file).scene.lights.size(), std::max<std::size_t>(nodes, 1)) << file;
  }
}

TEST_F(Scenes, furnace_shines_inwards_everywhere) {
  const Scene scene = load_collada(kScenes / "furnace.dae").scene;
  const Vec3 middle = bounds(scene.primitives).center();
  ASSERT_EQ(scene.primitives.triangles.size(), 12u);
  double volume = 0;
  for (int i = 0; i < scene.primitives.size(); ++i) {
    const Triangle& triangle = scene.primitives.triangle(i);
    const double height = dot(geometric_normal(triangle), middle - triangle.p0);
    EXPECT_GT(height, 0);
    volume += height / 6;
    EXPECT_EQ(scene.materials[scene.material_of[i]].emission, gray(1));
    EXPECT_EQ(scene.materials[scene.material_of[i]].albedo, gray(.5));
  }
  // No wall is missing or doubled: the pyramids above them fill the room.
  EXPECT_NEAR(volume, 8, 1e-12);
}

double power(const RectangleLight& light) {
  return light.radiance.g * length(cross(light.u, light.v));
}

TEST_F(Scenes, large_and_tiny_light_are_one_scene_with_one_power) {
  const std::vector<std::string> large = lines_of(kScenes / "large_light.dae");
  const std::vector<std::string> tiny = lines_of(kScenes / "tiny_light.dae");
  ASSERT_EQ(large.size(), tiny.size());
  for (std::size_t i = 0; i < large.size(); ++i) {
    if (large[i] == tiny[i] || large[i].find("<COLLADA") == 0) continue;
    const bool of_the_light = large[i].find("<color>1 1 1<") != std::string::npos ||
                              large[i].find("<radiance>") != std::string::npos ||
                              large[i].find("<scale>") != std::string::npos;
    EXPECT_TRUE(i < 4 || of_the_light) << large[i];
  }
  const Scene large_scene = load_collada(kScenes / "large_light.dae").scene;
  const Scene tiny_scene = load_collada(kScenes / "tiny_light.dae").scene;
  const auto& large_light = std::get<RectangleLight>(large_scene.lights.at(0));
  const auto& tiny_light = std::get<RectangleLight>(tiny_scene.lights.at(0));
  EXPECT_NEAR(power(large_light), power(tiny_light), 1e-12);
  EXPECT_NEAR(tiny_light.radiance.g / large_light.radiance.g, 900, 1e-9);
}

TEST_F(Scenes, smooth_normals_differ_at_every_corner) {
  std::set<std::tuple<double, double, double>> normals;
  for (const Triangle& t :
       load_collada(kScenes / "smooth_normals.dae").scene.primitives.triangles) {
    for (Vec3 n : {t.n0, t.n1, t.n2}) normals.insert({n.x, n.y, n.z});
  }
  EXPECT_EQ(normals.size(), 9u);
}

}  // namespace
}  // namespace pt
