#include "grader/pictures/statistics/image_verdict.h"

#include "grader/pictures/statistics/cells.h"
#include "grader/pictures/statistics/evidence.h"
#include "grader/pictures/statistics/guards.h"
#include "grader/pictures/statistics/sentences.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <iterator>

namespace grader::pictures {
namespace {

using Outcome = ImageVerdict::Outcome;

constexpr double kMaxCorrelation = 3;

double usual_limit(NoiseClass noise) { return noise == NoiseClass::noisy ? 6 : 3; }

// The faults that all rounds so far have found.
struct Suspicion {
  std::vector<MeasuredCell> cells;
  std::vector<WrongConstant> constants;
  bool correlated = false;
  bool noisy = false;
  bool too_near = false;
  double energy_off = 0;              // of a noisy picture; 0: as it should be
  std::vector<MeasuredCell> blatant;  // of a noisy picture: blocks that no noise explains

  bool any() const {
    return !cells.empty() || !constants.empty() || correlated || noisy || too_near;
  }
};

std::vector<WrongConstant> also_before(const std::vector<WrongConstant>& now,
                                       const std::vector<WrongConstant>& before) {
  std::vector<WrongConstant> both;
  std::copy_if(now.begin(), now.end(), std::back_inserter(both), [&](const WrongConstant& one) {
    return std::any_of(before.begin(), before.end(),
                       [&](const WrongConstant& other) { return other.pixel == one.pixel; });
  });
  return both;
}

std::vector<MeasuredCell> blatant(const std::vector<MeasuredCell>& measured) {
  std::vector<MeasuredCell> found;
  std::copy_if(
      measured.begin(), measured.end(), std::back_inserter(found), [](const MeasuredCell& one) {
        const bool block = one.cell.scale == Scale::block8 || one.cell.scale == Scale::block24;
        return block && std::abs(one.off_by) > kBlatant;
      });
  return found;
}

// The error of the energy of a noisy picture, if two rounds agree on its sign; else 0.
double agreed(double now, double before) { return now * before > 0 ? now : 0; }

// The area of the parts in pixels, as if no two overlapped.
std::size_t area(const std::vector<MeasuredCell>& parts) {
  std::size_t sum = 0;
  for (const MeasuredCell& one : parts) sum += one.cell.width * one.cell.height;
  return sum;
}

// Judges one round after the other.
class Judge {
 public:
  Judge(const pt::Film& film, double most_noise)
      : golden_(prepare(film)),
        cells_(cells_of(golden_)),
        most_noise_(most_noise),
        sum_(golden_.width, golden_.height) {}

  const Golden& golden() const { return golden_; }
  const ImageVerdict& verdict() const { return verdict_; }

  void refuse(const Unusable& what, const Batches& batches);
  // Returns whether a fault is left that another round could repeat.
  bool judge(const Batches& batches);
  void decide();

