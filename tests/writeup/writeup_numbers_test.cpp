// The numbers of measured figures, from the files of a measurement.
#include "grader/tasks.h"
#include "pt/file.h"
#include "tests/fixtures/temporary_folder.h"
#include "writeup/compose.h"
#include "writeup/figure.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace writeup {
namespace {

using nlohmann::json;

// A plan for one figure, with a measurement that a test chooses.
class NumbersTest : public testing::Test {
 protected:
  NumbersTest() {
    Code code;
    code.hash = {{"hit_sphere", "a"}, {"framework", "b"}};
    codes_.chosen = code;
    codes_.accuracy = codes_.stability = codes_.measure = code;
    catalogue_.scenes["box"].own = FIRSTLIGHT_ROOT "/scenes/box_spheres.dae";
    std::filesystem::create_directories(folder_.path() + "/pages");
  }

  Drawn drawn(const Figure& figure, const std::string& file, const std::string& text,
              Drawn (*draw)(const Plan&, const Figure&, const std::filesystem::path&)) const {
    const Scenes scenes(catalogue_, "", "", "", false);
    const Store store(folder_.path() + "/renders");
    const Measurements measured(folder_.path() + "/measured", store);
    const Plan plan(catalogue_, codes_, scenes, store, measured, Quality::full);
    const std::filesystem::path made = measured.folder(plan.measurements(figure).at(0));
    std::filesystem::create_directories(made);
    pt::write_file(made / file, text);
    return draw(plan, figure, folder_.path() + "/pages");
  }

