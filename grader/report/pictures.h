#pragma once

#include "pt/image/image.h"
#include "pt/image/picture.h"
#include "pt/image/sample_map.h"

#include <functional>

// The pictures that show a person a render and its golden. difference_map is in pt/image/compare.h,
// tone_map in pt/image/tone_map.h.

namespace grader::report {

// The exposure of render and golden: 1, which is what `render` writes, unless the golden would
// be nearly black or nearly white; then the power of two that brings its bright pixels to about 1.
double exposure_for(const pt::Image& golden);

// Means over blocks of 8 x 8 pixels, which are smaller at the right and the bottom.
pt::Image block_means(const pt::Image& image);

inline constexpr double kBlockScale = 0.1;

// The relative difference of the block means of the luminances, in the colours of difference_color,
// full at kBlockScale. The sizes are equal.
pt::Picture block_difference_map(const pt::Image& render, const pt::Image& golden);

// |z| over its threshold: white at 0, purple at 1, nearly black from 2 on.
pt::Color8 evidence_color(double evidence);

// The picture of an image whose red channel holds the evidence.
pt::Picture evidence_map(const pt::Image& evidence);

// The colours of sample_color, from `min` to `max` samples, without a legend.
pt::Picture count_map(const pt::SampleMap& map, int min, int max);

// The relative difference of two maps of one size, full at 20 %.
pt::Picture count_difference_map(const pt::SampleMap& map, const pt::SampleMap& golden);

// The bar of a legend: the colours at t = 0..1, from left to right, one pixel high.
pt::Picture legend_bar(const std::function<pt::Color8(double)>& color);

}  // namespace grader::report
