#pragma once

#include "pt/image/film.h"
#include "pt/image/sample_map.h"
#include "pt/tasks/adaptive_pixel.h"

#include <filesystem>
#include <span>
#include <string>
#include <vector>

// Judges whether an adaptive render spends its samples as the reference does. A right picture says
// little about that: it is right on average with any number of samples. docs/verdicts.md has the
// figures.

namespace grader::pictures {

// The counts of many runs of the reference, with different seeds. Row 0 is the TOP row, as in
// pt::SampleMap.
struct SampleMapReference {
  int width = 0;
  int height = 0;
  pt::AdaptiveSettings settings;
  int runs = 0;
  std::vector<double> mean;            // of the samples that a pixel took
  std::vector<double> deviation;       // between the runs: of one run, not of the mean
  std::vector<char> always_one_batch;  // pixels that took one batch in every run
  std::vector<char> constant;          // pixels of the same value in every run
  std::vector<char> all_zero;          // pixels of value 0 in every run
  // Pixels whose first batch was all zero in a run: there < and <= differ, and both are right.
  // reference_of cannot know them: all are 0 until the caller sets them.
  std::vector<char> dark_start;
};

// `runs` are the maps. `picture` has mean and variance of the runs' pictures: a run is a sample.
// Throws pt::Error if the sizes differ, there are fewer than 8 runs, or fewer than 100 pixels take
// between 1.5 batches and 0.9 of the maximum: such a map says too little.
SampleMapReference reference_of(std::span<const pt::SampleMap> runs, const pt::Film& picture,
                                const pt::AdaptiveSettings& settings);

// Writes JSON, a line per row; the deviation has three digits. Throws pt::Error as pt::write_file does.
void write_reference(const std::filesystem::path& path, const SampleMapReference& reference);

// Throws pt::Error with the file's name if it is missing or was not written by write_reference.
SampleMapReference read_reference(const std::filesystem::path& path);

// The samples that the reference takes on average, in whole numbers, to show and to compare with.
pt::SampleMap usual_counts(const SampleMapReference& reference);

struct SampleMapVerdict {
  bool pass = false;
  // The fault, for a person. If it passes: empty, or a difference from the reference that has a
  // likely cause.
  std::string sentence;
  double off_batch = 0;    // fraction of the pixels whose count is not a multiple of the batch
  double outside = 0;      // fraction with less than a batch or more than the maximum
  double constant_on = 0;  // fraction of the constant lit pixels that took more than one batch
  // On the active pixels, those which take more than 1.5 batches and less than 0.9 of the maximum:
  double ratio = 0;        // all samples over the reference's
  double correlation = 0;  // of the logarithms
  double a = 0;            // n = a + b nbar, weighted by how the runs vary; a in batches
  double b = 0;
};

// Judges one run of the submission, with the settings of the reference.
SampleMapVerdict judge_sample_map(const SampleMapReference& reference, const pt::SampleMap& counts);

}  // namespace grader::pictures