  TemporaryFolder folder_;
  Catalogue catalogue_;
  Codes codes_;
};

json line(const char* id, const std::vector<json>& errors) {
  json points = json::array();
  double place = 1;
  for (const json& error : errors) {
    points.push_back({{"place", place}, {"error", error}});
    place *= 100;
  }
  return {{"id", id}, {"title", id}, {"points", points}};
}

// The error is 1e-4 at 100 and 1e-2 at 10000, so it is 1e-3 halfway on both axes, at 1000.
TEST_F(NumbersTest, a_line_fails_where_it_passes_the_threshold) {
  Figure figure;
  figure.kind = "curve";
  figure.curve = "hit_sphere.far_away";
  figure.threshold = 1e-3;
  const json all{{"unusable", json::array()},
                 {"charts",
                  {{{"slug", "hit_sphere"},
                    {"name", "far_away"},
                    {"error", "the error"},
                    {"lines",
                     {line("climbs", {1e-6, 1e-4, 1e-2}), line("stays", {1e-9, 0, 1e-3}),
                      line("stops", {1e-9, 1e-9, nullptr}), line("bad", {.5, .25, .5}),
                      line("jumps", {0, 0, .5})}}}}}};
  const Drawn got = drawn(figure, "stability.json", all.dump(), draw_curve);
  ASSERT_EQ(got.problems, std::vector<std::string>{});
  EXPECT_EQ(got.numbers.at("climbs.fails"), "1000");
  EXPECT_EQ(got.numbers.at("climbs.first"), "1e-6");
  EXPECT_EQ(got.numbers.at("climbs.last"), "0.01");
  EXPECT_EQ(got.numbers.at("climbs.from"), "1");
  EXPECT_EQ(got.numbers.at("climbs.to"), "10000");
  EXPECT_EQ(got.numbers.at("stays.fails"), "\u2013");
  EXPECT_EQ(got.numbers.at("stays.largest"), "0.001");
  EXPECT_EQ(got.numbers.at("stops.fails"), "100 to 10000");
  EXPECT_EQ(got.numbers.at("jumps.fails"), "100 to 10000");
  EXPECT_EQ(got.numbers.at("stops.last"), "none");
  EXPECT_EQ(got.numbers.at("bad.fails"), "1");
}

// Half and an eighth of the time: a quarter in the geometric mean. Incomplete cases do not count. Half the time is
// known to 8 % of it (its interval has 1.96 times that on each side), so the mean of two cases to 4 %.
TEST_F(NumbersTest, a_remedy_costs_the_mean_factor_of_all_cases) {
  Figure figure;
  figure.kind = "prices";
  figure.prices = {{"far", "the sphere is far away", "hit_sphere", "reference", "half_b"}};
  const std::string csv =
      "task,case,implementation,ratio,ratio_low,ratio_high,time_x_variance\n"
      "hit_sphere,\"near, lit\",\"reference\",1,1,1,\n"
      "hit_sphere,\"near, lit\",\"half_b\",.5,.4216,.5784,\n"
      "hit_sphere,\"far\",\"reference\",1,1,1,\n"
      "hit_sphere,\"far\",\"half_b\",.125,.125,.125,\n"
      "hit_sphere,\"alone\",\"half_b\",1000,1000,1000,\n"
      "hit_box,\"near\",\"half_b\",1000,1000,1000,\n";
  const Drawn got = drawn(figure, "measure.csv", csv, draw_prices);
  EXPECT_EQ(got.numbers.at("far.time"), "0.25");
  EXPECT_FALSE(got.numbers.contains("far.work"));
  EXPECT_EQ(got.rows[0][4], "0.25 \u00b1 0.01\u00d7");
  figure.prices = {{"same", "", "hit_sphere", "reference", "half_b"}};
  const Drawn same = drawn(figure, "measure.csv",
                           "task,case,implementation,ratio,ratio_low,ratio_high,time_x_variance\n"
                           "hit_sphere,\"near\",\"reference\",1,1,1,\n"
                           "hit_sphere,\"near\",\"half_b\",1.03,.99,1.07,\n",
                           draw_prices);
  EXPECT_EQ(same.rows[0][4], "1.03 \u00b1 0.02\u00d7, not seen");
}

json point_of_path(double x, double part) {
  return {{"p", {x, 0, -2}},
          {"primitive", 3},
          {"direct",
           {{"light", {0.5, 0.5, 0.5}},
            {"draws",
             {{{"traced", true}, {"hidden", x > 0}, {"distance", 1}, {"wi", {0, 1, 0}}},
              {{"traced", false}, {"hidden", false}, {"distance", "inf"}, {"wi", {0, 1, 0}}}}}}},
          {"throughput", {1, 1, 1}},
          {"part", {part, part, part}},
          {"drawn", {0.25}},
          {"survival", 1}};
}

// The camera sees 45 degrees to each side, so a point at x = 1 and z = -2 is a quarter of the width right of the middle.
json view_of(const std::vector<json>& paths, const json& tests) {
  const json camera{{"position", {0, 0, 0}}, {"x", {1, 0, 0}}, {"y", {0, 1, 0}},
                    {"z", {0, 0, 1}},        {"hfov", 90},     {"vfov", 90}};
  return {{"paths", {{"paths", paths}, {"unwritten", json::array()}}},
          {"settings", {{"bounces", "5"}}},
          {"scene", {{"camera", camera}}},
          {"picture", "data:image/png;base64,"},
          {"ray", {{"t", 3.5}, {"primitives", 2}, {"all", 100}, {"tests", tests}}}};
}

Figure figure_of_view(const char* kind) {
  Figure figure;
  figure.id = kind;
  figure.kind = kind;
  figure.scenes = {"box"};
  figure.pixel = {3, 4};
  figure.size = {40, 30};
  return figure;
}

TEST_F(NumbersTest, the_longest_path_of_a_pixel_is_shown) {
  codes_.view = codes_.chosen;
  for (const grader::Task& task : grader::tasks()) codes_.view->hash[task.slug] = "a";
  const auto path = [](const std::vector<json>& bounces, double sum) {
    return json{{"bounces", bounces},
                {"sum", {sum, sum, sum}},
                {"traced", {sum, sum, sum}},
                {"same", true}};
  };
  const json all = view_of(
      {path({point_of_path(0, 9)}, 9), path({point_of_path(0, 0.5), point_of_path(1, 0.25)}, 0.75)},
      json::array());
  const Figure figure = figure_of_view("path");
  const Drawn got = drawn(figure, "view.json", all.dump(), draw_path);
  ASSERT_EQ(got.problems, std::vector<std::string>{});
  EXPECT_EQ(got.numbers.at("paths"), "2");
  EXPECT_EQ(got.numbers.at("points"), "2");
  EXPECT_EQ(got.numbers.at("direct"), "0.5");
  EXPECT_EQ(got.numbers.at("indirect"), "0.25");
  EXPECT_EQ(got.numbers.at("result"), "0.75");
  EXPECT_EQ(got.numbers.at("lights"), "2");
  EXPECT_EQ(got.numbers.at("hidden"), "1");
  ASSERT_EQ(got.rows.size(), 4u);
  EXPECT_EQ(got.rows[1].back(), "0.25: ends");
  for (const std::string& name : number_names(figure))
    EXPECT_TRUE(got.numbers.contains(name)) << name;
  const std::string svg = pt::read_file(folder_.path() + "/pages/path.svg");
  EXPECT_NE(svg.find("cx=\"360.0\" cy=\"180.0\""), std::string::npos) << svg;

  const Drawn none =
      drawn(figure, "view.json", view_of({path({}, 0)}, json::array()).dump(), draw_path);
  EXPECT_EQ(none.problems, std::vector<std::string>{"no ray of this pixel meets a surface"});
}

TEST_F(NumbersTest, tests_of_a_ray_are_counted_by_level) {
  codes_.view = codes_.chosen;
  for (const grader::Task& task : grader::tasks()) codes_.view->hash[task.slug] = "a";
  const json tests{
      {{"node", 1}, {"level", 1}, {"t", {2, 6}}, {"opened", true}},
      {{"node", 2}, {"level", 1}, {"t", nullptr}, {"opened", false}},
      {{"node", 3},
       {"level", 2},
       {"t", {2, 4}},
       {"opened", true},
       {"primitives", {{7, 3.5}, {8, nullptr}}}},
      {{"node", 4}, {"level", 2}, {"t", {4, 6}}, {"opened", false}, {"primitives", json::array()}}};
  const Figure figure = figure_of_view("ray");
  const Drawn got = drawn(figure, "view.json", view_of({}, tests).dump(), draw_ray);
  ASSERT_EQ(got.problems, std::vector<std::string>{});
  for (const std::string& name : number_names(figure))
    EXPECT_TRUE(got.numbers.contains(name)) << name;
  EXPECT_EQ(got.numbers.at("boxes"), "4");
  EXPECT_EQ(got.numbers.at("missed"), "1");
  EXPECT_EQ(got.numbers.at("behind"), "1");
  EXPECT_EQ(got.numbers.at("opened"), "2");
  EXPECT_EQ(got.numbers.at("leaves"), "1");
  EXPECT_EQ(got.numbers.at("primitives"), "2");
  EXPECT_EQ(got.numbers.at("t"), "3.5");
  EXPECT_EQ(got.rows[1], (std::vector<std::string>{"2", "2", "0", "1", "1", "1", "2"}));
}

// A task of a submission that cannot run is not replaced by the reference without a word.
TEST_F(NumbersTest, a_path_without_a_task_that_compiles_is_not_shown) {
  codes_.view = codes_.chosen;
  for (const grader::Task& task : grader::tasks()) codes_.view->hash[task.slug] = "a";
  codes_.view->unusable["trace_path"] = "does not compile";
  const Scenes scenes(catalogue_, "", "", "", false);
  const Store store(folder_.path() + "/renders");
  const Measurements measured(folder_.path() + "/measured", store);
  const Plan plan(catalogue_, codes_, scenes, store, measured, Quality::full);
  const auto failure = [&](const char* kind) {
    return measured.failure(plan.measurements(figure_of_view(kind)).at(0));
  };
  EXPECT_EQ(failure("path"), "trace_path does not compile");
  EXPECT_EQ(failure("ray"), "") << "it needs no light";
}

// Errors are divided by the luminance plus 4 % of the mean. In an even picture of this luminance, that is 1.
constexpr double kUnit = 1 / 1.04;

Rendered even(double luminance, const std::vector<double>& variances, int samples) {
  Rendered picture;
  picture.film = pt::Film(static_cast<int>(variances.size()), 1);
  for (std::size_t i = 0; i < variances.size(); ++i) {
    picture.film.pixels[i] = {pt::gray(luminance), {}, variances[i], samples};
  }
  return picture;
}

// A picture of one pixel at kUnit + .6 and one at kUnit - .2, with variances of 4 and 0 in 16 samples; d is part of kUnit.
TEST(Compose, the_parts_of_an_error_come_from_the_picture_and_its_variances) {
  const std::vector<double> even_light{kUnit, kUnit};
  Rendered picture = even(kUnit, {4, 0}, 16);
  picture.has_variance = true;
  picture.film.pixels[0].mean = pt::gray(kUnit + .6);
  picture.film.pixels[1].mean = pt::gray(kUnit - .2);
  const pt::Accuracy got = accuracy(picture, {even_light, even_light});
  EXPECT_NEAR(got.error.value, std::sqrt((.36 + .04) / 2), 1e-12);
  EXPECT_NEAR(got.noise.value().value, std::sqrt(.25 / 2), 1e-12);
  EXPECT_NEAR(got.bias2.value, (.36 + .04 - .25) / 2, 1e-12);
  EXPECT_NEAR(got.bias.value, .2 / kUnit, 1e-12);
  picture.has_variance = false;
  EXPECT_FALSE(accuracy(picture, {even_light, even_light}).noise);
}

// The noise of one pixel is 1 / 4, that of the other 1 / 2.
TEST(Compose, errors_of_pixels_are_apart_from_a_bias) {
  const std::vector<double> even_light{kUnit, kUnit};
  const pt::PixelErrors errors = pixel_noise(even(3, {1, 4}, 16), {even_light, even_light});
  EXPECT_NEAR(errors.median, .25, 1e-12);
  EXPECT_NEAR(errors.largest, .5, 1e-12);
}

// One pixel of four sees nothing and takes 96 of 128 samples; another is the lamp.
TEST(Compose, black_pixels_and_lamps_are_found) {
  const std::vector<double> light{1, 1, 0, 1};
  const pt::Goldens golden(light, light);
  Rendered picture = even(.5, {1, 1, 1, 1}, 8);
  picture.film.pixels[2].samples = 96;
  picture.film.pixels[3].samples = 16;
  EXPECT_NEAR(on_black(picture, golden).pixels, .25, 1e-12);
  EXPECT_NEAR(on_black(picture, golden).samples, .75, 1e-12);
  Rendered lamps = even(0, {0, 0, 0, 0}, 1);
  EXPECT_EQ(mean_on_lamps(picture.film, lamps.film), 0);
  lamps.film.pixels[1].mean = {5, 5, 5};
  lamps.film.pixels[0].mean = {2, 2, 2};  // the edge of the lamp, with other light in it
  picture.film.pixels[1].mean = {.2, .2, .2};
  EXPECT_NEAR(mean_on_lamps(picture.film, lamps.film), .2, 1e-12);
}

// 1.96 / .1, squared, are 384 samples of variance 1 and mean 1: 13 batches of 32.
TEST(Compose, adaptive_samples_are_whole_batches_up_to_the_most) {
  pt::Film film = even(1, {1, 0, 4, 1, 2.5}, 64).film;
  film.pixels[3].mean = {};
  EXPECT_EQ(predicted_samples(film, {1024, 32, .1}),
            (std::vector<int>{13 * 32, 32, 1024, 1024, 31 * 32}));
}

// Figures of invented pictures with equal pixels.
class MadeUp : public NumbersTest {
 protected:
  MadeUp() {
    const std::string scene = folder_.path() + "/room.dae";
    pt::write_file(scene, "a room");
    catalogue_.scenes["box"].own = scene;
    for (const grader::Task& task : grader::tasks()) codes_.chosen.hash[task.slug] = "a";
  }

