#include "grader/pictures/single/verdict.h"

#include "grader/pictures/single/causes/cause.h"
#include "pt/error.h"
#include "pt/file.h"
#include "pt/image/exr.h"
#include "pt/image/image_io.h"
#include "pt/image/pfm.h"
#include "pt/image/tone_map.h"
#include "pt/math/uncertain.h"
#include "pt/render/render_film.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace grader::pictures {
namespace {

std::string percent(double part) { return fmt::format("{:.2g} %", 100 * std::abs(part)); }

std::string place_of(const SingleBlock& block) {
  if (block.side == 0) return "the whole picture is";
  return fmt::format("the {} x {} pixels from x {}, y {} (from the top left) are", block.width,
                     block.height, block.x, block.y);
}

// The errors that would have been called wrong: the whole picture's, and the median of the blocks'.
std::string would_be_found(const Agreement& agreement) {
  std::vector<double> blocks;
  double whole = 0;
  for (const SingleBlock& block : agreement.blocks) {
    if (block.side == 24) blocks.push_back(block.would_be_found);
    if (block.side == 0) whole = block.would_be_found;
  }
  return fmt::format(
      "{} of the whole picture or {} in a block of 24 x 24 would have been called wrong",
      percent(whole), percent(pt::median_of(blocks)));
}

// The sentence about a picture that cannot be compared; empty if it can.
std::string unusable(const pt::Image& picture, const pt::View& view) {
  if (picture.width != view.width || picture.height != view.height) {
    return fmt::format("it has {} x {} pixels, and not {} x {}", picture.width, picture.height,
                       view.width, view.height);
  }
  const auto bad = std::ranges::find_if(picture.pixels, [](const pt::Rgb& pixel) {
    return !is_finite(pixel) || std::min({pixel.r, pixel.g, pixel.b}) < 0;
  });
  if (bad != picture.pixels.end()) {
    const auto at = static_cast<int>(bad - picture.pixels.begin());
    return fmt::format("the pixel x {}, y {} (from the top left) is {} {} {}, which is no radiance",
                       at % picture.width, at / picture.width, bad->r, bad->g, bad->b);
  }
  return "";
}

std::vector<double> steps_of(const Codec& codec, const pt::Image& mean) {
  std::vector<double> steps;
  if (!codec.eight_bits) return steps;
  for (const pt::Rgb& pixel : mean.pixels) steps.push_back(codec.step(luminance(pixel)));
  return steps;
}

// The part of a picture's samples that each of ours took.
double taken_of(const SingleQuestion& question) {
  return std::min(1.0, static_cast<double>(question.most_own_samples) / question.samples);
}

bool fits_better(const Agreement& a, const Agreement& b) {
  if (a.agrees() != b.agrees()) return a.agrees();
  return a.distance < b.distance;
}

void describe(SingleVerdict& verdict, const SingleQuestion& question) {
  using Outcome = SingleVerdict::Outcome;
  const Agreement& agreement = verdict.agreement;
  const std::string how = fmt::format("as if with {}", verdict.codec.words());
  if (!agreement.agrees()) {
    verdict.outcome = Outcome::wrong;
    verdict.sentence =
        fmt::format("{} {} too {}, {:.1f} times what a right picture may be off by ({})",
                    place_of(agreement.worst), percent(agreement.worst.off_by),
                    agreement.worst.off_by < 0 ? "dark" : "bright", agreement.worst.evidence, how);
  } else if (agreement.is_too_noisy()) {
    verdict.outcome = Outcome::cannot_say;
    verdict.sentence = fmt::format(
        "its neighbouring pixels differ {:.1f} times as much, in variance, as those of {} samples "
        "a pixel: say "
        "its samples with -s, or take a picture of more ({})",
        agreement.noise, question.samples, how);
  } else {
    verdict.sentence = fmt::format("{} ({})", would_be_found(agreement), how);
  }
}

}  // namespace

