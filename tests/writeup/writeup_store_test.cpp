// The renders of the write-up: those that stay valid after a change, and the rows that exist.
#include "grader/tasks.h"
#include "pt/file.h"
#include "tests/fixtures/pixels_depend_on.h"
#include "tests/fixtures/temporary_folder.h"
#include "writeup/files.h"
#include "writeup/measurements.h"

#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace writeup {
namespace {

using Slugs = std::set<std::string>;

Slugs tasks_of(pt::Engine engine, int bounces, bool hemisphere, bool adaptive) {
  measure::Spec spec;
  spec.engine = engine;
  spec.path.to = bounces;
  if (hemisphere) spec.path.direct = pt::PathSettings::Direct::hemisphere;
  if (adaptive) spec.adaptive = pt::AdaptiveSettings{};
  return measure::tasks_used(spec);
}

void add(Slugs& to, const std::vector<std::string>& more) { to.insert(more.begin(), more.end()); }

// The same from the table of tasks: the tasks of pixels and paths, and the tasks that they call. A
// scene is traced by the tracing tasks, by the tasks for single shapes, or by no task.
Slugs by_the_table(pt::Engine engine, int bounces, bool hemisphere, bool adaptive) {
  const std::string pixels = adaptive ? "adaptive_pixel" : "estimate_pixel";
  Slugs all{pixels};
  add(all, grader::needs(pixels));
  if (engine == pt::Engine::linear) add(all, {"hit_triangle", "hit_sphere"});
  if (engine == pt::Engine::task) add(all, grader::tracing_tasks());
  if (bounces < 1) return all;
  all.insert("trace_path");
  add(all, grader::task_of("trace_path").calls);
  all.erase(hemisphere ? "direct_lights" : "direct_hemisphere");
  return all;
}

TEST(Specs, tasks_that_pixels_depend_on_are_those_of_the_table) {
  Slugs seen;
  for (const pt::Engine engine : {pt::Engine::linear, pt::Engine::task, pt::Engine::wide}) {
    for (const int bounces : {0, 1, 5}) {
      for (const bool hemisphere : {false, true}) {
        for (const bool adaptive : {false, true}) {
          const Slugs used = tasks_of(engine, bounces, hemisphere, adaptive);
          EXPECT_EQ(used, by_the_table(engine, bounces, hemisphere, adaptive));
          seen.insert(used.begin(), used.end());
        }
      }
    }
  }
  for (const grader::Task& task : grader::tasks()) {
    EXPECT_EQ(seen.contains(task.slug), grader::pixels_depend_on(task.slug)) << task.slug;
  }
}

// The rendering program reads the file that the planning program has written.
TEST(Specs, arrive_as_they_were_written) {
  measure::Spec spec;
  spec.scene = "scenes/box_spheres.dae";
  spec.framing = pt::Framing::file;
  spec.adaptive = pt::AdaptiveSettings{96, 8, .1};
  spec.samples = 96;
  spec.path.direct = pt::PathSettings::Direct::hemisphere;
  spec.path.from = 2;
  spec.path.to = 7;
  spec.path.light_samples = 3;
  spec.path.survival = .5;
  spec.ranges = {{1, 1}, {2, 7}};
  spec.engine = pt::Engine::linear;
  spec.seed = 9;
  const measure::Spec read = measure::spec_from_json(to_json(spec));
  EXPECT_EQ(to_json(read), to_json(spec));
  EXPECT_EQ(measure::render_command(read, "a.png"),
            "./run render scenes/box_spheres.dae -f a.png -s 96 -a 8 0.1 -l 3 -m 7 --show indirect "
            "-H --survival 0.5 --camera file --engine linear --seed 9");
}

// A render of a picture of 4 x 3 pixels.
class StoreTest : public testing::Test {
 protected:
  StoreTest() {
    scene("one scene");
    for (const grader::Task& task : grader::tasks()) code_.hash[task.slug] = "old";
    code_.hash["framework"] = "old";
    unit_.spec.scene = folder_.path() + "/room.dae";
    unit_.spec.width = 4;
    unit_.spec.height = 3;
    unit_.spec.engine = pt::Engine::wide;
  }

  void scene(const std::string& text) const { pt::write_file(folder_.path() + "/room.dae", text); }
  // The store of another run of the program, which knows no hash yet.
  Store store() const { return Store(folder_.path() + "/renders"); }
  std::string key() const { return store().key(unit_); }

