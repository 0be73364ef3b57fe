#include "grader/pictures/single/causes/cause.h"

#include "grader/pictures/single/causes/suspects.h"

#include <algorithm>

namespace grader::pictures {

std::string cause_of(const SinglePicture& picture, const SingleQuestion& question,
                     const std::vector<pt::Image>& ours, const SingleVerdict& verdict) {
  if (std::ranges::all_of(picture.linear.pixels, [](const pt::Rgb& p) { return is_black(p); })) {
    return "it is black";
  }
  Suspects suspects(picture, question, ours);
  suspect_flips(suspects);
  suspect_codec(suspects);
  suspect_light(suspects);
  suspect_objects(suspects, verdict);
  suspect_pixels(suspects, verdict);
  if (std::string named = suspects.named(); !named.empty()) return named;
  if (std::string repeated = repeated_samples(verdict); !repeated.empty()) return repeated;
  suspect_field_of_view(suspects);
  return suspects.named();
}

}  // namespace grader::pictures
