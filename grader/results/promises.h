#pragma once

#include <string>
#include <vector>

namespace grader::results {

// A promise as a contract states it.
struct Promise {
  std::string name;   // "keeps_t_inside_the_ray", the name of its property
  std::string title;  // "keeps t inside the ray"
  std::string words;  // "no hit before t_min, behind the origin, or beyond t_max."
  bool bonus = false;
};

// The promises listed in the text of a header in pt/tasks/.
std::vector<Promise> promises_of(const std::string& header);

// The name of the property for a title: "keeps the ray's range (bonus)" is
// keeps_the_rays_range_bonus.
std::string property_name(const std::string& title);

}  // namespace grader::results