  // Writes a render of the unit that took this many seconds.
  static void render(const Store& store, const Unit& unit, double seconds,
                     const measure::RowHead& a_row, const std::vector<measure::RowPixel>& pixels) {
    const measure::Spec& spec = unit.spec;
    for (const measure::Band& band : store.begin(unit, 1)) {
      for (int y = 0; y < spec.height; ++y) {
        measure::Row row;
        row.head = a_row;
        row.head.cpu_seconds = seconds / spec.height;
        for (int x = 0; x < spec.width; ++x) {
          row.pixels.push_back(
              pixels[static_cast<std::size_t>(y * spec.width + x) % pixels.size()]);
        }
        measure::append_row(band.file(), row);
      }
      measure::finish_band(band, {{}, std::string(name(spec.engine)), 14});
    }
  }

  // Renders every picture as `each` describes it, and draws the figure.
  template <class Each>
  Drawn drawn_by(const Figure& figure,
                 Drawn (*draw)(const Plan&, const Figure&, const std::filesystem::path&),
                 Each each) const {
    const Scenes scenes(catalogue_, "", "", "", false);
    const Store store(folder_.path() + "/renders");
    const Measurements measured(folder_.path() + "/measured", store);
    const Plan plan(catalogue_, codes_, scenes, store, measured, Quality::draft);
    each(plan);
    return draw(plan, figure, folder_.path() + "/pages");
  }

