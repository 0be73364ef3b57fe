#include "pt/scene/frame_camera.h"

#include "collada_text.h"

namespace pt {
namespace {

// A box of the course's size, 2 x 1.5 x 2, standing on the origin, and its camera.
LoadedScene box(double aspect) {
  LoadedScene loaded;
  loaded.is_course = true;
  loaded.scene.primitives.triangles = {flat_triangle({-1, 0, -1}, {1, 0, -1}, {1, 1.5, 1})};
  FileCamera camera;
  camera.position = {0, 0, 3};
  camera.hfov_deg = 49.13434;
  camera.vfov_deg = 2 * std::atan(std::tan(49.13434 / 2 * kPi / 180) / aspect) * 180 / kPi;
  camera.near_clip = 0.1;
  camera.far_clip = 100;
  loaded.camera = camera;
  return loaded;
}

// Both of the course's aspect ratios are widened to the same 4:3. The numbers are from its own
// pictures, to the last digits.
TEST(FrameCamera, frames_the_boxes_as_the_course_does) {
  for (const double aspect : {16.0 / 9, 4.0 / 3}) {
    const Camera camera = frame_camera(box(aspect), Framing::course, 480, 360);
    EXPECT_NEAR(camera.hfov_deg, 30.68, 0.01);
    EXPECT_NEAR(camera.vfov_deg, 23.24, 0.01);
    expect_near(camera.position, {0, 0.75, 1.5 * std::sqrt(4 + 2.25 + 4)});
    expect_near(camera.position, {0, 0.75, 4.8023}, 1e-4);
  }
}

TEST(FrameCamera, turns_with_the_files_camera_and_keeps_y_up) {
  LoadedScene loaded = box(4.0 / 3);
  // The camera looks along -x and is rolled: its y axis is the world's z.
  loaded.camera->camera_to_world = {{0, -1, 0}, {0, 0, 1}, {-1, 0, 0}};
  const Camera camera = frame_camera(loaded, Framing::course, 480, 360);
  expect_near(camera.position, {-1.5 * std::sqrt(10.25), 0.75, 0});
  expect_near(camera.camera_to_world.y, {0, 1, 0});
  expect_near(camera.camera_to_world.z, {-1, 0, 0});
  expect_near(camera.camera_to_world.x, {0, 0, 1});
}

// The course's bunny: the camera is at (0, .5, 2.5) and looks along -z. The course's program sees
// it from atan(.5 / 1.5), 18 degrees, above, for any length of the axis.
TEST(FrameCamera, adds_the_cameras_position_to_its_view_direction_as_the_course_does) {
  LoadedScene loaded = box(4.0 / 3);
  loaded.exported = true;
  loaded.camera->position = {0, 0.5, 2.5};
  loaded.camera->backwards = {0, 0, 1};
  const double distance = 1.5 * std::sqrt(10.25);
  Camera camera = frame_camera(loaded, Framing::course, 480, 360);
  expect_near(camera.position, Vec3{0, .75, 0} + distance / std::sqrt(10) * Vec3{0, 1, 3});
  expect_near(camera.camera_to_world.z, Vec3{0, 1, 3} / std::sqrt(10));
  expect_near(camera.camera_to_world.x, {1, 0, 0});
  loaded.camera->backwards = {0, 0, 2};
  camera = frame_camera(loaded, Framing::course, 480, 360);
  expect_near(camera.camera_to_world.z, Vec3{0, 1, 1} / std::sqrt(2));
  // An axis through the origin stays as it is.
  loaded.camera->position = {0, 0, 3};
  camera = frame_camera(loaded, Framing::course, 480, 360);
  expect_near(camera.camera_to_world.z, {0, 0, 1});
}

TEST(FrameCamera, keeps_to_the_cameras_axis_in_a_file_written_by_hand_and_in_other_framings) {
  LoadedScene loaded = box(4.0 / 3);
  loaded.camera->position = {0, 0.5, 2.5};
  expect_near(frame_camera(loaded, Framing::course, 480, 360).camera_to_world.z, {0, 0, 1});
  loaded.exported = true;
  expect_near(frame_camera(loaded, Framing::fit, 480, 360).camera_to_world.z, {0, 0, 1});
  expect_near(frame_camera(loaded, Framing::file, 480, 360).camera_to_world.z, {0, 0, 1});
}

// A position on the axis gives no direction; a position far above gives y.
TEST(FrameCamera, has_a_frame_wherever_the_camera_stands) {
  LoadedScene loaded = box(4.0 / 3);
  loaded.exported = true;
  loaded.camera->position = {0, 0, 1};
  expect_near(frame_camera(loaded, Framing::course, 480, 360).camera_to_world.z, {0, 0, 1});
  loaded.camera->position = {0, 7, 1};
  const Frame frame = frame_camera(loaded, Framing::course, 480, 360).camera_to_world;
  expect_near(frame.z, {0, 1, 0});
  expect_near(frame.x, {1, 0, 0});
  expect_near(frame.y, {0, 0, -1});
}

TEST(FrameCamera, widens_the_narrower_field_to_4_by_3) {
  LoadedScene loaded = box(4.0 / 3);
  loaded.camera->hfov_deg = 20;
  loaded.camera->vfov_deg = 90;
  // 800 x 600 is the whole field: tangents 4/3 and 1.
  const Camera camera = frame_camera(loaded, Framing::course, 800, 600);
  EXPECT_NEAR(camera.vfov_deg, 90, 1e-12);
  EXPECT_NEAR(camera.hfov_deg, 2 * std::atan(4.0 / 3) * 180 / kPi, 1e-12);
}

// The file's field is 90 x 2 atan(1/2), or 2:1. A square picture fits its width; a picture of 4:1
// fits its height.
TEST(FrameCamera, fit_shows_the_whole_field_with_square_pixels) {
  LoadedScene loaded = box(4.0 / 3);
  loaded.camera->hfov_deg = 90;
  loaded.camera->vfov_deg = 2 * std::atan(0.5) * 180 / kPi;
  const Camera square = frame_camera(loaded, Framing::fit, 100, 100);
  EXPECT_NEAR(square.hfov_deg, 90, 1e-12);
  EXPECT_NEAR(square.vfov_deg, 90, 1e-12);
  const Camera wide = frame_camera(loaded, Framing::fit, 400, 100);
  EXPECT_NEAR(wide.hfov_deg, 2 * std::atan(2) * 180 / kPi, 1e-12);
  EXPECT_NEAR(wide.vfov_deg, 2 * std::atan(0.5) * 180 / kPi, 1e-12);
  expect_near(wide.position, {0, 0.75, 1.5 * std::sqrt(10.25)});
}

// A floor has no side to be seen from the front, nor has a wall from its edge.
TEST(FrameCamera, fit_looks_at_a_flat_scene_from_above_its_plane) {
  LoadedScene loaded = box(4.0 / 3);
  loaded.camera.reset();
  auto& triangles = loaded.scene.primitives.triangles;
  triangles = {flat_triangle({-1, 2, -1}, {1, 2, -1}, {1, 2, 1})};
  expect_near(frame_camera(loaded, Framing::fit, 4, 3).camera_to_world.z,
              Vec3{0, 1, 1} / std::sqrt(2));
  triangles = {flat_triangle({2, -1, -1}, {2, 1, -1}, {2, 1, 1})};
  expect_near(frame_camera(loaded, Framing::fit, 4, 3).camera_to_world.z,
              Vec3{1, 0, 1} / std::sqrt(2));
  triangles = {flat_triangle({-1, -1, 2}, {1, -1, 2}, {1, 1, 2})};
  expect_near(frame_camera(loaded, Framing::fit, 4, 3).camera_to_world.z, {0, 0, 1});
}

TEST(FrameCamera, file_stays_where_the_file_puts_it) {
  LoadedScene loaded = box(4.0 / 3);
  const Camera camera = frame_camera(loaded, Framing::file, 480, 360);
  expect_near(camera.position, {0, 0, 3});
  EXPECT_EQ(camera.near_clip, 0.1);
  EXPECT_EQ(camera.far_clip, 100);
  EXPECT_NEAR(camera.hfov_deg, 49.13434, 1e-12);
  EXPECT_EQ(frame_camera(loaded, Framing::fit, 480, 360).far_clip, kInfinity);
}

TEST(FrameCamera, sees_a_scene_without_a_camera_from_the_front) {
  LoadedScene loaded = box(4.0 / 3);
  loaded.camera.reset();
  for (const Framing framing : {Framing::course, Framing::fit, Framing::file}) {
    const Camera camera = frame_camera(loaded, framing, 480, 360);
    expect_near(camera.position, {0, 0.75, 1.5 * std::sqrt(10.25)});
    EXPECT_NEAR(camera.hfov_deg, 49.13434, 1e-12);
  }
}

TEST(FrameCamera, leaves_the_cameras_of_other_programs_where_they_are) {
  LoadedScene loaded = box(4.0 / 3);
  loaded.is_course = false;
  loaded.exported = true;
  loaded.camera->position = {0, 0.5, 2.5};
  const Camera camera = frame_camera(loaded, Framing::course, 480, 360);
  expect_near(camera.position, {0, 0.5, 2.5});
  EXPECT_EQ(camera.far_clip, 100);
  EXPECT_NEAR(camera.hfov_deg, 49.13434, 1e-12);
  loaded.camera.reset();
  expect_near(frame_camera(loaded, Framing::course, 480, 360).camera_to_world.z, {0, 0, 1});
}

TEST(FrameCamera, sees_a_scene_without_a_camera_from_its_own_front) {
  LoadedScene loaded = box(4.0 / 3);
  loaded.camera.reset();
  loaded.front = {0, 0, -1};
  const Camera camera = frame_camera(loaded, Framing::course, 480, 360);
  expect_near(camera.position, {0, 0.75, -1.5 * std::sqrt(10.25)});
  expect_near(camera.camera_to_world.x, {-1, 0, 0});
  expect_near(camera.camera_to_world.y, {0, 1, 0});
}

// If the camera looks straight down, y cannot be up, so the file's own frame is kept.
TEST(FrameCamera, may_look_straight_down) {
  LoadedScene loaded = box(4.0 / 3);
  const Frame down{{1, 0, 0}, {0, 0, -1}, {0, 1, 0}};
  loaded.camera->camera_to_world = down;
  const Camera camera = frame_camera(loaded, Framing::course, 480, 360);
  expect_near(camera.camera_to_world.y, down.y);
  expect_near(camera.position, {0, 0.75 + 1.5 * std::sqrt(10.25), 0});
}

}  // namespace
}  // namespace pt
