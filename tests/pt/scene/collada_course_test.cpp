// The course's own files, which are not part of this project. They are read from the folder
// FIRSTLIGHT_COURSE_SCENES, or by default from ../shared/scenes next to the source tree.
#include "collada_text.h"
#include "pt/error.h"
#include "pt/scene/frame_camera.h"

#include <cmath>
#include <cstdlib>

namespace pt {
namespace {

std::filesystem::path course_folder() {
  const char* named = std::getenv("FIRSTLIGHT_COURSE_SCENES");
  if (named != nullptr && *named != '\0') return named;
  return std::filesystem::path(FIRSTLIGHT_ROOT) / ".." / "shared" / "scenes";
}

// The names of the kinds of Light, in its order.
constexpr const char* kKinds[]{"rectangle", "sphere", "mesh", "point", "directional", "ambient"};

struct CourseFile {
  const char* path;
  std::size_t triangles;
  std::size_t spheres;
  std::vector<std::string> lights;
  std::vector<std::string> notes;  // each is part of some note
  const char* unsupported;         // a refused material, or null
  double eye_z;                    // of the course's framing; 0 if it is unknown
  Vec3 seen_from{};                // the course's direction to the eye, zero if it is unknown
};

const CourseFile kFiles[] = {
    {"sky/CBspheres_lambertian.dae",
     12,
     2,
     {"rectangle"},
     {"is replaced by 0.8 x 0 x 0.6."},
     nullptr,
     4.8023},
    {"sky/CBgems.dae", 252, 0, {"rectangle"}, {"15 numbers", "(glass)"}, "'ruby'", 4.8023},
    {"sky/CBcoil.dae",
     7884,
     0,
     {"rectangle"},
     {"colour 5 5 5 is replaced by the radiance 10 10 10"},
     "'coil'",
     4.8023},
    {"sky/CBbunny.dae",
     28588,
     0,
     {"rectangle"},
     {"is replaced by 0.8 x 0 x 0.6."},
     nullptr,
     -4.8023},
    {"sky/CBempty.dae", 12, 0, {"rectangle"}, {"the point light is left out"}, nullptr, 4.8023},
    {"sky/CBspheres.dae", 12, 2, {"rectangle"}, {"(mirror)", "(glass)"}, "'refract'", 4.8023},
    {"sky/bunny.dae", 33696, 0, {"ambient"}, {}, nullptr, 0, {0, .5, 1.5}},
    {"keenan/banana.dae",
     2458,
     0,
     {"ambient", "directional"},
     {"without a material (1, the first"},
     nullptr,
     0,
     {2.5 - .6830127, 1 - .2588191, 2.5 - .6830127}},
    {"meshedit/teapot.dae", 2464, 0, {"directional"}, {}, nullptr, 0},
    {"meshedit/cow.dae", 5856, 0, {"directional"}, {}, nullptr, 0},
    {"meshedit/maxplanck.dae", 50801, 0, {"directional"}, {}, nullptr, 0},
};

class CourseScene : public ::testing::TestWithParam<CourseFile> {
 protected:
  void SetUp() override {
    file_ = course_folder() / GetParam().path;
    if (!std::filesystem::exists(file_)) {
      GTEST_SKIP() << file_ << " is not here; set FIRSTLIGHT_COURSE_SCENES to its folder";
    }
  }

  std::filesystem::path file_;
};

TEST_P(CourseScene, has_its_surfaces_and_lights) {
  const CourseFile& expected = GetParam();
  const LoadedScene loaded = load_collada(file_);
  const Scene& scene = loaded.scene;
  EXPECT_EQ(scene.primitives.triangles.size(), expected.triangles);
  EXPECT_EQ(scene.primitives.spheres.size(), expected.spheres);
  EXPECT_EQ(scene.material_of.size(), expected.triangles + expected.spheres);
  std::vector<std::string> lights;
  for (const Light& light : scene.lights) lights.emplace_back(kKinds[light.index()]);
  EXPECT_EQ(lights, expected.lights);
  for (const std::string& note : expected.notes) EXPECT_TRUE(has_note(loaded, note)) << note;
  if (expected.unsupported != nullptr) {
    EXPECT_THROW(require_supported(loaded, file_), Error);
  } else {
    EXPECT_NO_THROW(require_supported(loaded, file_));
  }
  EXPECT_NO_THROW(require_supported(load_collada(file_, {.lambertian = true}), file_));
}

TEST_P(CourseScene, has_unit_normals) {
  const LoadedScene loaded = load_collada(file_);
  for (const Triangle& t : loaded.scene.primitives.triangles) {
    for (const Vec3 n : {t.n0, t.n1, t.n2}) ASSERT_NEAR(length(n), 1, 1e-15 * 4);
    ASSERT_GT(length(geometric_normal(t)), 0);
  }
}

// The panel of every box hangs under the ceiling, .8 x .6, and emits into the room.
TEST_P(CourseScene, is_lit_by_the_panel_under_its_ceiling) {
  const LoadedScene loaded = load_collada(file_);
  for (const Light& light : loaded.scene.lights) {
    const auto* panel = std::get_if<RectangleLight>(&light);
    if (panel == nullptr) continue;
    expect_near(panel->center, {0, 1.49, 0}, 0.0044);
    expect_near(panel->n, {0, -1, 0}, 1e-6);
    EXPECT_NEAR(std::abs(panel->u.x) + std::abs(panel->v.x), 0.8, 1e-6);
    EXPECT_NEAR(std::abs(panel->u.z) + std::abs(panel->v.z), 0.6, 1e-6);
    EXPECT_EQ(panel->radiance, gray(10));
  }
}

TEST_P(CourseScene, is_framed_as_in_the_courses_pictures) {
  const LoadedScene loaded = load_collada(file_);
  EXPECT_TRUE(loaded.camera.has_value());
  EXPECT_TRUE(loaded.exported);
  if (const Vec3 from = GetParam().seen_from; from != Vec3{}) {
    expect_near(frame_camera(loaded, Framing::course, 480, 360).camera_to_world.z, normalize(from),
                1e-6);
  }
  if (GetParam().eye_z == 0) return;
  const Camera camera = frame_camera(loaded, Framing::course, 480, 360);
  expect_near(camera.position, {0, 0.75, GetParam().eye_z}, 1e-4);
  EXPECT_NEAR(camera.hfov_deg, 30.68, 0.01);
  EXPECT_NEAR(camera.vfov_deg, 23.24, 0.01);
}

INSTANTIATE_TEST_SUITE_P(Files, CourseScene, ::testing::ValuesIn(kFiles), [](const auto& file) {
  return std::filesystem::path(file.param.path).stem().string();
});

}  // namespace
}  // namespace pt
