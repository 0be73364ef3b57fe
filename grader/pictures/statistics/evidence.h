#pragma once

#include "grader/pictures/goldens/golden.h"
#include "grader/pictures/statistics/cells.h"
#include "pt/image/film.h"
#include "pt/image/image.h"

#include <vector>

// The pictures that explain a verdict, in addition to its sentence.

namespace grader::pictures {

inline constexpr double kMaxEvidence = 1000;

// The picture of all rounds together.
class PooledFilm {
 public:
  PooledFilm(int width, int height) : film_(width, height) {}

  void add(const Moments& round);
  const pt::Film& film() const { return film_; }
  int samples() const { return samples_; }

 private:
  pt::Film film_;
  int samples_ = 0;
  int freedom_ = 0;  // degrees of freedom of the variances
};

// ImageVerdict::evidence of one round. `kept` lists the cells with their own thresholds.
pt::Image evidence_map(const Golden& golden, const Moments& round,
                       const std::vector<MeasuredCell>& measured,
                       const std::vector<MeasuredCell>& kept);

}  // namespace grader::pictures
