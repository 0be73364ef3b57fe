#pragma once

#include "grader/pictures/cells.h"
#include "grader/pictures/golden.h"
#include "pt/image/film.h"
#include "pt/image/image.h"

#include <vector>

// The pictures that explain a verdict, beside its sentence.

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
  int freedom_ = 0;  // of the variances
};

// ImageVerdict::evidence, of one round: `kept` are the cells with thresholds of their own.
pt::Image evidence_map(const Golden& golden, const Moments& round,
                       const std::vector<MeasuredCell>& measured,
                       const std::vector<MeasuredCell>& kept);

}  // namespace grader::pictures
