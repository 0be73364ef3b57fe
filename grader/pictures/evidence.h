#pragma once

#include "grader/pictures/cells.h"
#include "grader/pictures/golden.h"
#include "pt/image/film.h"
#include "pt/image/image.h"

#include <vector>

// What a person is shown of a verdict, beside the sentence.

namespace grader::pictures {

inline constexpr double kMostEvidence = 1000;

// The picture of all stages together.
class PooledFilm {
 public:
  PooledFilm(int width, int height) : film_(width, height) {}

  void add(const Moments& stage);
  const pt::Film& film() const { return film_; }
  int samples() const { return samples_; }

 private:
  pt::Film film_;
  int samples_ = 0;
  int freedom_ = 0;  // of the variances
};

// ImageVerdict::evidence, of one stage: `kept` are the cells with thresholds of their own.
pt::Image evidence_map(const Golden& golden, const Moments& stage,
                       const std::vector<Complaint>& measured, const std::vector<Complaint>& kept);

}  // namespace grader::pictures