  TemporaryFolder folder_;
  Code code_;
  Unit unit_{{}, &code_, 0};
};

TEST_F(StoreTest, a_render_is_made_again_when_what_it_depends_on_changes) {
  std::set<std::string> keys{key()};
  ++unit_.spec.seed;
  EXPECT_TRUE(keys.insert(key()).second) << "another seed";
  unit_.spec.path.survival = .5;
  EXPECT_TRUE(keys.insert(key()).second) << "another setting of paths";
  unit_.spec.ranges = {{0, 0}, {1, 1}};
  EXPECT_TRUE(keys.insert(key()).second) << "other bounces apart";
  scene("another scene");
  EXPECT_TRUE(keys.insert(key()).second) << "another scene under its name";
  code_.hash["framework"] = "new";
  EXPECT_TRUE(keys.insert(key()).second) << "another framework";
  code_.hash["estimate_pixel"] = "new";
  EXPECT_TRUE(keys.insert(key()).second) << "another task";
}

TEST_F(StoreTest, a_render_stays_when_what_it_does_not_depend_on_changes) {
  const std::string before = key();
  code_.hash["adaptive_pixel"] = "new";
  code_.hash["hit_bvh"] = "new";  // the fast engine traces the rays
  EXPECT_EQ(key(), before);
  unit_.spec.scene = folder_.path() + "/moved.dae";
  pt::write_file(unit_.spec.scene, "one scene");
  EXPECT_EQ(key(), before);
}

measure::Row row_of(int y, int pixels) {
  measure::Row row;
  row.head.cpu_seconds = .5;
  for (int x = 0; x < pixels; ++x) {
    row.pixels.push_back({{static_cast<float>(10 * y + x), 0, 0}, .25F, 8, -1});
  }
  return row;
}

// Rows count from the bottom, a film's pixels from the top. Two pictures lie side by side in a row.
TEST_F(StoreTest, rows_of_bands_become_the_picture) {
  unit_.spec.ranges = {{0, 0}, {1, 1}};
  unit_.range = 1;
  const Store store = this->store();
  for (const measure::Band& band : store.begin(unit_, 2)) {
    for (int i = 0; i < band.rows; ++i)
      measure::append_row(band.file(), row_of(band.first_row + i, 8));
    EXPECT_FALSE(store.is_complete(unit_));
    measure::finish_band(band, {{"trace_path"}, "wide", 14});
  }
  EXPECT_TRUE(store.is_complete(unit_));
  const Rendered loaded = store.load(unit_);
  EXPECT_EQ(loaded.film.at(0, 2).mean.r, 4) << "bottom left, of the second picture";
  EXPECT_EQ(loaded.film.at(3, 0).mean.r, 27) << "top right";
  EXPECT_EQ(loaded.film.at(1, 1).samples, 8);
  EXPECT_EQ(loaded.missing, std::vector<std::string>{"trace_path"});
  EXPECT_EQ(loaded.seconds, 1.5);
  EXPECT_TRUE(loaded.has_variance);
}

// A program that was killed in the middle of a row.
TEST_F(StoreTest, half_a_row_is_cut_off_and_made_again) {
  const measure::Band band = store().begin(unit_, 2).at(1);
  measure::append_row(band.file(), row_of(1, 4));
  measure::append_row(band.file(), row_of(2, 4));
  std::filesystem::resize_file(band.file(), std::filesystem::file_size(band.file()) - 7);
  EXPECT_EQ(band.first_row, 1);
  EXPECT_EQ(measure::start_band(band, 4), 2);
  measure::append_row(band.file(), row_of(2, 4));
  const std::vector<measure::Row> rows = measure::read_rows(band.file(), 4);
  ASSERT_EQ(rows.size(), 2);
  EXPECT_EQ(rows[1].pixels[3].mean[0], 23);
}

TEST_F(StoreTest, a_measurement_depends_on_its_part_of_the_code) {
  const Store store = this->store();
  const Measurements measured(folder_.path() + "/measured", store);
  Measurement needs{"cheapest", unit_.spec.scene, {"--error", "0.02"}, 60, &code_, ""};
  Measurement curve{"stability", "", {"hit_sphere"}, 60, &code_, "as it is"};
  const std::string before = measured.key(needs), before_curve = measured.key(curve);
  code_.hash["hit_box"] = "new";
  EXPECT_NE(measured.key(needs), before);
  EXPECT_EQ(measured.key(curve), before_curve);
  curve.depends = "changed";
  EXPECT_NE(measured.key(curve), before_curve);
  const std::string now = measured.key(needs);
  needs.options[1] = "0.01";
  EXPECT_NE(measured.key(needs), now);
}

// 256, 128 and 64 with the exponent 16; 1.9995 would be 512, and is 256 with the exponent 17. The 32 bits of
// a pixel begin with their last byte, in Base64.
TEST(files, of_a_film_have_nine_bits_of_each_channel_and_a_common_exponent) {
  const TemporaryFolder folder;
  pt::Film film(2, 1);
  film.pixels[0].mean = {1, .5, .25};
  film.pixels[1].mean = {1.9995, 0, 1 / 128.};
  write_film(folder.path() + "/film", film, 1);
  EXPECT_THAT(pt::read_file(folder.path() + "/film.js"), testing::HasSubstr("\"AAEBgQABBIg=\""));
}

}  // namespace
}  // namespace writeup
