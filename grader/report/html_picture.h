#pragma once

#include "grader/report/html.h"
#include "grader/results/results.h"

#include <map>
#include <string>

#include <kainjow/mustache.hpp>

namespace grader::report {

// The place of each picture on a page. One that judges several tasks is in it once, with the first
// of them; the others refer to that place.
class Places {
 public:
  explicit Places(PageSize size) : size_(size) {}

  PageSize size() const { return size_; }

  // The place of the same picture, the same in all that is shown of it, if it has one already;
  // otherwise it gets this one, and the answer is empty.
  std::string taken(const results::PictureResult& picture, const std::string& place);

 private:
  PageSize size_;
  std::map<std::string, std::string> places_;  // by what is shown
};

// The data of a picture of a task for the template.
kainjow::mustache::data picture_data(const results::PictureResult& picture, const std::string& slug,
                                     Places& places);

// The class of page.css that colours a state.
const char* tone(results::State state);

}  // namespace grader::report
