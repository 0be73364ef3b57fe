#pragma once

#include "grader/report/html.h"
#include "grader/results/results.h"

#include <map>
#include <string>

#include <kainjow/mustache.hpp>

namespace grader::report {

// The place of each picture on a page. A picture that judges several tasks is there once, with the
// first of them; the others refer to that place.
class Places {
 public:
  explicit Places(PageSize size) : size_(size) {}

  PageSize size() const { return size_; }

  // Returns the place of a picture that is shown in the same way in every detail, if there is one.
  // Otherwise this place is kept, and the answer is empty.
  std::string taken(const results::PictureResult& picture, const std::string& place);

 private:
  PageSize size_;
  std::map<std::string, std::string> places_;  // by everything that is shown
};

// The data of a picture of a task for the template.
kainjow::mustache::data picture_data(const results::PictureResult& picture, const std::string& slug,
                                     Places& places);

// The class of page.css that colours a state.
const char* tone(results::State state);

}  // namespace grader::report
