// The tables that learning platforms import.
#include "grader/service/platforms/platforms.h"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace grader::platforms {
namespace {

using testing::HasSubstr;

const std::vector<GradeRow> kRows{{"Ada, Countess", "17", true, 22, "12 of 12 tasks pass."},
                                  {"Zoë", "18", false, 0, "it holds two archives"}};

TEST(Platforms, moodle_gets_no_grade_above_the_maximum) {
  const std::string table = moodle_csv(kRows, 20);
  EXPECT_THAT(table, HasSubstr("Participant 17,\"Ada, Countess\",,,20,20,Yes,"));
  EXPECT_THAT(table, HasSubstr("Participant 18,Zoë,,,,20,Yes,"));
}

// Canvas finds the columns of the assignment and of its maximum by their place in the line.
TEST(Platforms, canvas_gets_a_column_below_its_heading) {
  EXPECT_EQ(canvas_csv(kRows, "Rays (3)", 20),
            "Student,ID,SIS User ID,SIS Login ID,Section,Rays (3)\r\n"
            "    Points Possible,,,,,20\r\n"
            "\"Ada, Countess\",17,,,,22\r\n"
            "Zoë,18,,,,\r\n");
}

TEST(Platforms, canvas_and_gradescope_get_points_with_their_bonus) {
  EXPECT_THAT(canvas_csv(kRows, "Rays (3)", 20), HasSubstr(",Rays (3)\r\n"));
  EXPECT_THAT(canvas_csv(kRows, "Rays (3)", 20), HasSubstr("\"Ada, Countess\",17,,,,22\r\n"));
  EXPECT_THAT(gradescope_csv(kRows, 20),
              HasSubstr("\"Ada, Countess\",17,22,20,12 of 12 tasks pass.\r\n"));
  EXPECT_THAT(gradescope_csv(kRows, 20), HasSubstr("Zoë,18,,20,it holds two archives\r\n"));
}

}  // namespace
}  // namespace grader::platforms
