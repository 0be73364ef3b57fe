// The line that shows the progress of a long run; a pipe replaces standard error.
#include "grader/report/status_line.h"

#include "grader/base/descriptor.h"

#include <chrono>
#include <regex>
#include <string>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <unistd.h>

namespace grader::report {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;

class StatusLineTest : public testing::Test {
 protected:
  StatusLineTest() : standard_error_(dup(STDERR_FILENO)) {
    dup2(pipe_.write_end.number(), STDERR_FILENO);
  }
  ~StatusLineTest() override { dup2(standard_error_.number(), STDERR_FILENO); }

  // Returns the first text written within this many milliseconds, or an empty text.
  std::string said(int within) const {
    pollfd ready{pipe_.read_end.number(), POLLIN, 0};
    if (poll(&ready, 1, within) <= 0) return "";
    char buffer[4096];
    const ssize_t got = read(pipe_.read_end.number(), buffer, sizeof buffer);
    return {buffer, got > 0 ? static_cast<std::size_t>(got) : 0};
  }

  static constexpr int kSoon = 30000;  // the wait ends earlier if something is said
  const base::Pipe pipe_ = base::make_pipe();
  const base::Descriptor standard_error_;
};

TEST_F(StatusLineTest, comes_by_itself_and_again_after_it_was_cleared) {
  StatusLine line(StatusLine::Output::terminal);
  line.show("judging: 3 of 8 verdicts", 3. / 8);
  const std::string first = said(kSoon);
  EXPECT_THAT(first, HasSubstr("judging: 3 of 8 verdicts"));
  EXPECT_THAT(first, Not(HasSubstr("left")));  // too early to tell
  EXPECT_THAT(first, Not(HasSubstr("\n")));
  line.show("judging: 4 of 8 verdicts", .5);
  EXPECT_THAT(said(kSoon), HasSubstr("4 of 8"));
  line.clear();
  EXPECT_THAT(said(kSoon), EndsWith("\r\x1b[K"));
  EXPECT_THAT(said(kSoon), HasSubstr("4 of 8"));
}

TEST_F(StatusLineTest, is_removed_in_the_end) {
  {
    StatusLine line(StatusLine::Output::terminal);
    line.show("writing", 0);
    EXPECT_THAT(said(kSoon), HasSubstr("writing"));
  }
  EXPECT_THAT(said(kSoon), EndsWith("\r\x1b[K"));
}

TEST_F(StatusLineTest, says_nothing_of_what_is_over_at_once) {
  for (const auto output : {StatusLine::Output::terminal, StatusLine::Output::log}) {
    StatusLine line(output);
    line.show("judging", .5);
    line.clear();
  }
  StatusLine quiet(StatusLine::Output::none);
  quiet.show("judging", .5);
  EXPECT_EQ(said(1500), "");
}

// Half of the work is done, so the rest takes as long again. The time shown includes all before.
TEST_F(StatusLineTest, tells_the_time_left_by_that_of_this_work_alone) {
  StatusLine line(StatusLine::Output::log, std::chrono::milliseconds(100));
  line.show("reading", 0);
  std::this_thread::sleep_for(std::chrono::seconds(3));
  line.show("judging", 0);
  line.show("judging", .5);
  const std::regex told(R"(judging, about (\d+) s left \((\d+) s\)\n)");
  std::smatch found;
  std::string text;
  while (!std::regex_search(text, found, told)) {
    const std::string more = said(kSoon);
    ASSERT_NE(more, "") << text;
    text += more;
  }
  EXPECT_LT(std::stoi(found[1]), std::stoi(found[2]));
}

// Nine tenths are done, so the rest takes a ninth of their time.
TEST_F(StatusLineTest, tells_the_time_left_by_the_part_that_is_done) {
  StatusLine line(StatusLine::Output::log, std::chrono::milliseconds(100));
  line.show("judging", 0);
  line.show("judging", .9);
  const std::regex told(R"(judging, about (\d+) s left \((\d+) s\)\n)");
  std::smatch found;
  std::string text;
  while (!std::regex_search(text, found, told)) {
    const std::string more = said(kSoon);
    ASSERT_NE(more, "") << text;
    text += more;
  }
  EXPECT_LT(std::stoi(found[1]), std::stoi(found[2]));
}

TEST_F(StatusLineTest, is_a_line_now_and_then_in_a_log) {
  StatusLine line(StatusLine::Output::log, std::chrono::milliseconds(100));
  line.show("judging: 3 of 8 verdicts", 3. / 8);
  const std::string first = said(kSoon);
  EXPECT_THAT(first, HasSubstr("judging: 3 of 8 verdicts"));
  EXPECT_THAT(first, Not(HasSubstr("\x1b")));
  EXPECT_EQ(first.back(), '\n');
  EXPECT_THAT(said(kSoon), HasSubstr("judging: 3 of 8 verdicts"));
}

}  // namespace
}  // namespace grader::report