  // Of pictures that take .1 ms per pixel without a tree, and with it `of_tree` seconds.
  Drawn drawn_speedup(double of_tree) const {
    Figure figure;
    figure.id = "speedup";
    figure.kind = "speedup";
    figure.scenes = {"box"};
    return drawn_by(figure, draw_speedup, [&](const Plan& plan) {
      // The turns differ by a tenth, so that the mean of three is off by a tenth / sqrt(3).
      const auto make = [&](pt::Engine engine, double seconds_a_pixel,
                            const measure::RowHead& a_row) {
        for (int turn = 0; turn < kTurns; ++turn) {
          const Unit unit = plan.cell("box", engine, turn);
          const double busy = engine == pt::Engine::task ? .9 + .1 * turn : 1;
          render(plan.store(), unit, busy * seconds_a_pixel * unit.spec.pixels(), a_row,
                 {{{1, 1, 1}, 0, 1, -1}});
        }
      };
      make(pt::Engine::linear, 1e-4, {0, 10, 0, 120, 20, 0});
      make(pt::Engine::task, of_tree, {0, 10, 60, 20, 10, 0});
      make(pt::Engine::wide, 1e-6, {0, 10, 0, 0, 0, 0});
    });
  }

  static Picture picture(const std::string& id, int samples) {
    Picture picture;
    picture.id = picture.label = id;
    picture.scene = "box";
    picture.spec.width = 4;
    picture.spec.height = 3;
    picture.spec.samples = samples;
    return picture;
  }

