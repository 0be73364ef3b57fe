#pragma once

#include "grader/results/results.h"

#include <array>
#include <string>

// The files that platforms read when a submission has been graded in their container. Bonus points
// are part of a task's points, which may then exceed the maximum. The file of an unfinished run is
// complete too, and says that the run was stopped.

namespace grader::report {

// The results.json of Gradescope (its autograder documentation, "Output Format"): one test per task,
// all visible, in plain text.
std::string to_gradescope(const results::Results& results);

// The results.json of PrairieLearn (docs/externalGrading.md, "Grading results"): the share of all
// points, at most 1, and one test per task. It may have 1 MB.
std::string to_prairielearn(const results::Results& results);

// Autolab's standard output (docs/lab.md and docs/features/formatted-feedback.md): text for people,
// then a line with a stage per part, and last a line with the points of each task, which
// is a problem of that name.
std::string to_autolab(const results::Results& results);

// The results of Artemis (TestResultXmlParser.java): JUnit's XML with a test case per promise and per
// picture, which passes if it has all its points. Artemis knows no part of a test's points, so
// those that one cause gives back are missing. A bonus promise that is not kept is left out.
std::string to_artemis(const results::Results& results);

// All of them. The name is that of the option of `grade`, too.
struct Autograder {
  const char* name;
  const char* words;
  std::string (*write)(const results::Results& results);
};
inline constexpr std::array kAutograders{
    Autograder{"gradescope", "Gradescope's results.json", to_gradescope},
    Autograder{"prairielearn", "PrairieLearn's results.json", to_prairielearn},
    Autograder{"autolab", "Autolab's output", to_autolab},
    Autograder{"artemis", "Artemis' test results", to_artemis}};

}  // namespace grader::report
