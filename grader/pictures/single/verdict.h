#pragma once

#include "grader/pictures/single/agreement.h"
#include "grader/pictures/single/codec.h"
#include "pt/scene/view.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

// The verdict on one picture that somebody else has made of a scene: we know its settings, and neither its random numbers nor its code.

namespace grader::pictures {

// A picture as its file has it.
struct SinglePicture {
  bool eight_bits = true;
  pt::Image linear;  // 8 bits as pt::decode reads them

  pt::Image decoded(const Codec& codec) const;
};

// Throws pt::Error for a JPEG, which changes pixels, and for what read_image cannot read.
SinglePicture read_single(const std::filesystem::path& file);

// The number of our pictures, and the most samples of one.
inline constexpr int kOwnPictures = 16;
inline constexpr int kMostOwnSamples = 64;

// The reference, with the settings of the picture.
struct SingleQuestion {
  pt::View view;
  int samples = 32;
  int threads = 1;
  std::vector<double> exposures{kUsualExposures.begin(), kUsualExposures.end()};  // that are right
  std::vector<Curve> curves{Curve::gamma, Curve::srgb};
  std::uint64_t seed = 1;  // of our pictures
  int most_own_samples = kMostOwnSamples;
};

// The ways that the picture may have gone.
std::vector<Codec> codecs_of(const SinglePicture& picture, const SingleQuestion& question);

struct SingleVerdict {
  enum class Outcome { agrees, wrong, cannot_say };
  Outcome outcome = Outcome::agrees;
  std::string sentence;
  std::string cause;  // empty if none explains the picture
  Codec codec;        // that fits best
  Agreement agreement;
  pt::Image ours;  // the mean of our pictures, through the codec
  pt::Image theirs;
};

// Our pictures, each with the noise of `samples` samples. At most `most` are taken: deviations from the mean are made smaller, as the root
// says.
std::vector<pt::Image> render_ours(const pt::View& view, int samples, int count,
                                   std::uint64_t first_seed, int threads,
                                   int most = kMostOwnSamples);

SingleVerdict judge_single(const SinglePicture& picture, const SingleQuestion& question);

// The same if our pictures are there already, before any codec. `cause` is not looked for.
SingleVerdict judge_single(const SinglePicture& picture, const SingleQuestion& question,
                           const std::vector<pt::Image>& ours);

}  // namespace grader::pictures
