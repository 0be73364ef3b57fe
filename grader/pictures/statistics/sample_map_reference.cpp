#include "grader/pictures/statistics/sample_map_verdict.h"
#include "pt/error.h"
#include "pt/file.h"
#include "pt/image/image.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string_view>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace grader::pictures {
namespace {

constexpr int kFewestRuns = 8;
constexpr int kFewestActive = 100;
constexpr std::size_t kMaxReferenceBytes = std::size_t{1} << 26;

struct CountMoments {
  double mean = 0;
  double deviation = 0;
};

CountMoments moments(std::span<const pt::SampleMap> runs, std::size_t pixel) {
  double mean = 0, squares = 0, count = 0;
  for (const pt::SampleMap& run : runs) {
    const double step = run.counts[pixel] - mean;
    mean += step / ++count;
    squares += step * (run.counts[pixel] - mean);
  }
  return {mean, std::sqrt(squares / (count - 1))};
}

// One character per pixel, for its flags.
char flags(const SampleMapReference& reference, std::size_t i) {
  const int bits = (reference.always_one_batch[i] ? 1 : 0) + (reference.constant[i] ? 2 : 0) +
                   (reference.all_zero[i] ? 4 : 0) + (reference.dark_start[i] ? 8 : 0);
  return "0123456789abcdef"[bits];
}

template <class Show>
std::string rows(const SampleMapReference& reference, const char* separator, const char* open,
                 const char* close, Show show) {
  std::string text;
  for (int y = 0; y < reference.height; ++y) {
    text += y == 0 ? "\n  " : ",\n  ";
    text += open;
    for (int x = 0; x < reference.width; ++x) {
      if (x > 0) text += separator;
      text += show(static_cast<std::size_t>(y) * reference.width + x);
    }
    text += close;
  }
  return text;
}

}  // namespace

SampleMapReference reference_of(std::span<const pt::SampleMap> runs, const pt::Film& picture,
                                const pt::AdaptiveSettings& settings) {
  if (runs.size() < kFewestRuns) {
    throw pt::Error(fmt::format("a reference of the sample map needs at least {} runs, not {}",
                                kFewestRuns, runs.size()));
  }
  SampleMapReference reference;
  reference.width = picture.width;
  reference.height = picture.height;
  reference.settings = settings;
  reference.runs = static_cast<int>(runs.size());
  for (const pt::SampleMap& run : runs) {
    if (run.width != picture.width || run.height != picture.height ||
        run.counts.size() != picture.pixels.size()) {
      throw pt::Error("the runs of a sample map and their picture differ in size");
    }
  }
  reference.dark_start.resize(picture.pixels.size());
  int active = 0;
  for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
    const auto [mean, deviation] = moments(runs, i);
    reference.mean.push_back(mean);
    reference.deviation.push_back(deviation);
    reference.always_one_batch.push_back(mean == settings.batch && deviation == 0 ? 1 : 0);
    const bool constant = picture.pixels[i].variance == pt::Rgb{};
    reference.constant.push_back(constant ? 1 : 0);
    reference.all_zero.push_back(constant && is_black(picture.pixels[i].mean) ? 1 : 0);
    if (mean > 1.5 * settings.batch && mean < 0.9 * settings.max_samples) ++active;
  }
  if (active < kFewestActive) {
    throw pt::Error(
        fmt::format("only {} pixels of the sample map take between 1.5 batches and 0.9 "
                    "of the maximum: choose another tolerance or maximum",
                    active));
  }
  return reference;
}

pt::SampleMap usual_counts(const SampleMapReference& reference) {
  pt::SampleMap map{reference.width, reference.height, {}, reference.settings.max_samples};
  for (const double mean : reference.mean)
    map.counts.push_back(static_cast<int>(std::lround(mean)));
  return map;
}

void write_reference(const std::filesystem::path& path, const SampleMapReference& reference) {
  const auto list = [&](const std::vector<double>& values, const char* format) {
    return rows(reference, ",", "[", "]",
                [&](std::size_t i) { return fmt::format(fmt::runtime(format), values[i]); });
  };
  const std::string letters = rows(reference, "", "\"", "\"", [&](std::size_t i) {
    return std::string(1, flags(reference, i));
  });
  const pt::AdaptiveSettings& settings = reference.settings;
  pt::write_file(
      path,
      fmt::format("{{\"width\": {}, \"height\": {}, \"runs\": {},\n \"max_samples\": {}, "
                  "\"batch\": {}, \"tolerance\": {},\n \"mean\": [{}],\n \"deviation\": [{}],\n"
                  " \"flags\": [{}]}}\n",
                  reference.width, reference.height, reference.runs, settings.max_samples,
                  settings.batch, settings.tolerance, list(reference.mean, "{:.7g}"),
                  list(reference.deviation, "{:.3g}"), letters));
}

namespace {

SampleMapReference parse(const nlohmann::json& kept) {
  SampleMapReference reference;
  reference.width = kept.at("width");
  reference.height = kept.at("height");
  reference.runs = kept.at("runs");
  reference.settings = {kept.at("max_samples"), kept.at("batch"), kept.at("tolerance")};
  if (!pt::is_image_size(reference.width, reference.height) || reference.settings.batch < 2 ||
      reference.settings.max_samples < reference.settings.batch ||
      !(reference.settings.tolerance > 0)) {
    throw pt::Error("its size or its settings are impossible");
  }
  for (const auto* name : {"mean", "deviation"}) {
    auto& values = name[0] == 'm' ? reference.mean : reference.deviation;
    for (const auto& row : kept.at(name)) {
      for (const auto& number : row) values.push_back(number.get<double>());
    }
  }
  for (const auto& row : kept.at("flags")) {
    for (const char letter : row.get<std::string>()) {
      const std::size_t bits = std::string_view("0123456789abcdef").find(letter);
      if (bits > 15) throw pt::Error("its flags must be 0 to f");
      reference.always_one_batch.push_back((bits & 1) != 0 ? 1 : 0);
      reference.constant.push_back((bits & 2) != 0 ? 1 : 0);
      reference.all_zero.push_back((bits & 4) != 0 ? 1 : 0);
      reference.dark_start.push_back((bits & 8) != 0 ? 1 : 0);
    }
  }
  const auto pixels = static_cast<std::size_t>(reference.width) * reference.height;
  if (reference.mean.size() != pixels || reference.deviation.size() != pixels ||
      reference.constant.size() != pixels) {
    throw pt::Error("it does not have one value per pixel");
  }
  return reference;
}

}  // namespace

SampleMapReference read_reference(const std::filesystem::path& path) {
  const std::string text = pt::read_file(path, kMaxReferenceBytes);
  try {
    return parse(nlohmann::json::parse(text));
  } catch (const pt::Error& error) {
    throw pt::Error(path.string() + ": not a reference of a sample map: " + error.what() +
                    "; make it again with ./run bless");
  } catch (const nlohmann::json::exception& error) {
    throw pt::Error(path.string() + ": not a reference of a sample map (" + error.what() +
                    "); make it again with ./run bless");
  }
}

}  // namespace grader::pictures
