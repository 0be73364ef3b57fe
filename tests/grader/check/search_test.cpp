// The search for bad inputs: it climbs where chance alone would find nothing, keeps inputs that
// break a promise, and continues where it stopped.
#include "grader/check/generators/generators.h"
#include "grader/check/language/bad_inputs.h"
#include "grader/check/language/property.h"
#include "pt/file.h"
#include "tests/fixtures/temporary_folder.h"

#include <cmath>
#include <map>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace grader::check {
namespace {

using nlohmann::json;

// Two numbers, both of which have to be right: one random try in a million is within a thousandth.
SEARCH(test, peak) {
  return {.title = "a peak", .measure = "", .badness = [] {
            const double x = *real(0, 1), y = *magnitude(1e-3, 1e3);
            show_input([&] { return show(x) + " " + show(y); });
            return 1 / (1e-12 + std::abs(x - 0.73) + std::abs(y / 17 - 1));
          }};
}

SEARCH(test, breaks) {
  return {.title = "no answer", .measure = "", .badness = [] {
            const int n = *whole(0, 3);
            show_input([&] { return std::to_string(n); });
            expect(n != 2, "a hit", "no hit");
            return n == 1 ? std::nan("") : 1.0;
          }};
}

struct Searched {
  json all;
  int begun = 0;  // number of pieces that have begun
};

// Tries at least this many inputs, in as many pieces as that takes.
Searched search_until(const std::string& file, long long inputs) {
  Searched searched;
  do {
    run_searches({3, 0.05, file, [&] { ++searched.begun; }});
    searched.all = json::parse(pt::read_file(file, 1 << 22));
  } while (searched.all[0].at("tried") < inputs);
  return searched;
}

TEST(search, climbs_shows_and_goes_on) {
  const TemporaryFolder folder;
  const std::string file = folder.path() + "/search.json";
  const auto [first, begun] = search_until(file, 100);
  // Some thousand inputs are usually enough; chance alone would need a million times a million.
  json last = search_until(file, 100).all;
  while (last[0].at("worst")[0].at("badness") < 1e6 && last[0].at("tried") < 300000) {
    last = search_until(file, 100).all;
  }
  EXPECT_GT(begun, 0);
  // The shortest piece is a hundred inputs.
  run_searches({3, 1e-9, file, [] {}});
  const json after = json::parse(pt::read_file(file, 1 << 22));
  EXPECT_EQ(after[0].at("tried").get<int>(), last[0].at("tried").get<int>() + 100);
  EXPECT_GE(after[0].at("worst")[0].at("badness"), last[0].at("worst")[0].at("badness"));
  const json& worst = last[0].at("worst");
  EXPECT_GE(worst[0].at("badness"), first[0].at("worst")[0].at("badness"));
  EXPECT_GT(worst[0].at("badness"), 1e6);
  EXPECT_NEAR(std::stod(worst[0].at("input").get<std::string>()), 0.73, 1e-5);
  EXPECT_GT(worst.size(), 3U);
  for (std::size_t i = 1; i < worst.size(); ++i) {
    EXPECT_LT(worst[i].at("badness"), worst[i - 1].at("badness"));
  }
}

// If variants of the worst input were kept, they would displace all others and hide a second peak.
TEST(search, keeps_inputs_of_several_families) {
  const TemporaryFolder folder;
  const json all = search_until(folder.path() + "/search.json", 5000).all;
  std::map<long long, int> of_a_family;
  for (const json& input : all[0].at("worst")) ++of_a_family[input.at("family").get<long long>()];
  EXPECT_GE(of_a_family.size(), 6U);
  for (const auto& [family, inputs] : of_a_family) EXPECT_LE(inputs, 2) << family;
}

TEST(search, what_fails_or_is_not_a_number_is_broken) {
  const TemporaryFolder folder;
  const json all = search_until(folder.path() + "/search.json", 100).all;
  const json& worst = all[1].at("worst");
  ASSERT_EQ(worst.size(), 2U);
  EXPECT_EQ(worst[0].at("badness"), kBroken);
  EXPECT_TRUE(worst[0].at("input") == "1" || worst[0].at("input") == "2");
  EXPECT_EQ(worst[1].at("badness"), 1);
}

// Without a search, the generators are RapidCheck's own again.
TEST(search, leaves_the_generators_as_they_were) {
  const auto drawn = [] {
    return rc::gen::exec([] { return *real(0, 1) + *whole(0, 100); })(rc::Random(5), 100).value();
  };
  const double before = drawn();
  const TemporaryFolder folder;
  search_until(folder.path() + "/search.json", 100);
  EXPECT_EQ(drawn(), before);
}

}  // namespace
}  // namespace grader::check
