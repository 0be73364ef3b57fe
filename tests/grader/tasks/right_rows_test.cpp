// The rows of right_work. Graded jobs are not graded again, so a row is read as it was written.
#include "pt/error.h"
#include "pt/file.h"
#include "tests/grader/tasks/right_work.h"

#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <unistd.h>

namespace grader::tests {
namespace {

namespace fs = std::filesystem;

class RightRows : public ::testing::Test {
 protected:
  void TearDown() override { fs::remove(file_); }

  const fs::path file_ = fs::temp_directory_path() / ("right_rows." + std::to_string(getpid()));
};

RightRow row_that_passed() {
  RightRow row;
  row.kind = "variant";
  row.name = "hit_box.slabs";
  row.seed = 7;
  row.pictures = true;
  row.busy = 30;
  row.judge = "0123456789ab";
  row.passed = true;
  row.seconds = 1.25;
  return row;
}

TEST_F(RightRows, are_read_as_they_are_written) {
  const RightRow passed = row_that_passed();
  RightRow failed = passed;
  failed.seed = 8;
  failed.pictures = failed.passed = false;
  failed.faults = "hit_box: fail [slabs]";
  pt::write_file(file_, to_line(passed) + '\n' + to_line(failed) + '\n');
  const std::vector<RightRow> rows = read_right_rows(file_);
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0].key(), passed.key());
  EXPECT_TRUE(rows[0].passed);
  EXPECT_EQ(rows[0].seconds, 1.25);
  EXPECT_EQ(rows[0].faults, "");
  EXPECT_EQ(rows[1].key(), failed.key());
  EXPECT_FALSE(rows[1].passed);
  EXPECT_EQ(rows[1].faults, failed.faults);
}

TEST_F(RightRows, that_are_cut_short_are_left_out) {
  const std::string line = to_line(row_that_passed());
  pt::write_file(file_, line + '\n' + line.substr(0, 20));
  EXPECT_EQ(read_right_rows(file_).size(), 1U);
}

TEST_F(RightRows, of_another_file_are_refused) {
  pt::write_file(file_, to_line(row_that_passed()) + "\ntask,points\n");
  try {
    read_right_rows(file_);
    ADD_FAILURE() << "it is read";
  } catch (const pt::Error& error) {
    EXPECT_EQ(error.what(),
              file_.string() + ":2: this is not a row of right_work; choose another --out");
  }
}

}  // namespace
}  // namespace grader::tests
