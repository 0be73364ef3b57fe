#pragma once

#include "grader/results/results.h"

#include <map>
#include <string>

#include <kainjow/mustache.hpp>

namespace grader::report {

// Where on a page each picture is. One that judges several tasks is in it once, with the first of
// them; the others refer to that place.
class Places {
 public:
  // The place of the same picture, the same in all that is shown of it, if it has one already;
  // otherwise it gets this one, and the answer is empty.
  std::string taken(const results::PictureResult& picture, const std::string& place);

 private:
  std::map<std::string, std::string> places_;  // by what is shown
};

// What the template is told about a picture of a task.
kainjow::mustache::data picture_data(const results::PictureResult& picture, const std::string& slug,
                                     Places& places);

// How a state is coloured: a class of page.css.
const char* tone(results::State state);

}  // namespace grader::report
