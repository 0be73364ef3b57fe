// The users of boxes, which several judges on one machine share.
#include "grader/service/sandbox/box.h"
#include "grader/service/sandbox/users.h"
#include "pt/error.h"

#include <optional>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace grader::sandbox {
namespace {

// Returns the user that the launcher gets, or an empty text.
std::string user_of(const process::Child& child) {
  for (const std::string& word : child.command) {
    if (word.starts_with("--user=")) return word.substr(word.find('=') + 1);
  }
  return "";
}

TEST(Users, are_taken_as_long_as_somebody_holds_them) {
  // The first number after the range, which no box has.
  const uid_t id = kUsersOfTierB.first + kUsersOfTierB.count;
  {
    const std::optional<User> user = take_user(id);
    ASSERT_TRUE(user.has_value());
    EXPECT_EQ(user->id, id);
    EXPECT_FALSE(take_user(id).has_value());
  }
  EXPECT_TRUE(take_user(id).has_value());
}

TEST(Users, of_tier_A_are_each_in_one_box_only) {
  if (!is_root_of_the_machine()) GTEST_SKIP() << "NOT TESTED: only root can become another user";
  const Box box{{"/bin/true"}, {}, {}, {}, "", false, {}};
  std::vector<process::Child> children;
  std::set<std::string> users;
  const auto take_all = [&] {
    for (uid_t i = 0; i <= kUsersOfTierA.count; ++i) {
      children.push_back(boxed(box, Tier::bubblewrap));
      EXPECT_TRUE(users.insert(user_of(children.back())).second) << user_of(children.back());
    }
  };
  EXPECT_THROW(take_all(), pt::Error);
  EXPECT_GT(children.size(), kUsersOfTierA.count / 2);  // other judges may be running
  EXPECT_FALSE(users.contains(""));
  children.clear();
  EXPECT_TRUE(users.contains(user_of(boxed(box, Tier::bubblewrap))));
}

}  // namespace
}  // namespace grader::sandbox
