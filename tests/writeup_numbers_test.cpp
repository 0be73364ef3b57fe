// The numbers of figures that are measured, from the files of a measurement.
#include "pt/file.h"
#include "tests/temporary_folder.h"
#include "writeup/figure.h"

#include <cmath>

#include <gtest/gtest.h>

namespace writeup {
namespace {

using nlohmann::json;

// A plan for one figure, whose measurement says what a test wants.
class NumbersTest : public testing::Test {
 protected:
  NumbersTest() {
    Code code;
    code.hash = {{"hit_sphere", "a"}, {"framework", "b"}};
    codes_.chosen = code;
    codes_.accuracy = codes_.stability = codes_.measure = code;
    catalogue_.scenes["box"].own = "scenes/box_spheres.dae";
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

// From 1e-4 at 100 to 1e-2 at 10000: 1e-3 is half of the way on both axes, at 1000.
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
                      line("stops", {1e-9, 1e-9, nullptr}), line("bad", {.5, .25, .5})}}}}}};
  const Drawn got = drawn(figure, "stability.json", all.dump(), draw_curve);
  ASSERT_EQ(got.problems, std::vector<std::string>{});
  EXPECT_EQ(got.numbers.at("climbs.fails"), "1000");
  EXPECT_EQ(got.numbers.at("climbs.first"), "1e-6");
  EXPECT_EQ(got.numbers.at("climbs.last"), "0.01");
  EXPECT_EQ(got.numbers.at("stays.fails"), "\u2013");
  EXPECT_EQ(got.numbers.at("stays.largest"), "0.001");
  EXPECT_EQ(got.numbers.at("stops.fails"), "10000");
  EXPECT_EQ(got.numbers.at("stops.last"), "none");
  EXPECT_EQ(got.numbers.at("bad.fails"), "1");
}

// Half and an eighth of the time: a quarter in the geometric mean. A case without a number of both counts for nothing.
TEST_F(NumbersTest, a_remedy_costs_the_mean_factor_of_all_cases) {
  Figure figure;
  figure.kind = "prices";
  figure.prices = {{"far", "the sphere is far away", "hit_sphere", "reference", "half_b"}};
  const std::string csv =
      "task,case,implementation,nanoseconds,time_x_variance\n"
      "hit_sphere,\"near\",\"reference\",10,\nhit_sphere,\"near\",\"half_b\",5,\n"
      "hit_sphere,\"far\",\"reference\",80,\nhit_sphere,\"far\",\"half_b\",10,\n"
      "hit_sphere,\"alone\",\"half_b\",1000,\nhit_box,\"near\",\"half_b\",1000,\n";
  const Drawn got = drawn(figure, "measure.csv", csv, draw_prices);
  EXPECT_EQ(got.numbers.at("far.time"), "0.25");
  EXPECT_FALSE(got.numbers.contains("far.work"));
}

}  // namespace
}  // namespace writeup
