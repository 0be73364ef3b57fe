#pragma once

#include "grader/pictures/statistics/image_verdict.h"
#include "tests/grader/pictures/synthetic_pictures.h"

#include <gtest/gtest.h>

namespace grader::pictures {

// One picture, 48 x 36 and diffuse, and submissions that render it.
class Judged : public testing::Test {
 protected:
  static constexpr int kWidth = 48, kHeight = 36;
  ImageVerdict judge(const RenderRound& render, int max_rounds = 3) const {
    return judge_image(golden_, NoiseClass::ordinary, render, max_rounds);
  }
  // A right submission whose images are changed before the verdict.
  template <class Change>
  RenderRound changed(Change change) const {
    return [this, change](int round, int batches, int samples) {
      Batches result = submission(scene_, 77)(round, batches, samples);
      for (std::size_t b = 0; b < result.images.size(); ++b) {
        change(result.images[b], static_cast<int>(b), round);
      }
      return result;
    };
  }

  SyntheticScene scene_ = synthetic_scene(Spread::diffuse, kWidth, kHeight);
  pt::Film golden_ = Draw(42).golden(scene_, 16384);
};

}  // namespace grader::pictures
