#pragma once

#include "grader/pictures/single/verdict.h"

#include <string>
#include <utility>
#include <vector>

// Suspicions of what is wrong with a picture. One counts only if the picture agrees with ours, by the test that called it wrong, once ours have
// the same fault, or once the picture is changed back.

namespace grader::pictures {

using Pictures = std::vector<pt::Image>;

// A dozen suspicions are rendered, so each takes fewer samples than the verdict.
inline constexpr int kSamplesOfSuspects = 16;

class Suspects {
 public:
  // `ours` are our pictures before any codec. All three have to outlive this.
  Suspects(const SinglePicture& picture, const SingleQuestion& question, const Pictures& ours)
      : picture_(picture), question_(question), ours_(ours), quick_(question) {
    quick_.most_own_samples = kSamplesOfSuspects;
  }

  const SinglePicture& picture() const { return picture_; }
  const SingleQuestion& question() const { return question_; }
  const Pictures& ours() const { return ours_; }

  // Each adds the words if the picture agrees with these of ours, once it is changed back, or with other exposures or curves.
  void try_ours(const std::string& words, const Pictures& ours);
  void try_picture(const std::string& words, const SinglePicture& changed_back);
  void try_question(const std::string& words, const SingleQuestion& other);

  // Our pictures of another view, of fewer samples.
  Pictures render(const pt::View& view) const;

  // The nearest one, with the one that is nearly as near; empty if more are, or none is there.
  std::string named();

 private:
  void add(const std::string& words, const SingleVerdict& verdict);

  const SinglePicture& picture_;
  const SingleQuestion& question_;
  const Pictures& ours_;
  SingleQuestion quick_;                               // for pictures of few samples
  std::vector<std::pair<double, std::string>> found_;  // distance, words
};

// Upside down, mirrored, turned.
void suspect_flips(Suspects& suspects);

// Exposures and curves. A picture of another exposure is brighter by one factor wherever it is not clipped.
void suspect_codec(Suspects& suspects);

// Direct light, or indirect, or both, times a factor; the last bounce.
void suspect_light(Suspects& suspects);

// Spheres, triangles, one sphere, what has one material: not there, or black. `verdict` is that on the picture.
void suspect_objects(Suspects& suspects, const SingleVerdict& verdict);

// Another field of view, by a fit.
void suspect_field_of_view(Suspects& suspects);

// A few pixels that are far too bright, or black.
void suspect_pixels(Suspects& suspects, const SingleVerdict& verdict);

// The same random numbers in pixels of a fixed distance: what the picture shows of it, or nothing.
std::string repeated_samples(const SingleVerdict& verdict);

}  // namespace grader::pictures
