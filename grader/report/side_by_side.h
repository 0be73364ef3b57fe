#pragma once

#include "pt/image/image.h"
#include "pt/image/picture.h"

#include <string>
#include <vector>

namespace grader::report {

// Two pictures of one scene, of one size, and what is known of their difference. All texts are escaped.
struct SideBySide {
  std::string title;
  std::string verdict;    // "agrees", "wrong", "cannot say"; empty if nobody asked
  std::string text;       // a sentence, or lines of numbers
  pt::Image left, right;  // linear radiance
  std::string left_name, right_name;
  pt::Picture map;  // of the difference or of the evidence
  std::string map_text;
};

// A page that fetches nothing: of each pair both pictures, one over the other with a slider, the map, and the text. `foot` says how to make it
// again.
std::string side_by_side_page(const std::string& title, const std::vector<SideBySide>& pairs,
                              const std::string& foot);

}  // namespace grader::report
