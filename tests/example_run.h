#pragma once

#include "tests/example_results.h"
#include "tests/temporary_folder.h"

#include <gtest/gtest.h>

// A test of what is made of the example run.
class ExampleRun : public testing::Test {
 protected:
  // The same, as a killed run leaves it.
  grader::Results stopped() const {
    grader::Results results = run;
    results.complete = false;
    return results;
  }

  const TemporaryFolder folder;
  const grader::Results run = example_results(folder.path());
};
