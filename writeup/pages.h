#pragma once

#include "writeup/figure.h"

#include <filesystem>
#include <map>
#include <string>

namespace writeup {

struct Site {
  const Catalogue& catalogue;
  const Scenes& scenes;
  std::map<std::string, Drawn> figures;  // by id; what has not been made is missing
  bool draft = false;
  std::string command;  // ./run writeup and the options that this site was made with
  std::filesystem::path texts;
  std::string by;  // author, machine and commit, for the foot of the pages
};

// The pages of a write-up, beside a folder "figures" that has their files: index.html, part1.html
// and so on, one for each text. A figure that no text of its part names is at the end of the part's
// page. Throws pt::Error for an unknown name in a text.
void write_pages(const Site& site, const std::filesystem::path& folder);

// The names of the pages, each of which has a text: index, part1 to part5, accuracy, needs, stability, bugs.
const std::vector<std::string>& page_names();

}  // namespace writeup
