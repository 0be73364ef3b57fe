#pragma once

#include "grader/pictures/recipes/recipes.h"

#include <cstdint>
#include <filesystem>
#include <string>

// The origin of a golden: golden/<recipe>.json, beside <recipe>.exr.

namespace grader::pictures {

struct Provenance {
  std::string recipe;
  std::string command;
  std::string commit;  // of the reference that rendered it, as git describes it
  std::uint64_t first_seed = 0;
  int parts = 0;    // each with the next seed
  int samples = 0;  // per pixel in all; for an adaptive recipe the runs: each is a sample
  double cpu_seconds = 0;
  std::string because;   // the reason to replace a golden that contradicts it; mostly empty
  std::string settings;  // of the recipe, as recipe_settings returns them
  std::string sha256;    // picture_hash() of the recipe
  std::string files;     // hash_of() the golden's files
};

// The settings that determine a recipe's picture, as JSON in one line: neither name, title, tasks
// nor seed.
std::string recipe_settings(const Recipe& recipe);

// A hash of those settings and the bytes of the scene. A golden with another hash is out of date.
std::string picture_hash(const Recipe& recipe);

void write_provenance(const std::filesystem::path& file, const Provenance& provenance);

// Throws pt::Error with the file's name if it is missing or was not written by write_provenance.
Provenance read_provenance(const std::filesystem::path& file);

// The files of a recipe's golden.
struct GoldenFiles {
  std::filesystem::path film;  // mean and variance of a sample
  std::filesystem::path provenance;
  std::filesystem::path rates;  // of an adaptive recipe: the reference of its sample map
};
GoldenFiles golden_files(const std::filesystem::path& folder, const std::string& recipe);

// A hash of the film and of the reference of the sample map.
std::string hash_of(const GoldenFiles& files);

// Throws pt::Error if the files are not those that were made: somebody has put another picture in
// their place. A film that is missing is not looked at.
void expect_as_made(const GoldenFiles& files);

}  // namespace grader::pictures
