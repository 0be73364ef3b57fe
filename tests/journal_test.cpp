// A run begins with the measurements of one that was stopped.
#include "writeup/accuracy/journal.h"

#include "tests/temporary_folder.h"

#include <gtest/gtest.h>

namespace writeup::accuracy {
namespace {

using Numbers = std::vector<double>;

TEST(Journal, answers_the_same_questions_in_the_same_order) {
  const TemporaryFolder folder;
  {
    Journal journal(folder.path() + "/a");
    EXPECT_FALSE(journal.goes_on());
    EXPECT_EQ(journal.next("one"), std::nullopt);
    journal.keep("one", {1, 2, 3});
    EXPECT_EQ(journal.next("two"), std::nullopt);
    journal.keep("two", {});
    journal.keep("three", {.5});
  }
  Journal journal(folder.path() + "/a");
  EXPECT_TRUE(journal.goes_on());
  EXPECT_EQ(journal.next("one"), (Numbers{1, 2, 3}));
  EXPECT_EQ(journal.next("two"), Numbers{});
  EXPECT_EQ(journal.next("three"), Numbers{.5});
  EXPECT_EQ(journal.next("four"), std::nullopt);
}

TEST(Journal, forgets_what_comes_after_another_question) {
  const TemporaryFolder folder;
  {
    Journal journal(folder.path() + "/a");
    for (const double number : {1., 2., 3.}) journal.keep("same", {number});
  }
  {
    Journal journal(folder.path() + "/a");
    EXPECT_EQ(journal.next("same"), Numbers{1});
    EXPECT_EQ(journal.next("else"), std::nullopt);
    EXPECT_EQ(journal.next("same"), std::nullopt) << "that was the third, not the second";
    journal.keep("else", {7});
  }
  Journal journal(folder.path() + "/a");
  EXPECT_EQ(journal.next("same"), Numbers{1});
  EXPECT_EQ(journal.next("else"), Numbers{7});
  EXPECT_EQ(journal.next("same"), std::nullopt);
}

// A run may be killed while it writes: with any part of the last entry, the others are whole.
TEST(Journal, half_an_entry_is_none) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path() + "/a";
  {
    Journal journal(file);
    journal.keep("one", {1});
    journal.keep("two", {2});
  }
  const auto whole = std::filesystem::file_size(file);
  for (auto size = whole - 1; size > whole / 2; --size) {
    std::filesystem::resize_file(file, size);
    Journal journal(file);
    EXPECT_EQ(journal.next("one"), Numbers{1}) << size;
    EXPECT_EQ(journal.next("two"), std::nullopt) << size;
  }
}

TEST(Journal, of_another_run_is_left_alone) {
  const TemporaryFolder folder;
  Journal first(folder.path() + "/a");
  first.keep("one", {1});
  Journal second(folder.path() + "/a");
  EXPECT_EQ(second.next("one"), std::nullopt);
  second.keep("one", {2});
  second.remove();
  EXPECT_TRUE(std::filesystem::exists(folder.path() + "/a"));
  first.remove();
  EXPECT_FALSE(std::filesystem::exists(folder.path() + "/a"));
}

}  // namespace
}  // namespace writeup::accuracy
