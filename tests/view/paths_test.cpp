// The paths of pixels as the view records them: against closed forms, and against contracts. The program is linked with the
// reference, with a mistake, or with right variants; VIEW_BREAKS is the promise that a red cell has to name, "none", or
// "reference", VIEW_TRACE_PATH the choice for that task, and VIEW_STEP the distance of the pixels.
#include "grader/check/scenes/closed_forms.h"
#include "grader/results/promises.h"
#include "pt/error.h"
#include "pt/file.h"
#include "pt/render/choose_engine.h"
#include "pt/scene/recorder.h"
#include "pt/tasks/camera_ray.h"
#include "view/worker/answer.h"
#include "view/worker/check.h"
#include "view/worker/disk.h"
#include "view/worker/json.h"
#include "view/worker/path.h"
#include "view/worker/picture.h"
#include "view/worker/tree.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <map>
#include <set>

#include <gtest/gtest.h>

namespace view {
namespace {

const std::filesystem::path kScenes = FIRSTLIGHT_SCENES;

std::string breaks() {
  const char* word = std::getenv("VIEW_BREAKS");
  return word == nullptr ? "none" : word;
}

bool is_reference() { return breaks() == "reference"; }

struct Room {
  pt::LoadedScene loaded;
  pt::Tracer exact;

  explicit Room(const char* file) : loaded(pt::load_collada(kScenes / file)) {
    choose_engine(loaded.scene, pt::Engine::task, 4);
    exact = pt::Tracer(pt::Engine::wide, loaded.scene.primitives);
  }

