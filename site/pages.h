#pragma once

#include <filesystem>
#include <string>

namespace site {

struct Sources {
  std::filesystem::path root;     // of the project
  std::filesystem::path samples;  // pages that other commands have made; empty: none
  std::filesystem::path live;     // the reference compiled for browsers, as a script; empty: none
};

// Writes the site into a folder: the handbook, what instructors need, the contracts that these pages link to, the samples, and the
// front page. Links are relative. Throws pt::Error for a picture that does not exist.
void write_site(const Sources& sources, const std::filesystem::path& folder);

}  // namespace site