 private:
  Golden golden_;
  std::vector<Cell> cells_;
  double most_noise_;
  PooledFilm sum_;
  Suspicion suspicion_;
  ImageVerdict verdict_;
};

void Judge::refuse(const Unusable& what, const Batches& batches) {
  ++verdict_.rounds;
  verdict_.samples = sum_.samples() + batches.samples * static_cast<int>(batches.images.size());
  verdict_.outcome = Outcome::unusable;
  verdict_.sentence = what.sentence;
  verdict_.cells.clear();
  std::vector<pt::Image> images = batches.images;
  const bool sized = images.size() >= 2 && std::all_of(images.begin(), images.end(), [&](auto& i) {
                       return i.width == golden_.width && i.height == golden_.height &&
                              i.pixels.size() == golden_.samples.size();
                     });
  if (!sized) return;
  for (pt::Image& image : images) {
    for (pt::Rgb& color : image.pixels) {
      if (!is_finite(color)) color = {};
    }
  }
  const Moments round = moments(images, batches.samples);
  sum_.add(round);
  verdict_.render = sum_.film();
  verdict_.evidence = evidence_map(golden_, round, {}, {});
  if (what.pixel) {
    const int x = static_cast<int>(*what.pixel) % golden_.width;
    const int y = static_cast<int>(*what.pixel) / golden_.width;
    verdict_.cells = {{x, y, 1, 1, "Y", 0, kMaxEvidence}};
    verdict_.evidence.at(x, y) = pt::gray(kMaxEvidence);
  }
}

bool Judge::judge(const Batches& batches) {
  const int number = verdict_.rounds++;
  const Moments round = moments(batches.images, batches.samples);
  const Comparison pictures = compare(golden_, round);
  const Noise noise = measure_noise(golden_, round, batches.images);
  const std::vector<MeasuredCell> measured = measure(pictures, cells_, kRoundLevels[number]);

  Suspicion now;
  now.constants = wrong_constants(golden_, round, batches.images);
  now.correlated = !(noise.correlation <= kMaxCorrelation);
  now.noisy = !(noise.ratio <= most_noise_);
  now.too_near = is_too_near(pictures);
  if (std::abs(noise.energy_t) > 5 && std::abs(noise.energy_off) > 0.03) {
    now.energy_off = noise.energy_off;
  }
  if (number == 0) {
    now.cells = exceeding(measured, kKeptCells);
    if (now.noisy) now.blatant = exceeding(blatant(measured), kKeptCells);
  } else {
    now.cells = repeated(pictures, suspicion_.cells, kRoundLevels[number]);
    now.constants = also_before(now.constants, suspicion_.constants);
    now.correlated = now.correlated && suspicion_.correlated;
    now.noisy = now.noisy && suspicion_.noisy;
    now.too_near = now.too_near && suspicion_.too_near;
    now.blatant = blatant(repeated(pictures, suspicion_.blatant, kRoundLevels[number]));
    now.energy_off = agreed(now.energy_off, suspicion_.energy_off);
  }
  suspicion_ = now;

  sum_.add(round);
  verdict_.samples = sum_.samples();
  verdict_.noise = noise.ratio;
  verdict_.evidence = evidence_map(golden_, round, measured, now.cells);
  return suspicion_.any();
}

void Judge::decide() {
  verdict_.render = sum_.film();
  const int rounds = verdict_.rounds;
  if (!suspicion_.any()) return;
  verdict_.outcome = Outcome::wrong;
  if (suspicion_.too_near) {
    verdict_.sentence = too_near_sentence(rounds);
    return;
  }
  const bool wrong_anyway = !suspicion_.constants.empty() || !suspicion_.blatant.empty();
  if (suspicion_.noisy && !wrong_anyway) {
    // Much noise hides small errors of a part, but not those of the whole.
    if (suspicion_.energy_off == 0) {
      verdict_.outcome = Outcome::too_noisy;
      verdict_.sentence = too_noisy_sentence(verdict_.noise);
    } else {
      verdict_.sentence = noisy_and_wrong_sentence(verdict_.noise, suspicion_.energy_off, rounds);
    }
    return;
  }
  for (const WrongConstant& one : suspicion_.constants) {
    const int x = static_cast<int>(one.pixel) % golden_.width;
    const int y = static_cast<int>(one.pixel) / golden_.width;
    verdict_.cells.push_back(failing_cell({{Scale::pixel, one.plane, false, x, y, 1, 1},
                                           std::copysign(one.evidence, one.difference),
                                           1,
                                           one.off_by}));
  }
  if (suspicion_.noisy) suspicion_.cells = suspicion_.blatant;
  const std::vector<MeasuredCell> parts = smallest(suspicion_.cells);
  for (const MeasuredCell& one : parts) verdict_.cells.push_back(failing_cell(one));
  std::stable_sort(verdict_.cells.begin(), verdict_.cells.end(),
                   [](const auto& a, const auto& b) { return a.evidence > b.evidence; });
  if (verdict_.cells.size() > kKeptCells) verdict_.cells.resize(kKeptCells);

  // The fault that covers more of the picture is the one to name.
  if (!suspicion_.constants.empty() && suspicion_.constants.size() >= area(parts)) {
    verdict_.sentence = sentence(suspicion_.constants, golden_, rounds);
  } else if (!parts.empty()) {
    verdict_.sentence = sentence(suspicion_.cells, parts, rounds);
  } else {
    verdict_.sentence = correlated_sentence(rounds);
  }
}

}  // namespace

std::array<Round, 3> rounds_of(NoiseClass noise) {
  const int samples = noise == NoiseClass::noisy ? 16 : 4;
  return {{{16, samples}, {16, 2 * samples}, {16, 4 * samples}}};
}

ImageVerdict judge_image(const pt::Film& golden, NoiseClass noise, const RenderRound& render,
                         int max_rounds, double most_noise) {
  return judge_image(golden, noise, render, max_rounds, rounds_of(noise), most_noise);
}

ImageVerdict judge_image(const pt::Film& golden, NoiseClass noise, const RenderRound& render,
                         int max_rounds, const std::array<Round, 3>& rounds, double most_noise) {
  assert(max_rounds >= 1 && max_rounds <= 3);
  Judge judge(golden, most_noise > 0 ? most_noise : usual_limit(noise));
  for (int i = 0; i < max_rounds; ++i) {
    const Batches batches = render(i + 1, rounds[i].batches, rounds[i].samples);
    if (const auto what = unusable(judge.golden(), batches, rounds[i].batches)) {
      judge.refuse(*what, batches);
      return judge.verdict();
    }
    if (!judge.judge(batches)) break;
  }
  judge.decide();
  return judge.verdict();
}

}  // namespace grader::pictures
