#include "collada_text.h"

#include <cmath>

namespace pt {
namespace {

const std::string kXfov60 =
    "<camera id=\"cam\"><optics><technique_common><perspective><xfov>60</xfov>"
    "<aspect_ratio>2</aspect_ratio><znear>.5</znear></perspective></technique_common></optics>"
    "</camera>";

LoadedScene load_with_camera(const std::string& camera, const std::string& nodes) {
  SceneText text;
  text.geometries = triangle_mesh();
  text.cameras = camera;
  text.nodes = node(instance("tri")) + nodes;
  return load(text);
}

TEST(FileCamera, has_the_nodes_frame_and_both_fields_of_view) {
  const LoadedScene loaded = load_with_camera(
      kXfov60, node("<translate>1 2 3</translate><rotate>0 1 0 90</rotate><scale>2 2 2</scale>"
                    "<instance_camera url=\"#cam\"/>"));
  ASSERT_TRUE(loaded.camera.has_value());
  expect_near(loaded.camera->position, {1, 2, 3});
  expect_near(loaded.camera->camera_to_world.x, {0, 0, -1});
  expect_near(loaded.camera->camera_to_world.y, {0, 1, 0});
  expect_near(loaded.camera->camera_to_world.z, {1, 0, 0});
  expect_near(loaded.camera->backwards, {2, 0, 0});
  EXPECT_EQ(loaded.camera->hfov_deg, 60);
  // tan 30 degrees is 1 / sqrt 3, and half of it spans 2 atan(1 / sqrt 12).
  EXPECT_NEAR(loaded.camera->vfov_deg, 2 * std::atan(1 / std::sqrt(12.0)) * 180 / kPi, 1e-12);
  EXPECT_EQ(loaded.camera->near_clip, 0.5);
  EXPECT_EQ(loaded.camera->far_clip, kInfinity);
}

TEST(FileCamera, states_its_fields_of_view_in_four_ways) {
  const auto fields = [](const std::string& perspective) {
    const LoadedScene loaded =
        load_with_camera("<camera id=\"cam\"><optics><technique_common><perspective>" +
                             perspective + "</perspective></technique_common></optics></camera>",
                         node("<instance_camera url=\"#cam\"/>"));
    return Vec2{loaded.camera.value().hfov_deg, loaded.camera.value().vfov_deg};
  };
  // 2 atan(3/4) is an angle whose half has tangent 3/4.
  const double wide = 2 * std::atan(0.75) * 180 / kPi;
  const std::string wide_text = "73.73979529168804";
  EXPECT_NEAR(fields("<xfov>90</xfov>").y, wide, 1e-12);
  EXPECT_NEAR(fields("<yfov>" + wide_text + "</yfov>").x, 90, 1e-12);
  EXPECT_NEAR(fields("<yfov>90</yfov><aspect_ratio>.75</aspect_ratio>").x, wide, 1e-12);
  EXPECT_EQ(fields("<xfov>70</xfov><yfov>20</yfov><aspect_ratio>9</aspect_ratio>").x, 70);
  EXPECT_EQ(fields("<xfov>70</xfov><yfov>20</yfov><aspect_ratio>9</aspect_ratio>").y, 20);
}

// SketchUp writes an aspect_ratio of 0.
TEST(FileCamera, that_states_what_cannot_be_keeps_the_rest) {
  const auto camera = [](const std::string& perspective) {
    return load_with_camera("<camera id=\"cam\"><optics><technique_common><perspective>" +
                                perspective + "</perspective></technique_common></optics></camera>",
                            node("<instance_camera url=\"#cam\"/>"));
  };
  for (const char* aspect : {"0", "-1"}) {
    const std::string ratio = std::string("<aspect_ratio>") + aspect + "</aspect_ratio>";
    LoadedScene loaded = camera("<xfov>90</xfov>" + ratio);
    EXPECT_NEAR(loaded.camera.value().vfov_deg, 2 * std::atan(0.75) * 180 / kPi, 1e-12);
    EXPECT_TRUE(has_note(loaded, "4:3 is taken"));
    loaded = camera("<xfov>90</xfov><yfov>10</yfov>" + ratio);
    EXPECT_EQ(loaded.camera.value().vfov_deg, 10);
  }
  for (const char* clips : {"<znear>2</znear><zfar>1</zfar>", "<znear>0</znear><zfar>0</zfar>",
                            "<znear>-1</znear><zfar>5</zfar>"}) {
    const LoadedScene loaded = camera(std::string("<xfov>90</xfov>") + clips);
    EXPECT_EQ(loaded.camera.value().near_clip, 0) << clips;
    EXPECT_EQ(loaded.camera.value().far_clip, kInfinity) << clips;
    EXPECT_TRUE(has_note(loaded, "it clips nothing")) << clips;
  }
}

TEST(FileCamera, is_the_last_one) {
  const std::string use = "<instance_camera url=\"#cam\"/>";
  const LoadedScene loaded =
      load_with_camera(kXfov60, node(use) + node("<translate>0 7 0</translate>" + use));
  expect_near(loaded.camera.value().position, {0, 7, 0});
  EXPECT_TRUE(has_note(loaded, "2 cameras"));
}

// The row 0 1 0 0 lacks a number, as in one of the course's files. This loses the meaning of y and
// of the rows below, but not the camera's viewing direction.
TEST(FileCamera, survives_a_matrix_of_15_numbers) {
  const LoadedScene loaded =
      load_with_camera(kXfov60, node("<matrix>-1 0 0 0 0 0 1 3 0 0 0 0 0 0 1</matrix>"
                                     "<instance_camera url=\"#cam\"/>"));
  expect_near(loaded.camera.value().camera_to_world.z, {0, 1, 0});
  EXPECT_TRUE(has_note(loaded, "15 numbers"));
  EXPECT_TRUE(has_note(loaded, "no up direction"));
}

}  // namespace
}  // namespace pt