  PixelPaths paths(Query query, int x, int y) const {
    query["x"] = std::to_string(x);
    query["y"] = std::to_string(y);
    const Settings settings = settings_of(query);
    const pt::View view = view_of(loaded, settings);
    PixelPaths pixel = paths_of_pixel(view, settings);
    check_calls(view, exact, pixel, settings);
    return pixel;
  }
};

const Query kQuery{{"w", "96"}, {"h", "72"}, {"samples", "8"}};

// Calls `look` with the pixels of a grid over pictures of several scenes and settings.
template <class Look>
void for_pixels(const Look& look) {
  const char* const word = std::getenv("VIEW_STEP");
  const int step = word == nullptr ? 9 : std::stoi(word);
  for (const char* file : {"box_spheres.dae", "two_lights.dae", "furnace.dae", "bowl.dae"}) {
    const Room room(file);
    Query query = kQuery;
    if (std::string_view(file) == "furnace.dae") query["camera"] = "file";
    for (const bool hemisphere : {false, true}) {
      if (hemisphere) query["hemisphere"] = "1";
      query["light_samples"] = hemisphere ? "4" : "2";
      for (int y = 2; y < 72; y += step) {
        for (int x = 3; x < 96; x += step) look(file, room.paths(query, x, y));
      }
    }
  }
}

std::string words(const Finding& finding) {
  return finding.task + " " + finding.promise + ": " + finding.text + " (" + finding.cell + " of " +
         std::to_string(finding.bounce) + ")";
}

TEST(Paths, have_a_red_cell_only_where_a_promise_is_broken) {
  std::set<std::string> promises, tasks;
  std::map<std::string, int> found;
  std::set<int> points;
  for_pixels([&](const char* file, const PixelPaths& pixel) {
    std::vector<Finding> all = pixel.findings;
    for (const Path& path : pixel.paths) {
      all.insert(all.end(), path.findings.begin(), path.findings.end());
    }
    for (const Finding& finding : all) {
      promises.insert(finding.promise);
      tasks.insert(finding.task);
      if (finding.cell == "point") points.insert(finding.bounce);
      ++found[std::string(file) + ": " + words(finding)];
    }
  });
  std::string shown;
  for (const auto& [what, times] : found) {
    if (shown.size() < 3000) shown += what + ", " + std::to_string(times) + " times\n";
  }
  if (breaks() == "none" || is_reference()) {
    EXPECT_TRUE(promises.empty()) << shown;
  } else {
    EXPECT_TRUE(promises.contains(breaks())) << shown;
    EXPECT_EQ(tasks.size(), 1U) << "a task without a mistake is blamed:\n" << shown;
    EXPECT_TRUE(points.empty() || *points.begin() == 1)
        << "the camera's ray is the first that is wrong";
  }
}

// Solutions of trace_path that multiply the sum of all later points, and so round otherwise than a sum of parts.
const std::set<std::string> kRecursive{
    "asks_for_f_and_pdf", "function_that_calls_itself", "path_first_light_afterwards",
    "recursion",          "survival_by_albedo",         "survival_three_tenths",
    "no_cosine"};

// Bit for bit; those that round otherwise up to a few roundings in double.
TEST(Paths, add_up) {
  const char* const choice = std::getenv("VIEW_TRACE_PATH");
  const std::string trace_path = choice == nullptr ? "reference" : choice;
  const bool is_recursive = kRecursive.contains(trace_path);
  const bool works_by_paths =
      trace_path != "two_first_directions" && trace_path != "splits_at_the_second_point";
  int paths = 0, exact = 0;
  for_pixels([&](const char*, const PixelPaths& pixel) {
    for (const Path& path : pixel.paths) {
      if (!works_by_paths && !path.is_one) continue;
      ++paths;
      exact += adds_up(path) ? 1 : 0;
      EXPECT_TRUE(path.is_one && !path.lost_point);
      EXPECT_TRUE(adds_up(path) || (is_recursive && close(sum_of_parts(path), path.traced, 1e-14)));
      EXPECT_EQ(path.value, pt::Rgb{} + path.emission + path.traced);
      // Survival at a point without light is not told by the parts, and a share of the light is none.
      if (breaks() != "none" || trace_path == "survival_by_throughput" || !works_by_paths) continue;
      for (const Bounce& at : path.bounces) {
        if (at.direct.empty() || is_black(at.part)) continue;
        EXPECT_TRUE(close(at.part, at.throughput * at.direct[0].light, 1e-5));
      }
    }
  });
  EXPECT_GT(paths, works_by_paths ? 2000 : -1);
  EXPECT_EQ(exact < paths, is_recursive) << exact << " of " << paths;
}

// From a black surface, whose f is 0, a path goes on to a point with direct light.
TEST(Paths, show_light_that_a_black_surface_reflects) {
  const auto findings = [](pt::Rgb part) {
    Path path;
    path.bounces.resize(2);
    path.bounces[0].direct = {{"direct_lights", 1, pt::Rgb{}}};
    path.bounces[0].next = {{{0, 0, 1}, pt::Rgb{}, 1 / pt::kPi}};
    path.bounces[1].direct = {{"direct_lights", 1, pt::gray(1)}};
    path.bounces[1].part = path.traced = part;
    check_path({.light_samples = 1, .to = 2}, path);
    return path.findings;
  };
  EXPECT_TRUE(findings(pt::Rgb{}).empty());
  ASSERT_EQ(findings(pt::gray(0.5)).size(), 1U);
  EXPECT_EQ(findings(pt::gray(0.5))[0].promise, "tints_at_each_bounce");
}

// The third point's light is divided by the survival. To multiply by it is a mistake; a task that goes on in two directions
// gives half of the light to each.
TEST(Paths, may_share_the_light_between_two_directions) {
  const auto findings = [](double weight) {
    Path path;
    path.bounces.resize(3);
    path.bounces[1].drawn = {0.3};
    for (std::size_t k = 0; k < 3; ++k) {
      Bounce& bounce = path.bounces[k];
      bounce.point.albedo = pt::gray(0.5);
      bounce.direct = {{"direct_lights", 1, pt::gray(1)}};
      if (k < 2) bounce.next = {{{0, 0, 1}, pt::gray(0.5 / pt::kPi), 1 / pt::kPi}};
      bounce.part = pt::gray(std::pow(0.5, static_cast<double>(k)) * (k == 2 ? weight : 1));
      path.traced += bounce.part;
    }
    check_path({.light_samples = 1, .survival = 0.7, .to = 3}, path);
    return path.findings;
  };
  EXPECT_TRUE(findings(1 / 0.7).empty());
  EXPECT_TRUE(findings(1 / (2 * 0.7)).empty());
  ASSERT_EQ(findings(0.7).size(), 1U);
  EXPECT_EQ(findings(0.7)[0].promise, "does_not_depend_on_survival");
}

// A path ends at its second point: one number that is drawn at the first one may say so.
TEST(Paths, may_draw_first_where_they_end) {
  const auto findings = [](std::vector<double> drawn) {
    Path path;
    path.bounces.resize(2);
    path.bounces[0].drawn = std::move(drawn);
    path.bounces[0].next = {{{0, 0, 1}, pt::gray(0.1), 1 / pt::kPi}};
    path.bounces[1].point.albedo = pt::gray(0.5);
    check_path({.light_samples = 1, .to = 3}, path);
    return path.findings;
  };
  EXPECT_TRUE(findings({0.3}).empty());
  ASSERT_EQ(findings({}).size(), 1U);
  EXPECT_EQ(findings({})[0].promise, "reaches_the_last_bounce");
}

// In a room of albedo 1/2, with directions by the cosine, the throughput of point k is 2^(1 - k), divided by the survival at
// each point but the first. Each point adds that times its direct light.
TEST(Paths, have_the_throughput_of_the_furnace) {
  if (!is_reference()) GTEST_SKIP() << "another density has another throughput";
  const Room room("furnace.dae");
  Query query = kQuery;
  query.insert({{"camera", "file"}, {"samples", "64"}, {"survival", "0.6"}, {"bounces", "7"}});
  std::size_t longest = 0;
  for (const Path& path : room.paths(query, 40, 30).paths) {
    EXPECT_EQ(path.emission, pt::gray(1));
    longest = std::max(longest, path.bounces.size());
    for (std::size_t k = 0; k < path.bounces.size(); ++k) {
      const double survivals = std::pow(0.6, std::max(0.0, static_cast<double>(k) - 1));
      const double throughput = std::pow(0.5, static_cast<double>(k)) / survivals;
      EXPECT_NEAR(path.bounces[k].throughput.r, throughput, 1e-12);
      ASSERT_EQ(path.bounces[k].direct.size(), 1U);
      EXPECT_TRUE(close(path.bounces[k].part, throughput * path.bounces[k].direct[0].light, 1e-12));
      if (k > 0 && k + 1 < path.bounces.size()) {
        ASSERT_EQ(path.bounces[k].drawn.size(), 1U);
        EXPECT_LT(path.bounces[k].drawn[0], 0.6);
      }
    }
    if (path.bounces.size() < 7) {
      ASSERT_EQ(path.bounces.back().drawn.size(), 1U);
      EXPECT_GE(path.bounces.back().drawn[0], 0.6);
    }
  }
  EXPECT_GE(longest, 4U);
}

// The disk of the first point of the ray through the middle of a pixel, after some passes.
Disk disk_at(const Room& room, Query query, int x, int y) {
  query["samples"] = "1";
  const PixelPaths pixel = room.paths(query, x, y);
  Disk disk = begin_disk(pixel.paths.at(0).bounces.at(0).point, settings_of(query), 0);
  while (disk.passes < 12) improve(disk, room.loaded.scene, std::chrono::milliseconds(50));
  return disk;
}

bool agrees(const Mean& mean, double expected) {
  return std::abs(mean.mean - expected) <= 6 * mean.error() + 1e-9;
}
bool agrees(const Balance& balance) {
  const double error = std::hypot(balance.returned.error(), balance.disk.error());
  return std::abs(balance.returned.mean - balance.disk.mean) <= 6 * error + 1e-9;
}

// The integral over the disk of a number that layers_of has per area of it.
double integral(const Disk& disk, int layer) {
  const std::vector<float> layers = layers_of(disk);
  const double area = std::pow(2.0 / kDiskSide, 2);
  double sum = 0;
  for (std::size_t i = 0; i < disk.cells.size(); ++i) {
    sum += disk.cells[i].inside * area * layers[layer * disk.cells.size() + i];
  }
  return sum;
}

// In a room of emission 1 and albedo 1/2, 1/2 is reflected at once, and 1/2 + ... + 1/32 after five bounces.
TEST(Disks, hold_the_light_of_the_furnace) {
  if (!is_reference()) GTEST_SKIP();
  Query query = kQuery;
  query["camera"] = "file";
  query["hemisphere"] = "1";
  const Disk disk = disk_at(Room("furnace.dae"), query, 40, 30);
  EXPECT_TRUE(agrees(disk.direct.disk, 0.5)) << disk.direct.disk.mean;
  EXPECT_TRUE(agrees(disk.all.disk, 1 - 1.0 / 32)) << disk.all.disk.mean;
  EXPECT_TRUE(agrees(disk.direct));
  EXPECT_TRUE(agrees(disk.all));
  EXPECT_LT(disk.all.disk.error(), 0.01);
  for (const DiskCell& cell : disk.cells) {
    if (cell.samples == 0) continue;
    EXPECT_TRUE(close(cell.emission, pt::gray(cell.samples)));
    EXPECT_TRUE(cell.inside == 0 || close(cell.density, 1 / pt::kPi));
  }
  EXPECT_NEAR(disk.pdf_sum, 1, 1e-9);
  EXPECT_NEAR(integral(disk, 9), 1, 2e-3);
  EXPECT_NEAR(integral(disk, 10), 1, 0.01);
  EXPECT_NEAR(integral(disk, 11), 1, 0.05);  // of uniform directions many are at the rim
}

// The lamp's projected solid angle, by Lambert's formula; and render finds the same light in the pixel.
TEST(Disks, hold_a_lamp_of_known_size) {
  if (!is_reference()) GTEST_SKIP();
  const Room room("box_spheres.dae");
  const auto& lamp = std::get<pt::RectangleLight>(room.loaded.scene.lights.at(0));
  Query query = kQuery;
  for (const bool hemisphere : {false, true}) {
    if (hemisphere) query["hemisphere"] = "1";
    const Disk disk = disk_at(room, query, 48, 12);
    const auto corner = [&](double a, double b) { return lamp.center + a * lamp.u + b * lamp.v; };
    const double size = grader::check::cosine_of_polygon(
        {corner(-0.5, -0.5), corner(0.5, -0.5), corner(0.5, 0.5), corner(-0.5, 0.5)}, disk.point.p,
        disk.point.n);
    EXPECT_NEAR(integral(disk, 0), size * lamp.radiance.r, 0.02 * size * lamp.radiance.r);
    const double light = luminance(disk.point.albedo / pt::kPi * lamp.radiance) * size;
    EXPECT_TRUE(agrees(disk.direct.disk, light)) << disk.direct.disk.mean << " for " << light;
    EXPECT_LT(disk.direct.disk.error(), 0.02 * light);
    EXPECT_TRUE(agrees(disk.direct.returned, light)) << disk.direct.returned.mean;
    query["show"] = "direct";
    query["samples"] = "64";
    query["light_samples"] = "64";
    EXPECT_NEAR(luminance(room.paths(query, 48, 12).mean), light, 0.1 * light);
    query["light_samples"] = "1";
  }
}

// No ray meets a point light, and none comes from below.
TEST(Disks, add_light_without_a_surface) {
  if (!is_reference()) GTEST_SKIP();
  const Disk disk = disk_at(Room("point_light.dae"), kQuery, 48, 12);
  EXPECT_GT(disk.direct.returned.mean, 0.01);
  EXPECT_NEAR(disk.direct.disk.mean, disk.direct.returned.mean, 1e-9);
  EXPECT_TRUE(agrees(disk.all));
  EXPECT_EQ(disk.by_bsdf.below, 0);
}

// Right tasks return what the disk holds; a mistake in a weight shows.
TEST(Disks, balance_where_tasks_are_right) {
  const Room room("box_spheres.dae");
  for (const auto& [x, y] : {std::pair(48, 12), {20, 40}, {70, 30}}) {
    const Disk disk = disk_at(room, kQuery, x, y);
    if (breaks() == "none" || is_reference()) {
      EXPECT_TRUE(agrees(disk.direct)) << x;
      EXPECT_TRUE(agrees(disk.all)) << x;
      EXPECT_NEAR(disk.pdf_sum, 1, 1e-3);
      EXPECT_LT(elsewhere(disk), 0.02);
    }
    if (breaks() == "a_sample_knows_its_own_f_and_pdf") {
      EXPECT_GT(elsewhere(disk), 0.1) << x;  // uniform, says diffuse_pdf
    }
    if (breaks() == "weighs_by_the_cosine") {
      EXPECT_TRUE(agrees(disk.direct)) << x;
      EXPECT_FALSE(agrees(disk.all)) << x;
    }
  }
}

TEST(Disks, refuse_points_that_are_none) {
  Answers answers(kScenes / "box_spheres.dae", false);
  for (const char* met : {"", "1,2", "0,0,0,0,0,1,1,0,0,1,99999", "0,0,0,0,0,1,1,0,0,1,-1",
                          "0,0,0,0,0,nan,1,0,0,1,0", "0,0,0,0,0,1,1,0,0,1,0,5"}) {
    EXPECT_THROW(answers.answer("disk", {{"met", met}, {"point", "0"}}), pt::Error) << met;
  }
  EXPECT_THROW(answers.answer("disk", {{"met", "0,0,0,0,0,1,1,0,0,1,0"}}), pt::Error);
}

// Values are there of all samples, paths of 64 of them.
TEST(Samples, have_values_beyond_the_paths) {
  const Room room("box_spheres.dae");
  Query query = kQuery;
  query["samples"] = "100";
  const PixelPaths whole = room.paths(query, 48, 12);
  query["first"] = "64";
  const PixelPaths rest = room.paths(query, 48, 12);
  EXPECT_EQ(whole.values.size(), 100U);
  EXPECT_EQ(whole.values, rest.values);
  EXPECT_EQ(whole.mean, rest.mean);
  ASSERT_EQ(whole.paths.size(), 64U);
  ASSERT_EQ(rest.paths.size(), 36U);
  for (int i = 0; i < 36; ++i) EXPECT_EQ(rest.paths[i].value, whole.values[64 + i]);
}

// adaptive_pixel takes the samples, as in ./run render -a.
TEST(Samples, are_those_of_adaptive_sampling) {
  const Room room("box_spheres.dae");
  Query query = kQuery;
  query.erase("samples");
  query["adaptive"] = "256,8,0.1";
  query["x"] = "48";
  query["y"] = "12";
  const Settings settings = settings_of(query);
  const PixelPaths pixel = room.paths(query, 48, 12);
  const pt::View view = view_of(room.loaded, settings);
  const pt::RenderedPixel rendered =
      render_pixel(view, 48, 12, {1, settings.render.adaptive, settings.render.seed, 1});
  EXPECT_EQ(pixel.samples, rendered.pixel.samples);
  EXPECT_EQ(pixel.values.size(), static_cast<std::size_t>(pixel.samples));
  EXPECT_EQ(pixel.mean, rendered.pixel.mean);
  EXPECT_GT(pixel.samples, 8);
  if (is_reference()) {
    EXPECT_LT(pixel.samples, 256);
  }
}

// The mean over all pixels of the furnace is that of its closed form, 2 (1 - 2^-(m + 1)), within six standard errors.
TEST(Pictures, show_the_light_of_the_furnace) {
  if (!is_reference()) GTEST_SKIP();
  const Room room("furnace.dae");
  Query query = kQuery;
  query.insert({{"camera", "file"}, {"bounces", "3"}, {"hemisphere", "1"}, {"light_samples", "4"}});
  query.erase("samples");
  Picture picture = begin_picture(room.loaded, settings_of(query));
  while (picture.samples < 6) improve(picture, std::chrono::milliseconds(50));
  double mean = 0, squared_error = 0;
  const auto pixels = static_cast<double>(picture.sums.size());
  for (const Picture::Sum& sum : picture.sums) {
    const auto n = static_cast<double>(sum.samples);
    mean += luminance(sum.mean) / pixels;
    squared_error += sum.squares / (n - 1) / n / (pixels * pixels);
  }
  EXPECT_NEAR(mean, 2 * (1 - 1.0 / 16), 6 * std::sqrt(squared_error));
  EXPECT_LT(squared_error, 1e-5);
  EXPECT_EQ(picture.note, "");
}

TEST(Pictures, that_are_black_say_why) {
  if (!is_reference()) GTEST_SKIP();
  const Room room("pale_room.dae");  // its walls hide the lamp from a camera outside
  Query query = kQuery;
  query.erase("samples");
  Picture picture = begin_picture(room.loaded, settings_of(query));
  while (picture.samples < 2) improve(picture, std::chrono::milliseconds(50));
  EXPECT_EQ(picture.note.find("the picture is black: no light reaches"), 0u) << picture.note;

  std::string text = pt::read_file(kScenes / "point_light.dae");
  text.replace(text.find("<instance_light"), 15, "<instance_nolight");
  const auto file = std::filesystem::path(testing::TempDir()) / "dark.dae";
  pt::write_file(file, text);
  Answers answers(file, false);
  const auto shown = answers.answer("picture", query).state;  // a file without a light gets a sky
  EXPECT_TRUE(shown.at("goes_on"));
  EXPECT_EQ(shown.dump().find("the picture is black"), std::string::npos) << shown.dump();
}

TEST(Pictures, show_numbers_in_place_of_light) {
  if (!is_reference()) GTEST_SKIP();
  const Room room("furnace.dae");
  Query query = kQuery;
  query.erase("samples");
  query["camera"] = "file";
  query["shown"] = "boxes";
  Picture picture = begin_picture(room.loaded, settings_of(query));
  while (picture.samples < 2) improve(picture, std::chrono::milliseconds(50));
  EXPECT_GT(picture.shown[3 * 40 * 96], 1);
}

// The page's map of distances is what the false colour shows, but it comes without the tasks.
TEST(Pictures, have_a_map_of_distances) {
  if (!is_reference()) GTEST_SKIP();
  Query query{{"w", "96"}, {"h", "72"}};
  Answers answers(kScenes / "box_spheres.dae", false);
  const Answer map = answers.answer("depth", query);
  query["shown"] = "distance";
  Answer picture = answers.answer("picture", query);
  while (picture.state.at("goes_on")) picture = answers.answer("picture", query);
  ASSERT_EQ(map.state, (nlohmann::json{{"width", 96}, {"height", 72}}));
  ASSERT_EQ(map.bytes.size(), picture.bytes.size() / 3);
  std::vector<float> mine(96 * 72), shown(3 * 96 * 72);
  std::memcpy(mine.data(), map.bytes.data(), map.bytes.size());
  std::memcpy(shown.data(), picture.bytes.data(), picture.bytes.size());
  int far = 0;
  for (std::size_t i = 0; i < mine.size(); ++i) {
    // Two engines may disagree at an edge.
    far += std::isinf(mine[i]) ? !std::isnan(shown[3 * i]) : !close(mine[i], shown[3 * i]);
  }
  EXPECT_LE(far, 10);

  query = {{"w", "2000"}, {"h", "16"}};
  EXPECT_EQ(answers.answer("depth", query).state, (nlohmann::json{{"width", 223}, {"height", 2}}));
}

// With l = 1, each path of the furnace that is not ended by roulette has as many points as bounces are allowed.
TEST(Pictures, count_the_points_of_paths) {
  if (!is_reference()) GTEST_SKIP();
  const Room room("furnace.dae");
  for (const bool hemisphere : {false, true}) {
    Query query = kQuery;
    query.erase("samples");
    query.insert({{"camera", "file"}, {"shown", "points"}, {"bounces", "3"}, {"survival", "1"}});
    if (hemisphere) query.insert({{"hemisphere", "1"}, {"light_samples", "4"}});
    Picture picture = begin_picture(room.loaded, settings_of(query));
    while (picture.samples < 2) improve(picture, std::chrono::milliseconds(50));
    EXPECT_EQ(picture.shown[3 * 40 * 96], 3);
  }
}

// hit_bvh tests no box below one that it has not opened, opens none that the ray misses, and its answer is the nearest of the
// primitives that it tested.
TEST(Tests, of_a_ray_have_the_order_of_the_search) {
  if (!is_reference()) GTEST_SKIP();
  const Room room("box_coil.dae");
  const pt::Bvh& bvh = room.loaded.scene.tracer.bvh();
  int with_order = 0;
  for (int y = 4; y < 72; y += 8) {
    for (int x = 4; x < 96; x += 8) {
      Query query{{"w", "96"}, {"h", "72"}, {"x", std::to_string(x)}, {"y", std::to_string(y)}};
      const pt::View view = view_of(room.loaded, settings_of(query));
      const pt::Ray ray = camera_ray(view.camera, (x + 0.5) / 96, (y + 0.5) / 72);
      const pt::TestCount before = pt::recorder.count;
      const nlohmann::json all = tests_of(room.loaded.scene, ray);
      const auto& tests = all.at("tests");
      std::map<int, bool> opened;  // by node, in the order of the tests
      double nearest = pt::kInfinity;
      std::size_t primitives = 0;
      for (const auto& test : tests) {
        const int node = test.at("node");
        ASSERT_GE(node, 0);
        EXPECT_EQ(test.at("low"), to_json(bvh.nodes[node].box.min));
        if (node > 0) {
          const auto parent = std::ranges::find_if(bvh.nodes, [&](const pt::BvhNode& each) {
            return !each.is_leaf() && (each.left == node || each.right == node);
          });
          const auto before_it = opened.find(static_cast<int>(parent - bvh.nodes.begin()));
          // The root's box need not be tested.
          const bool is_below_root = parent == bvh.nodes.begin();
          EXPECT_TRUE(is_below_root || (before_it != opened.end() && before_it->second));
        }
        opened[node] = test.at("opened");
        if (test.at("opened")) {
          EXPECT_FALSE(test.at("t").is_null());
        }
        for (const auto& primitive : test.value("primitives", nlohmann::json::array())) {
          ++primitives;
          if (primitive.at(1).is_number())
            nearest = std::min(nearest, primitive.at(1).get<double>());
        }
      }
      with_order += opened.size() == tests.size() && tests.size() > 10 ? 1 : 0;
      EXPECT_EQ(primitives, all.at("primitives").get<std::size_t>());
      ASSERT_TRUE(all.at("t").is_number());
      EXPECT_EQ(all.at("t"), nearest);
      EXPECT_GE(pt::recorder.count.boxes - before.boxes, static_cast<long long>(tests.size()));
    }
  }
  EXPECT_GT(with_order, 20);
}

TEST(Settings, are_refused_with_one_sentence) {
  const std::vector<Query> wrong{{{"w", "abc"}},
                                 {{"w", "1e9"}},
                                 {{"w", "4"}},
                                 {{"x", "480"}},
                                 {{"samples", "-1"}},
                                 {{"bounces", "--help"}},
                                 {{"show", "--help"}},
                                 {{"show", "all"}},
                                 {{"survival", "0"}},
                                 {{"survival", "nan"}},
                                 {{"eye", "1,2"}, {"target", "0,0,0"}, {"up", "0,1,0"}},
                                 {{"eye", "1,2,inf"}, {"target", "0,0,0"}, {"up", "0,1,0"}},
                                 {{"eye", "0,2,0"}, {"target", "0,0,0"}, {"up", "0,1,0"}},
                                 {{"eye", "0,2,0"}},
                                 {{"shown", "colours"}},
                                 {{"output", "/tmp/x"}},
                                 {{"adaptive", "32,0.05"}},
                                 {{"adaptive", "99999,32,0.05"}},
                                 {{"adaptive", "--help,1"}}};
  for (const Query& query : wrong) {
    try {
      settings_of(query);
      ADD_FAILURE() << query.begin()->first << " = " << query.begin()->second << " is accepted";
    } catch (const pt::Error& error) {
      const std::string text = error.what();
      EXPECT_GT(text.size(), 10U);
      EXPECT_EQ(text.find('\n'), std::string::npos) << text;
    }
  }
}

TEST(Settings, place_the_camera_anywhere) {
  const Settings settings =
      settings_of({{"eye", "-1,-2.5,3e-1"}, {"target", "-4,0,0"}, {"up", "0,-1,0"}});
  ASSERT_TRUE(settings.eye);
  EXPECT_EQ(settings.eye->position, (pt::Vec3{-1, -2.5, 0.3}));
}

// The names that cells give to promises are those of the contracts.
TEST(Findings, name_promises_of_contracts) {
  for (const char* source : {"check_camera", "check_hits", "check_path"}) {
    const std::string text =
        pt::read_file(FIRSTLIGHT_ROOT "/view/worker/" + std::string(source) + ".cpp");
    std::set<std::string> known;
    for (const auto& entry : std::filesystem::directory_iterator(FIRSTLIGHT_ROOT "/pt/tasks")) {
      for (const auto& promise : grader::results::promises_of(pt::read_file(entry.path()))) {
        known.insert(promise.name);
      }
    }
    int names = 0;
    for (std::size_t at = text.find('"'); at != std::string::npos;) {
      const std::size_t end = text.find('"', at + 1);
      const std::string word = text.substr(at + 1, end - at - 1);
      const bool is_name =
          std::ranges::count(word, '_') >= 2 && word.find_first_of(" /.") == std::string::npos;
      if (is_name) {
        ++names;
        EXPECT_TRUE(known.contains(word)) << source << ": " << word;
      }
      at = text.find('"', end + 1);
    }
    EXPECT_GT(names, 5);
  }
}

}  // namespace
}  // namespace view
