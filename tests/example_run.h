#pragma once

#include "tests/example_results.h"
#include "tests/temporary_folder.h"

#include <gtest/gtest.h>

// A test of what is made of the example run.
class ExampleRun : public testing::Test {
 protected:
  // The same, as a killed run leaves it.
  grader::results::Results stopped() const {
    grader::results::Results results = run;
    results.complete = false;
    return results;
  }

  // The same, killed earlier: the pictures of direct_lights are not judged but for the first one,
  // and nothing of the last two tasks.
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
