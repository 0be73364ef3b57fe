#include "grader/pictures/known_mistakes.h"

#include "pt/error.h"
#include "pt/file.h"
#include "pt/image/image_io.h"

#include <nlohmann/json.hpp>

namespace grader::pictures {

namespace {

constexpr std::size_t kHashLength = 8;

BlockMeans means(const std::string& film, const std::string& counts) {
  BlockMeans blocks = block_means(pt::read_exr(film));
  if (!counts.empty()) add_counts(blocks, pt::read_counts(counts));
  return blocks;
}

}  // namespace

JudgedPicture judged_picture(const results::PictureResult& result) {
  if (result.state == results::State::pass) return {JudgedPicture::Outcome::right, {}};
  if (result.state != results::State::fail || result.render.empty()) return {};
  return {JudgedPicture::Outcome::wrong, means(result.render, result.counts)};
}

BlockMeans golden_means(const results::PictureResult& result) {
  return means(result.golden, result.golden_counts);
}

std::string recipe_hash(const std::filesystem::path& golden) {
  const std::filesystem::path file = std::filesystem::path(golden).replace_extension(".json");
  try {
    const auto json = nlohmann::json::parse(pt::read_file(file, 1 << 20));
    return json.at("sha256").get<std::string>().substr(0, kHashLength);
  } catch (const nlohmann::json::exception& error) {
    throw pt::Error(file.string() + " says nothing about its golden: " + error.what());
  }
}

Likeness likeness_of(const results::PictureResult& result,
                     const std::vector<KnownMistake>& mistakes) {
  if (result.integrated && result.state != results::State::pass) return {};
  if (mistakes.empty()) return {};
  const JudgedPicture picture = judged_picture(result);
  const BlockMeans golden =
      picture.outcome == JudgedPicture::Outcome::wrong ? golden_means(result) : BlockMeans{};
  return compare(result.recipe, recipe_hash(result.golden), picture, golden, mistakes);
}

}  // namespace grader::pictures
