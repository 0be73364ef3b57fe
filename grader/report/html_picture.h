#pragma once

#include "grader/report/results.h"

#include <kainjow/mustache.hpp>

namespace grader {

// What the template is told about a picture of a task.
kainjow::mustache::data picture_data(const PictureResult& picture);

// How a state is coloured: a class of page.css.
const char* tone(State state);

}  // namespace grader
