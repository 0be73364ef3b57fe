#include "grader/pictures/single/causes/suspects.h"

#include <algorithm>

namespace grader::pictures {
namespace {

// A suspect that is farther away than another by this sum of squares is none.
constexpr double kClearly = 20;

}  // namespace

void Suspects::try_ours(const std::string& words, const Pictures& ours) {
  add(words, judge_single(picture_, quick_, ours));
}

void Suspects::try_picture(const std::string& words, const SinglePicture& changed_back) {
  add(words, judge_single(changed_back, question_, ours_));
}

void Suspects::try_question(const std::string& words, const SingleQuestion& other) {
  add(words, judge_single(picture_, other, ours_));
}

Pictures Suspects::render(const pt::View& view) const {
  return render_ours(view, quick_.samples, kOwnPictures, quick_.seed + 1000, quick_.threads,
                     kSamplesOfSuspects);
}

std::string Suspects::named() {
  std::ranges::sort(found_);
  std::size_t near = 0;
  while (near < found_.size() && found_[near].first < found_[0].first + kClearly) ++near;
  if (near == 0 || near > 2) return "";
  return near == 1 ? found_[0].second : found_[0].second + ", or: " + found_[1].second;
}

void Suspects::add(const std::string& words, const SingleVerdict& verdict) {
  if (verdict.outcome != SingleVerdict::Outcome::agrees) return;
  const auto known = std::ranges::find(found_, words, &std::pair<double, std::string>::second);
  if (known == found_.end()) {
    found_.emplace_back(verdict.agreement.distance, words);
  } else {
    known->first = std::min(known->first, verdict.agreement.distance);
  }
}

}  // namespace grader::pictures
