// A study's renders, which a journal keeps: a study that was interrupted goes on where it was.
#include "writeup/accuracy/study.h"

#include <algorithm>

#include <fmt/format.h>

namespace writeup::accuracy {

namespace {

std::string question_of(const pt::View& view, const pt::RenderSettings& settings,
                        std::size_t pixels, std::size_t ranges) {
  const pt::PathSettings& path = view.settings;
  const pt::AdaptiveSettings adaptive = settings.adaptive.value_or(pt::AdaptiveSettings{0, 0, 0});
  return fmt::format("{} {} {} {} {} {} {} {} {} {} {} {}", name(view.scene.tracer.engine()),
                     static_cast<int>(path.direct), path.light_samples, path.to, path.survival,
                     settings.samples, settings.seed, pixels, ranges, adaptive.max_samples,
                     adaptive.batch, adaptive.tolerance);
}

}  // namespace

RenderedPixels Study::made(const pt::View& view, const pt::RenderSettings& settings,
                           std::span<const PixelAt> pixels) {
  const std::string question = question_of(view, settings, pixels.size(), 0);
  const std::size_t n = pixels.size();
  RenderedPixels result;
  if (const auto known = journal_.next(question); known && known->size() == 3 * n + 2) {
    const double* const from = known->data();
    result.mean.assign(from, from + n);
    result.variance.assign(from + n, from + 2 * n);
    result.samples.assign(from + 2 * n, from + 3 * n);
    result.cpu_seconds = from[3 * n];
    result.rays = static_cast<long long>(from[3 * n + 1]);
  } else {
    result = measure(view, settings, pixels);
    std::vector<double> all = result.mean;
    all.insert(all.end(), result.variance.begin(), result.variance.end());
    all.insert(all.end(), result.samples.begin(), result.samples.end());
    all.insert(all.end(), {result.cpu_seconds, static_cast<double>(result.rays)});
    keep(question, all);
  }
  advance(result.cpu_seconds);
  return result;
}

MeasuredApart Study::made_apart(const pt::View& view, const pt::RenderSettings& settings,
                                std::span<const pt::BounceRange> ranges,
                                std::span<const PixelAt> pixels) {
  const std::string question = question_of(view, settings, pixels.size(), ranges.size());
  const std::size_t n = pixels.size();
  MeasuredApart result;
  if (const auto known = journal_.next(question); known && known->size() == ranges.size() * n + 1) {
    for (std::size_t k = 0; k < ranges.size(); ++k) {
      result.mean.emplace_back(known->begin() + k * n, known->begin() + (k + 1) * n);
    }
    result.cpu_seconds = known->back();
  } else {
    result = measure_apart(view, settings, ranges, pixels);
    std::vector<double> all;
    for (const std::vector<double>& mean : result.mean)
      all.insert(all.end(), mean.begin(), mean.end());
    all.push_back(result.cpu_seconds);
    keep(question, all);
  }
  advance(result.cpu_seconds);
  return result;
}

// Only calls show the tasks that are not written, and the journal does not keep that.
void Study::keep(const std::string& question, const std::vector<double>& answer) {
  if (unwritten_tasks().empty()) {
    journal_.keep(question, answer);
  } else {
    journal_.remove();
  }
}

void Study::advance(double cpu_seconds) {
  cpu_seconds_ += cpu_seconds;
  if (progress_) progress_(std::min(0.99, cpu_seconds_ / threads_ / limits_.seconds));
}

}  // namespace writeup::accuracy
