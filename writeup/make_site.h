#pragma once

#include "writeup/options.h"
#include "writeup/pages.h"

#include <filesystem>
#include <string>
#include <vector>

namespace writeup {

// The figures with these names or of these parts; all without words. Throws pt::Error for a word
// that is neither.
std::vector<const Figure*> figures_meant(const Catalogue& catalogue,
                                         const std::vector<std::string>& words);

// Makes the renders and measurements that are missing for the figures, in as many rounds as it takes.
// Returns false if none was missing.
bool make_missing(const Plan& plan, const std::vector<const Figure*>& figures,
                  const Options& options);

// Returns whether all renders and measurements of a figure are there, or have failed for good.
bool is_settled(const Plan& plan, const Figure& figure);

// Draws all settled figures into `folder`; a figure is drawn again only if something has changed.
std::map<std::string, Drawn> draw_figures(const Plan& plan, const Catalogue& catalogue,
                                          const std::filesystem::path& drawn,
                                          const std::filesystem::path& folder, int threads);

}  // namespace writeup