  static std::vector<Picture> goldens() {
    std::vector<Picture> both{picture("golden", 1024), picture("golden", 1024)};
    both[1].spec.seed = 1002;
    return both;
  }
};

measure::RowPixel pixel(double luminance, int samples) {
  const auto value = static_cast<float>(luminance);
  return {{value, value, value}, 0, samples, -1};
}

// The best settings have 3 bounces: with 2, a tenth of the radiance would be missing.
TEST_F(MadeUp, a_table_of_what_is_left_out_has_the_bias_of_one_bounce_less) {
  Figure figure;
  figure.id = "left_out";
  figure.kind = "left_out";
  figure.scenes = {"box"};
  const json answer{
      {"known", 0},
      {"surfaces", 14},
      {"best", {{"samples", 16}, {"light_samples", 2}, {"bounces", 3}, {"seconds", 1.5}}},
      {"bias", {.5, .2, .1, .04, .01}},
      {"course", {{"times", {2.5, .14}}}},
      {"hemisphere", nullptr},
      {"survivals", json::array()},
      {"adaptive", .75},
      {"without_tree", nullptr},
      {"smooth", .25}};
  const Drawn got = drawn(figure, "cheapest.json", answer.dump(), draw_measured);
  ASSERT_EQ(got.problems, std::vector<std::string>{});
  ASSERT_EQ(got.rows.size(), 1u);
  EXPECT_EQ(got.rows[0],
            (std::vector<std::string>{"room", "2.5 \u00b1 0.1\u00d7", "\u2013", "\u2013",
                                      "0.75\u00d7", "\u2013", "25 %", "10 %"}));
  EXPECT_EQ(got.numbers.at("box.course"), "2.5");
  EXPECT_EQ(got.numbers.at("box.smooth"), "25");
}

// Factors have their uncertainties, and a method that never finds the light has none.
TEST_F(MadeUp, methods_are_compared_with_the_fastest) {
  const auto curve = [](const char* id, bool fails) {
    json points = json::array();
    for (int i = 0; i < 4; ++i) points.push_back({{"error", {.5, .01}}});
    points.back().update(
        {{"bias", fails ? .4 : 0}, {"pixels", {.1, .2, .3}}, {"black_samples", .25}});
    json all{
        {"id", id},       {"title", id},         {"adaptive", false}, {"heavy_tails", false},
        {"fails", fails}, {"slope", {-.5, .01}}, {"points", points},  {"beside", json::object()}};
    if (fails) all["slope"] = {nullptr, nullptr};  // without noise, no number
    if (!fails) {
      all["beside"]["l1"] = {{"time", {1.5, .03}}, {"error", {1.2, .01}}, {"rays", {30, 12}}};
    }
    return all;
  };
  Figure figure;
  figure.id = figure.kind = "converge";
  figure.scenes = {"box"};
  const json all{{"fastest", "l1"}, {"curves", {curve("l1", false), curve("h1", true)}}};
  const Drawn got = drawn(figure, "converge.json", all.dump(), draw_measured);
  ASSERT_EQ(got.problems, std::vector<std::string>{});
  ASSERT_EQ(got.rows.size(), 2u);
  const std::vector<std::string> errors{"50 %", "50 %", "50 %", "50 %"},
      pixels{"10 %", "20 %", "30 %", "25 %"};
  const auto expect_row = [&](std::size_t i, const std::vector<std::string>& middle) {
    std::vector<std::string> row{i == 0 ? "l1" : "h1"};
    for (const auto* part : {&errors, &middle, &pixels})
      row.insert(row.end(), part->begin(), part->end());
    EXPECT_EQ(got.rows[i], row);
    EXPECT_EQ(got.columns.size(), row.size());
  };
  expect_row(0, {"-0.500 \u00b1 0.010", "1.50 \u00b1 0.03\u00d7", "1.20 \u00b1 0.01\u00d7",
                 "30 \u00b1 12\u00d7", "\u2013"});
  expect_row(1, {"\u2013", "never", "never", "never", "40 %"});
  EXPECT_EQ(got.numbers.at("h1.error"), "50");
  EXPECT_FALSE(got.numbers.contains("h1.beside.l1.time"));
  EXPECT_EQ(got.numbers.at("l1.beside.l1.time"), "1.5");

  // Several codes: the table has a line of each, with its name, and the numbers are those of the first.
  json several = all;
  const auto code = [&](const char* name, const json& curves, const char* problem) {
    return json{{"name", name}, {"fastest", "l1"}, {"curves", curves}, {"problem", problem}};
  };
  several["codes"] = {code("reference", all.at("curves"), ""),
                      code("anna", json::array({curve("l1", false)}), ""),
                      code("ben", nullptr, "it crashed")};
  const Drawn beside = drawn(figure, "converge.json", several.dump(), draw_measured);
  EXPECT_EQ(beside.problems, std::vector<std::string>{"ben: it crashed"});
  ASSERT_EQ(beside.rows.size(), 3u);
  EXPECT_EQ(beside.rows[0][0], "reference: l1");
  EXPECT_EQ(beside.rows[2][0], "anna: l1");
  EXPECT_EQ(beside.numbers, got.numbers);
}

TEST(Catalogue, has_each_picture_once_more_by_each_submission) {
  Catalogue catalogue;
  Figure figure;
  figure.id = "direct";
  Picture few, many, wrong;
  few.id = few.label = "s16";
  many.id = many.label = "same_time";
  many.time_of = "s16";
  wrong.id = wrong.label = "bug";
  wrong.mistake = "bsdf_applied_twice";
  figure.pictures = {few, many, wrong};
  figure.goldens = {few, few};
  catalogue.figures = {figure};
  add_codes(catalogue, {"anna", "ben"});
  const Figure& all = catalogue.figures[0];
  std::vector<std::string> labels;
  for (const Picture& picture : all.pictures) labels.push_back(picture.label);
  EXPECT_EQ(labels, (std::vector<std::string>{"reference: s16", "anna: s16", "ben: s16",
                                              "reference: same_time", "anna: same_time",
                                              "ben: same_time", "bug"}));
  EXPECT_EQ(all.pictures[5].id, "same_time_ben");
  EXPECT_EQ(all.pictures[5].mistake, other_code("ben"));
  EXPECT_EQ(all.pictures[5].time_of, "s16_ben") << "the time of the same code";
  EXPECT_EQ(all.pictures[3].time_of, "s16");
  EXPECT_NE(all.source, figure.source) << "it is drawn anew";
  EXPECT_EQ(all.goldens.size(), 2u);
}

// .01 ms per pixel with a tree: 480 x 360 pixels take 17.28 s without it, and 1.728 s with it.
TEST_F(MadeUp, a_tree_is_as_many_times_as_fast) {
  const Drawn got = drawn_speedup(1e-5);
  EXPECT_EQ(got.problems, std::vector<std::string>{});
  EXPECT_EQ(got.numbers.at("box"), "10");
  EXPECT_EQ(got.numbers.at("box.linear"), "17.3");
  EXPECT_EQ(got.numbers.at("box.tree"), "1.73");
  EXPECT_EQ(got.numbers.at("box.linear_tests"), "14");
  EXPECT_EQ(got.numbers.at("box.tests"), "9");
  ASSERT_EQ(got.rows.size(), 1u);
  EXPECT_EQ(got.rows[0], (std::vector<std::string>{"room", "14", "17.3", "1.73", "0.173",
                                                   "10.0 \u00b1 0.6\u00d7", "14", "9"}));
}

TEST_F(MadeUp, a_tree_that_is_not_measured_has_no_factor) {
  const Drawn got = drawn_speedup(0);
  EXPECT_EQ(got.problems, std::vector<std::string>{"room: not measured"});
  EXPECT_EQ(got.rows.at(0).at(5), "\u2013");
  EXPECT_FALSE(got.numbers.contains("box"));
}

// Variances of 1 and 9 where the brightness is the same: samples in proportion to them draw with the same number
// everywhere, and samples in proportion to 1 and 3 need 2^2 / 5 of them.
TEST_F(MadeUp, a_rule_for_samples_can_draw_or_win) {
  Figure figure;
  figure.id = figure.kind = "rules";
  figure.goldens = goldens();
  figure.pictures = {picture("uniform", 1 << 20)};
  figure.pictures[0].look = Look::predicted;
  figure.pictures[0].spec.adaptive = pt::AdaptiveSettings{1 << 20, 2, .01};
  constexpr auto kBright = static_cast<float>(kUnit);
  const measure::RowPixel quiet{{kBright, kBright, kBright}, 1, 4, -1},
      noisy{{kBright, kBright, kBright}, 9, 4, -1};
  const auto draw = [&](const std::vector<measure::RowPixel>& pixels) {
    return drawn_by(figure, draw_rules, [&](const Plan& plan) {
      render(plan.store(), plan.uniform(figure.pictures[0]), 1, {}, pixels);
      for (const Picture& golden : figure.goldens) {
        render(plan.store(), plan.units(figure, golden).at(0), 1, {}, pixels);
      }
    });
  };
  const Drawn got = draw({quiet, noisy});
  ASSERT_EQ(got.problems, std::vector<std::string>{});
  const double drawn = std::stod(got.numbers.at("contract.error"));
  EXPECT_NEAR(std::stod(got.numbers.at("uniform.error")), drawn, .01 * drawn);
  EXPECT_NEAR(std::stod(got.numbers.at("root.error")), std::sqrt(.8) * drawn, .01 * drawn);
  EXPECT_EQ(got.numbers.at("contract.largest"), got.numbers.at("contract.median"));
  EXPECT_NEAR(std::stod(got.numbers.at("uniform.largest")),
              3 * std::stod(got.numbers.at("uniform.median")), .01);
  // Each pixel has a neighbour of the larger variance.
  EXPECT_EQ(got.numbers.at("neighbours.error"), got.numbers.at("uniform.error"));
  for (const std::string& name : number_names(figure))
    EXPECT_TRUE(got.numbers.contains(name)) << name;
}

// Twice the error in half the time: for the same error it takes twice as long as the other. Half the light is missing in a third
// picture, which has no such time.
TEST_F(MadeUp, a_method_costs_time_times_the_square_of_its_error) {
  Figure figure;
  figure.id = "methods";
  figure.kind = "pictures";
  figure.goldens = goldens();
  figure.pictures = {picture("slow", 16), picture("fast", 8), picture("dark", 4)};
  const Drawn got = drawn_by(figure, draw_pictures, [&](const Plan& plan) {
    const auto make = [&](const Picture& of, double seconds, double mean, double noise) {
      std::vector<measure::RowPixel> pixels;
      for (const double sign : {-1., 1.}) {
        pixels.push_back(pixel(mean + sign * noise, of.spec.samples));
        pixels.back().variance_y = static_cast<float>(1.001 * noise * noise * of.spec.samples);
      }
      render(plan.store(), plan.units(figure, of).at(0), seconds, {}, pixels);
    };
    for (const Picture& golden : figure.goldens) make(golden, 100, kUnit, 0);
    make(figure.pictures[0], 2, kUnit, .11);
    make(figure.pictures[1], 1, kUnit, .22);
    make(figure.pictures[2], 1, kUnit / 2, .11);
  });
  EXPECT_EQ(got.problems, std::vector<std::string>{});
  EXPECT_EQ(got.numbers.at("slow.error"), "11.0");
  EXPECT_EQ(got.numbers.at("fast.error"), "22.0");
  EXPECT_EQ(got.numbers.at("slow.factor"), "1.00");
  EXPECT_EQ(got.numbers.at("fast.factor"), "2.00");
  EXPECT_EQ(got.numbers.at("fast.wrong"), "0");
  EXPECT_EQ(got.numbers.at("fast.pixel_largest"), "22.0");
  EXPECT_EQ(got.numbers.at("dark.wrong"), "1");
  EXPECT_EQ(got.numbers.at("dark.bias"), "-50");
  EXPECT_EQ(got.numbers.at("dark.noise"), "11.0");
  EXPECT_FALSE(got.numbers.contains("dark.factor"));
  EXPECT_EQ(got.rows.at(2).back(), "never");
  EXPECT_THAT(got.pictures.at(2).facts, testing::EndsWith(": 11.0 % noise, and 50.0 % too dark"));
  EXPECT_THAT(got.pictures.at(1).facts, testing::EndsWith("; error 22.000 \u00b1 0.000 %"));
}

// The left half is right, the right half has half the light.
TEST_F(MadeUp, a_part_of_a_picture_has_its_own_error_and_a_map_shows_that_of_each_pixel) {
  Figure figure;
  figure.id = "parts";
  figure.kind = "pictures";
  figure.goldens = goldens();
  figure.pictures = {picture("left", 16), picture("right", 16), picture("map", 16)};
  figure.pictures[0].crop = {0, 0, .5, 1};
  figure.pictures[1].crop = {.5, 0, .5, 1};
  figure.pictures[2].look = Look::error;
  const Drawn got = drawn_by(figure, draw_pictures, [&](const Plan& plan) {
    const auto make = [&](const Picture& of, double right) {
      render(plan.store(), plan.units(figure, of).at(0), 1, {},
             {pixel(kUnit, 16), pixel(kUnit, 16), pixel(right, 16), pixel(right, 16)});
    };
    for (const Picture& golden : figure.goldens) make(golden, kUnit);
    make(figure.pictures[0], kUnit / 2);
  });
  EXPECT_EQ(got.problems, std::vector<std::string>{});
  EXPECT_EQ(got.numbers.at("left.error"), "0");
  EXPECT_EQ(got.numbers.at("right.bias"), "-50");
  EXPECT_EQ(got.numbers.at("map.average"), "24.0");  // 25 / 1.04
  EXPECT_EQ(got.numbers.at("map.most"), "48.1");
  EXPECT_EQ(got.pictures.at(1).width, 2);
  EXPECT_EQ(got.pictures.at(1).height, 3);
  EXPECT_EQ(got.rows, std::vector<std::vector<std::string>>{});
}

// In a draft, pictures that differ in s are different pictures, and their labels are true.
TEST_F(MadeUp, a_draft_has_the_samples_of_its_labels) {
  Figure figure;
  figure.id = "rates";
  figure.kind = "pictures";
  for (const int samples : {1, 2, 4, 8, 16, 64, 1024}) {
    figure.pictures.push_back(picture("s" + std::to_string(samples), samples));
    figure.pictures.back().label = "s = " + std::to_string(samples);
    figure.pictures.back().spec.width = 480;
  }
  const Drawn got = drawn_by(figure, draw_pictures, [&](const Plan& plan) {
    for (const Picture& each : figure.pictures) {
      const Unit unit = plan.units(figure, each).at(0);
      render(plan.store(), unit, 1, {}, {pixel(1, unit.spec.samples)});
    }
  });
  std::vector<std::string> labels;
  for (const Shown& shown : got.pictures) labels.push_back(shown.label);
  EXPECT_EQ(labels, (std::vector<std::string>{"s = 1", "s = 2", "s = 4", "s = 8", "s = 16",
                                              "s = 64", "s = 128"}));
  EXPECT_EQ(got.numbers.at("s1024.samples"), "128");
  // Settings in the label are not said again beside it.
  EXPECT_EQ(got.pictures.back().facts, "l = 1, m = 1; 1.00 s");
}

// Pixels that stop after one batch, or never, do not enter the ratio.
TEST_F(MadeUp, rates_are_compared_where_they_could_be_others) {
  Figure figure;
  figure.id = "rates";
  figure.kind = "pictures";
  for (const double tolerance : {.1, .05}) {
    figure.pictures.push_back(picture(tolerance == .1 ? "first" : "second", 1024));
    figure.pictures.back().look = Look::rates;
    figure.pictures.back().spec.adaptive = pt::AdaptiveSettings{1024, 32, tolerance};
  }
  const Drawn got = drawn_by(figure, draw_pictures, [&](const Plan& plan) {
    const auto make = [&](const Picture& of, const std::vector<measure::RowPixel>& pixels) {
      render(plan.store(), plan.units(figure, of).at(0), 1, {}, pixels);
    };
    make(figure.pictures[0], {pixel(1, 128), pixel(1, 32), pixel(1, 1024), pixel(1, 128)});
    make(figure.pictures[1], {pixel(1, 192), pixel(1, 512), pixel(1, 32), pixel(1, 192)});
  });
  EXPECT_EQ(got.problems, std::vector<std::string>{});
  EXPECT_EQ(got.numbers.at("first.ratio"), "1.00");
  EXPECT_EQ(got.numbers.at("second.ratio"), "1.50");
  EXPECT_EQ(got.numbers.at("second.average"), "232");
  EXPECT_EQ(got.numbers.at("second.median"), "192");
  EXPECT_EQ(got.numbers.at("second.tolerance"), "5");
  EXPECT_EQ(got.numbers.at("second.most"), "512");
}

}  // namespace
}  // namespace writeup
