#pragma once

#include "tests/fixtures/temporary_folder.h"
#include "tests/grader/report/example_results.h"

#include <gtest/gtest.h>

// A test of output that is made from the example run.
class ExampleRun : public testing::Test {
 protected:
  // The same run as a kill leaves it.
  grader::results::Results stopped() const {
    grader::results::Results results = run;
    results.complete = false;
    return results;
  }

  // The same run, killed earlier: of direct_lights only the first picture is judged, and of the
  // last two tasks nothing.
  grader::results::Results half_judged() const {
    grader::results::Results results = stopped();
    for (std::size_t i = 6; i < results.tasks.size(); ++i) {
      grader::results::TaskResult& task = results.tasks[i];
      task.state = grader::results::State::not_judged;
      task.reason.clear();
      task.blamed.clear();
      task.points = i == 6 ? 5 : 0;
      for (grader::results::PromiseResult& promise : task.promises) promise.held = i == 6;
      for (grader::results::PictureResult& picture : task.pictures) {
        if (i == 6 && picture.recipe == "two_lights") continue;
        grader::results::PictureResult fresh;
        fresh.recipe = picture.recipe;
        fresh.title = picture.title;
        fresh.max_points = 3;
        picture = fresh;
      }
    }
    return results;
  }

  const TemporaryFolder folder;
  const grader::results::Results run = example_results(folder.path());
};
