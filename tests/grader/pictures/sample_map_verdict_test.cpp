// The verdict on a sample map, on maps of the right rule and of known mistakes.
#include "grader/pictures/statistics/sample_map_verdict.h"

#include "pt/error.h"
#include "pt/file.h"
#include "tests/grader/pictures/synthetic_maps.h"

#include <cstdio>
#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

namespace grader::pictures {
namespace {

using testing::HasSubstr;

const pt::AdaptiveSettings kSettings{512, 16, 0.1};
const AdaptiveScene& scene() {
  static const AdaptiveScene all = adaptive_scene(48, 36);
  return all;
}
const SampleMapReference& reference() {
  static const SampleMapReference made = synthetic_reference(scene(), kSettings);
  return made;
}

pt::SampleMap map_of(StoppingRule rule, double variance = 1, std::uint64_t seed = 1000) {
  return run_adaptive(scene(), kSettings, rule, variance, seed).map;
}

SampleMapVerdict judge(StoppingRule rule, double variance = 1, std::uint64_t seed = 1000) {
  SampleMapVerdict verdict = judge_sample_map(reference(), map_of(rule, variance, seed));
  std::printf("rule %d, variance %.2f: ratio %.2f, a %.2f, b %.2f, correlation %.2f, %s %s\n",
              static_cast<int>(rule), variance, verdict.ratio, verdict.a, verdict.b,
              verdict.correlation, verdict.pass ? "pass" : "fail", verdict.sentence.c_str());
  return verdict;
}

TEST(sample_map, right_maps_pass) {
  for (std::uint64_t seed = 1000; seed < 1050; ++seed) {
    for (const StoppingRule rule : {StoppingRule::right, StoppingRule::right_n}) {
      const SampleMapVerdict verdict = judge_sample_map(reference(), map_of(rule, 1, seed));
      EXPECT_TRUE(verdict.pass) << seed << ": " << verdict.sentence;
      EXPECT_EQ(verdict.sentence, "");
      EXPECT_NEAR(verdict.ratio, 1, 0.06);
      EXPECT_NEAR(verdict.b, 1, 0.06);
      EXPECT_NEAR(verdict.a, 0, 0.2);
      EXPECT_GT(verdict.correlation, 0.85);
    }
  }
}

// Another survival probability changes the variance of a sample and nothing else.
TEST(sample_map, a_little_more_variance_passes_and_is_told) {
  const SampleMapVerdict more = judge(StoppingRule::right, 1.08);
  EXPECT_TRUE(more.pass);
  EXPECT_THAT(more.sentence, HasSubstr("more variance"));
  const SampleMapVerdict less = judge(StoppingRule::right, 0.93);
  EXPECT_TRUE(less.pass);
  EXPECT_THAT(less.sentence, HasSubstr("less variance"));
  EXPECT_FALSE(judge(StoppingRule::right, 1.3).pass);
  EXPECT_FALSE(judge(StoppingRule::right, 0.75).pass);
}

TEST(sample_map, every_mistake_of_the_table_fails) {
  struct Row {
    StoppingRule rule;
    const char* words;
  };
  const Row rows[] = {{StoppingRule::running_total, "do not depend on the pixel"},
                      {StoppingRule::every_sample, "not a multiple of the batch"},
                      {StoppingRule::sigma_over_n, "stops after its first batch"},
                      {StoppingRule::no_1_96, "1.96"},
                      {StoppingRule::absolute, ""},
                      {StoppingRule::one_batch_short, "one batch less"},
                      {StoppingRule::one_channel, ""},
                      {StoppingRule::constant_goes_on, "samples are all alike"}};
  for (const Row& row : rows) {
    for (std::uint64_t seed = 1000; seed < 1003; ++seed) {
      const SampleMapVerdict verdict = judge(row.rule, 1, seed);
      EXPECT_FALSE(verdict.pass) << static_cast<int>(row.rule);
      EXPECT_THAT(verdict.sentence, HasSubstr(row.words));
      EXPECT_NE(verdict.sentence, "");
    }
  }
}

// Pixels that take from 20 to 319 batches, the same in every run.
struct ManyBatches {
  SampleMapReference reference;
  pt::SampleMap map;
};

ManyBatches many_batches(int max_samples) {
  ManyBatches many{reference(), {scene().width, scene().height, {}, max_samples}};
  many.reference.settings.max_samples = max_samples;
  for (std::size_t i = 0; i < many.reference.mean.size(); ++i) {
    const int count = (20 + static_cast<int>(i % 300)) * kSettings.batch;
    many.map.counts.push_back(count);
    many.reference.mean[i] = count;
    many.reference.deviation[i] = kSettings.batch;
    many.reference.constant[i] = 0;
  }
  return many;
}

// In pixels that need many batches, one batch more or less hardly changes the ratio.
TEST(sample_map, a_batch_more_or_less_everywhere_fails) {
  const auto [golden, map] = many_batches(500 * kSettings.batch);
  EXPECT_TRUE(judge_sample_map(golden, map).pass);
  for (const int off : {-kSettings.batch, kSettings.batch}) {
    pt::SampleMap shifted = map;
    for (int& count : shifted.counts) count += off;
    EXPECT_FALSE(judge_sample_map(golden, shifted).pass) << off;
  }
}

// One pixel has a fifth of the samples, the next nine fifths: their total is the reference's.
TEST(sample_map, that_follows_the_reference_in_the_mean_alone_fails) {
  auto [golden, map] = many_batches(700 * kSettings.batch);
  for (std::size_t i = 0; i < map.counts.size(); ++i) {
    const int fifth = (4 + static_cast<int>(i / 2 % 60)) * kSettings.batch;
    golden.mean[i] = 5 * fifth;
    map.counts[i] = (i % 2 == 0 ? 1 : 9) * fifth;
  }
  const SampleMapVerdict verdict = judge_sample_map(golden, map);
  EXPECT_NEAR(verdict.a, 0, 1e-9);
  EXPECT_NEAR(verdict.b, 1, 1e-9);
  EXPECT_NEAR(verdict.ratio, 1, 1e-9);
  EXPECT_LT(verdict.correlation, 0.7);
  EXPECT_FALSE(verdict.pass);
}

TEST(sample_map, the_last_batch_may_be_cut_short_by_the_maximum) {
  const int max_samples = 400 * kSettings.batch + 3;
  auto [golden, map] = many_batches(max_samples);
  for (std::size_t i = 0; i < map.counts.size(); i += 10) {
    golden.mean[i] = map.counts[i] = max_samples;
  }
  const SampleMapVerdict verdict = judge_sample_map(golden, map);
  EXPECT_TRUE(verdict.pass) << verdict.sentence;
  for (std::size_t i = 0; i < map.counts.size(); i += 10) map.counts[i] -= 1;
  EXPECT_FALSE(judge_sample_map(golden, map).pass);
}

TEST(sample_map, the_maximum_everywhere_is_said_to_be_that) {
  pt::SampleMap map = map_of(StoppingRule::right);
  for (int& count : map.counts) count = kSettings.max_samples;
  const SampleMapVerdict verdict = judge_sample_map(reference(), map);
  EXPECT_FALSE(verdict.pass);
  EXPECT_THAT(verdict.sentence, HasSubstr("nearly every pixel takes the maximum"));
}

// < and <= differ only if every sample is zero, and such pixels are not judged.
TEST(sample_map, black_pixels_may_stop_or_go_on) {
  for (const int count : {kSettings.batch, kSettings.max_samples}) {
    pt::SampleMap map = map_of(StoppingRule::right);
    for (std::size_t i = 0; i < map.counts.size(); ++i) {
      if (scene().black[i]) map.counts[i] = count;
    }
    EXPECT_TRUE(judge_sample_map(reference(), map).pass);
  }
}

TEST(sample_map, counts_that_cannot_be_fail) {
  pt::SampleMap map = map_of(StoppingRule::right);
  map.counts[700] = kSettings.max_samples + kSettings.batch;
  EXPECT_EQ(judge_sample_map(reference(), map).sentence,
            "0.1 % of the pixels took less than a batch (16) or more than the maximum (512)");
  map.counts[700] = 0;
  EXPECT_FALSE(judge_sample_map(reference(), map).pass);
  // One pixel in 1728 is fewer than one in a thousand.
  map.counts[700] = kSettings.batch + 1;
  EXPECT_TRUE(judge_sample_map(reference(), map).pass);
  map.counts[701] = kSettings.batch + 1;
  EXPECT_FALSE(judge_sample_map(reference(), map).pass);
  map.width = 47;
  EXPECT_THAT(judge_sample_map(reference(), map).sentence, HasSubstr("47 x 36"));
}

TEST(sample_map, equal_counts_everywhere_fail) {
  for (int batches = 1; batches <= kSettings.max_samples / kSettings.batch; ++batches) {
    pt::SampleMap map = map_of(StoppingRule::right);
    for (int& count : map.counts) count = batches * kSettings.batch;
    EXPECT_FALSE(judge_sample_map(reference(), map).pass) << batches;
  }
}

class ReferenceFile : public testing::Test {
 protected:
  ReferenceFile() { std::filesystem::create_directories(folder_); }
  ~ReferenceFile() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path folder_ = std::filesystem::temp_directory_path() /
                                  ("sample_map_verdict_test." + std::to_string(getpid()));
  std::filesystem::path path_ = folder_ / "map.json";
};

TEST_F(ReferenceFile, what_is_written_comes_back) {
  write_reference(path_, reference());
  const SampleMapReference back = read_reference(path_);
  EXPECT_EQ(back.width, 48);
  EXPECT_EQ(back.height, 36);
  EXPECT_EQ(back.runs, 64);
  EXPECT_EQ(back.settings.max_samples, kSettings.max_samples);
  EXPECT_EQ(back.settings.batch, kSettings.batch);
  EXPECT_EQ(back.settings.tolerance, kSettings.tolerance);
  EXPECT_EQ(back.always_one_batch, reference().always_one_batch);
  EXPECT_EQ(back.constant, reference().constant);
  EXPECT_EQ(back.all_zero, reference().all_zero);
  ASSERT_EQ(back.mean.size(), reference().mean.size());
  for (std::size_t i = 0; i < back.mean.size(); ++i) {
    EXPECT_NEAR(back.mean[i], reference().mean[i], 1e-4);
    EXPECT_NEAR(back.deviation[i], reference().deviation[i], 1e-2 * reference().deviation[i]);
  }
  EXPECT_LT(std::filesystem::file_size(path_), 48u * 36 * 20);
}

TEST_F(ReferenceFile, what_is_none_is_refused_by_name) {
  write_reference(path_, reference());
  const std::string text = pt::read_file(path_, 1 << 24);
  for (const std::string& bad : {std::string("{}"), text.substr(0, text.size() / 2),
                                 std::string(text).replace(text.find("48"), 2, "47"),
                                 std::string(text).replace(text.find("48"), 2, "-1"),
                                 std::string(text).replace(text.find("0.1"), 3, "0.0")}) {
    pt::write_file(path_, bad);
    EXPECT_THROW(
        {
          try {
            read_reference(path_);
          } catch (const pt::Error& error) {
            EXPECT_THAT(error.what(), HasSubstr(path_.string()));
            throw;
          }
        },
        pt::Error);
  }
  EXPECT_THROW(read_reference(folder_ / "none.json"), pt::Error);
}

TEST(sample_map, a_reference_that_says_too_little_is_refused) {
  const std::vector<pt::SampleMap> runs(64, map_of(StoppingRule::right));
  const pt::Film picture(48, 36);
  EXPECT_NO_THROW(reference_of(runs, picture, kSettings));
  EXPECT_THROW(reference_of(std::span(runs).first(3), picture, kSettings), pt::Error);
  EXPECT_THROW(reference_of(runs, pt::Film(36, 48), kSettings), pt::Error);
  std::vector<pt::SampleMap> flat = runs;
  for (pt::SampleMap& map : flat) {
    for (int& count : map.counts) count = kSettings.batch;
  }
  EXPECT_THROW(reference_of(flat, picture, kSettings), pt::Error);
}

}  // namespace
}  // namespace grader::pictures
