#pragma once

#include <map>
#include <optional>
#include <string>

namespace grader::platforms {

// "Grade: 58 points (2 days late, 20 % less)." Empty if there is no reason: then the points are those that were judged.
std::string grade_sentence(const std::optional<int>& points, const std::string& reason);

// A learner's page with the grade, and with the file of each task, by slug, beside its verdict. The page's template has
// comments at these places, so that a page that was finished already is finished anew.
std::string finished_page(std::string page, const std::string& grade,
                          const std::map<std::string, std::string>& files);

}  // namespace grader::platforms
