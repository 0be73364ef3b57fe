// Measures how often the verdict on a picture fails right pictures and finds known mistakes, against the samples
// spent. The pictures are 96 x 72, from known distributions (tests/grader/pictures/synthetic_pictures.h). Writes
// verdict_power.csv for verdict_power.gp, and prints the tables of docs/verdicts.md.
#include "bench/report.h"
#include "grader/pictures/statistics/cells.h"
#include "pt/command_line.h"
#include "tests/grader/pictures/synthetic_maps.h"
#include "tests/grader/pictures/synthetic_pictures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace grader::pictures {
namespace {

using Outcome = pictures::ImageVerdict::Outcome;

constexpr int kWidth = 96, kHeight = 72;
constexpr std::array<std::pair<Spread, const char*>, 3> kSpreads{
    {{Spread::diffuse, "diffuse"},
     {Spread::fireflies, "fireflies"},
     {Spread::mostly_zero, "mostly zero"}}};

pictures::NoiseClass noise_of(Spread spread) {
  return spread == Spread::diffuse ? pictures::NoiseClass::ordinary : pictures::NoiseClass::noisy;
}

// 16 times the samples of the last round, as a golden must have.
int golden_samples(const std::array<Round, 3>& rounds) { return 16 * 16 * rounds[2].samples; }

struct Tally {
  std::array<int, 3> failing{};  // pictures that failed round 1, 2, 3
  int wrong = 0;
  int too_noisy = 0;
  double noisiest = 0;
};

Tally judge_many(const SyntheticScene& right, const SyntheticScene& submitted,
                 pictures::NoiseClass noise, const std::array<Round, 3>& rounds, int pictures,
                 std::uint64_t seed) {
  constexpr int kPicturesAGolden = 50;
  Tally tally;
  pt::Film golden;
  for (int i = 0; i < pictures; ++i) {
    const std::uint64_t own = seed + static_cast<std::uint64_t>(i);
    if (i % kPicturesAGolden == 0) {
      golden = Draw(~own).golden(right, golden_samples(rounds));
    }
    const auto verdict =
        pictures::judge_image(golden, noise, submission(submitted, own), 3, rounds);
    const bool passed = verdict.outcome == Outcome::pass;
    const int failed_rounds = passed ? verdict.rounds - 1 : verdict.rounds;
    for (int round = 0; round < failed_rounds; ++round) ++tally.failing[round];
    if (verdict.outcome == Outcome::too_noisy) {
      ++tally.too_noisy;
    } else if (!passed) {
      ++tally.wrong;
    }
    tally.noisiest = std::max(tally.noisiest, verdict.noise);
  }
  return tally;
}

void print_false_failures(int pictures) {
  fmt::print("Right pictures: how many of {} fail each round\n", pictures);
  fmt::print("{:<34}{:>9}{:>9}{:>9}{:>11}{:>16}\n", "", "round 1", "round 2", "round 3",
             "too noisy", "largest noise");
  for (const auto& [spread, name] : kSpreads) {
    const SyntheticScene scene = synthetic_scene(spread, kWidth, kHeight);
    for (const double variance : {1.0, 2.0, 0.5}) {
      SyntheticScene submitted = scene;
      for (SyntheticPixel& pixel : submitted.pixels) pixel.shape /= variance;
      const auto rounds = pictures::rounds_of(noise_of(spread));
      const Tally tally =
          judge_many(scene, submitted, noise_of(spread), rounds, pictures, 1'000'000);
      const std::string what =
          variance == 1 ? name : fmt::format("{}, variance x {}", name, variance);
      fmt::print("{:<34}{:>9}{:>9}{:>9}{:>11}{:>16.2f}\n", what, tally.failing[0], tally.failing[1],
                 tally.failing[2], tally.too_noisy, tally.noisiest);
      std::fflush(stdout);
    }
  }
}

// Prints the later rounds by themselves: 16 cells chosen at random, each with a sign.
void print_later_rounds(int pictures) {
  fmt::print("\nRound 2 on 16 random cells: of {} right pictures, level 0.002\n", pictures);
  for (const auto& [spread, name] : kSpreads) {
    const SyntheticScene scene = synthetic_scene(spread, kWidth, kHeight);
    const auto rounds = pictures::rounds_of(noise_of(spread));
    const pictures::Golden golden =
        pictures::prepare(Draw(5).golden(scene, golden_samples(rounds)));
    const std::vector<pictures::Cell> cells = pictures::cells_of(golden);
    Draw draw(6);
    int failing = 0;
    for (int i = 0; i < pictures; ++i) {
      std::vector<pictures::MeasuredCell> kept;
      while (kept.size() < 16) {
        kept.push_back(
            {cells[draw.random()() % cells.size()], draw.random()() % 2 == 0 ? 9.0 : -9.0, 1, 0});
      }
      const int samples = rounds[1].samples;
      const pictures::Moments round =
          pictures::moments(draw.batches(scene, 16, samples).images, samples);
      if (!pictures::repeated(pictures::compare(golden, round), kept, 2e-3).empty()) ++failing;
    }
    fmt::print("{:<34}{:>9}\n", name, failing);
    std::fflush(stdout);
  }
}

void measure_power(const std::string& folder, int pictures) {
  pt::Csv csv(folder + "/verdict_power.csv", "spread,error,samples,found");
  constexpr std::array<int, 6> kSamples{16, 32, 64, 128, 256, 512};
  fmt::print("\nFound of {} wrong pictures, against the samples per pixel of round 1\n", pictures);
  fmt::print("{:<46}", "");
  for (const int samples : kSamples) fmt::print("{:>7}", samples);
  fmt::print("\n");
  for (const auto& [spread, name] : kSpreads) {
    const SyntheticScene right = synthetic_scene(spread, kWidth, kHeight);
    for (const SyntheticError& error : synthetic_errors()) {
      fmt::print("{:<46}", fmt::format("{}: {}", name, error.name));
      for (const int samples : kSamples) {
        const int one = samples / 16;
        const std::array<Round, 3> rounds{{{16, one}, {16, 2 * one}, {16, 4 * one}}};
        const Tally tally =
            judge_many(right, with(right, error), noise_of(spread), rounds, pictures, 2'000'000);
        csv.row(fmt::format("{},{},{},{}", name, error.name, samples,
                            static_cast<double>(tally.wrong) / pictures));
        fmt::print("{:>6.0f}%", 100.0 * tally.wrong / pictures);
        std::fflush(stdout);
      }
      fmt::print("\n");
    }
  }
}

// Prints the figures of right sample maps that are judged, and how far away the limits are.
void print_sample_maps(int maps) {
  const AdaptiveScene scene = adaptive_scene(kWidth, kHeight);
  fmt::print("\n{} right sample maps: mean and deviation of each figure, failures\n", maps);
  for (const auto& [max, batch, tolerance] :
       {std::tuple{2048, 64, 0.05}, std::tuple{512, 16, 0.1}}) {
    const pt::AdaptiveSettings settings{max, batch, tolerance};
    const pictures::SampleMapReference reference = synthetic_reference(scene, settings);
    std::array<std::vector<double>, 4> figures;
    int failures = 0;
    for (int i = 0; i < maps; ++i) {
      const auto run = run_adaptive(scene, settings, StoppingRule::right, 1, 1000 + i);
      const pictures::SampleMapVerdict verdict = pictures::judge_sample_map(reference, run.map);
      if (!verdict.pass) ++failures;
      const double values[] = {verdict.ratio, verdict.a, verdict.b, verdict.correlation};
      for (int k = 0; k < 4; ++k) figures[k].push_back(values[k]);
    }
    fmt::print("{}/{}/{}:", max, batch, tolerance);
    const char* names[] = {"ratio", "a", "b", "correlation"};
    for (int k = 0; k < 4; ++k) {
      double mean = 0, squares = 0;
      for (const double x : figures[k]) mean += x / maps;
      for (const double x : figures[k]) squares += (x - mean) * (x - mean) / (maps - 1);
      fmt::print("  {} {:.3f} +- {:.4f}", names[k], mean, std::sqrt(squares));
    }
    fmt::print("  failures {}\n", failures);
  }
}

}  // namespace
}  // namespace grader::pictures

int main(int count, char** arguments) {
  CLI::App app("Measures how often the verdict on a picture is wrong", "verdict_power");
  std::string folder = ".";
  int pictures = 200, wrong = 20;
  app.add_option("--out", folder, "folder of verdict_power.csv")->check(CLI::ExistingDirectory);
  app.add_option("--pictures", pictures, "right pictures of each kind")
      ->check(CLI::Range(2, 1000000));
  app.add_option("--wrong", wrong, "wrong pictures of each kind")->check(CLI::Range(1, 100000));
  return pt::run_command_line(app, count, arguments, [&] {
    grader::pictures::print_sample_maps(std::min(pictures, 400));
    grader::pictures::measure_power(folder, wrong);
    grader::pictures::print_false_failures(pictures);
    grader::pictures::print_later_rounds(pictures);
    return 0;
  });
}