pt::Image SinglePicture::decoded(const Codec& codec) const {
  if (!eight_bits) return linear;
  std::array<double, 256> values;
  for (int code = 0; code < 256; ++code) values[code] = codec.decode(code);
  pt::Image image(linear.width, linear.height);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    for (int c = 0; c < 3; ++c) image.pixels[i][c] = values[pt::encode(linear.pixels[i][c])];
  }
  return image;
}

std::vector<Codec> codecs_of(const SinglePicture& picture, const SingleQuestion& question) {
  if (!picture.eight_bits) return {{false}};
  return usual_codecs(question.exposures, question.curves);
}

SinglePicture read_single(const std::filesystem::path& file) {
  const std::string bytes = pt::read_file(file, pt::kMaxPictureBytes);
  if (bytes.starts_with("\xff\xd8")) {
    throw pt::Error(file.string() +
                    ": JPEG changes every pixel, so that nothing can be said of the light; save it "
                    "as PNG or EXR");
  }
  const bool is_float =
      pt::starts_as_exr(bytes) || pt::starts_as_pfm(bytes) || bytes.starts_with("#?");
  return {!is_float, pt::read_image(file)};
}

std::vector<pt::Image> render_ours(const pt::View& view, int samples, int count,
                                   std::uint64_t first_seed, int threads, int most) {
  std::vector<pt::Image> pictures;
  const int taken = std::min(samples, most);
  for (int i = 0; i < count; ++i) {
    const std::uint64_t seed = first_seed + static_cast<std::uint64_t>(i);
    pictures.push_back(mean(pt::render_film(view, {taken, {}, seed, threads}).film));
  }
  if (taken == samples) return pictures;
  const pt::Image mean = mean_of(pictures);
  const double part = std::sqrt(static_cast<double>(taken) / samples);
  for (pt::Image& picture : pictures) {
    for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
      picture.pixels[i] = mean.pixels[i] + (picture.pixels[i] - mean.pixels[i]) * part;
    }
  }
  return pictures;
}

SingleVerdict judge_single(const SinglePicture& picture, const SingleQuestion& question,
                           const std::vector<pt::Image>& ours) {
  SingleVerdict verdict;
  if (const std::string why = unusable(picture.linear, question.view); !why.empty()) {
    verdict.outcome = SingleVerdict::Outcome::wrong;
    verdict.sentence = why;
    return verdict;
  }
  const pt::Image mean = mean_of(ours), soft = softened(mean);
  const std::vector<Codec> codecs = codecs_of(picture, question);
  for (std::size_t k = 0; k < codecs.size(); ++k) {
    std::vector<pt::Image> coded;
    for (const pt::Image& one : ours) coded.push_back(codecs[k].through(one));
    const OwnPictures own =
        own_pictures(std::move(coded),
                     {codecs[k].through(mean), codecs[k].through(soft), steps_of(codecs[k], mean)},
                     taken_of(question));
    const pt::Image theirs = picture.decoded(codecs[k]);
    const Agreement agreement = compare(theirs, own);
    if (k > 0 && !fits_better(agreement, verdict.agreement)) continue;
    verdict.codec = codecs[k];
    verdict.agreement = agreement;
    verdict.ours = own.mean;
    verdict.theirs = theirs;
  }
  describe(verdict, question);
  return verdict;
}

SingleVerdict judge_single(const SinglePicture& picture, const SingleQuestion& question) {
  const std::vector<pt::Image> ours =
      render_ours(question.view, question.samples, kOwnPictures, question.seed, question.threads,
                  question.most_own_samples);
  SingleVerdict verdict = judge_single(picture, question, ours);
  if (verdict.outcome == SingleVerdict::Outcome::wrong && verdict.ours.width > 0) {
    verdict.cause = cause_of(picture, question, ours, verdict);
  }
  return verdict;
}

}  // namespace grader::pictures
