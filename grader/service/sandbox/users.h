#pragma once

#include "grader/base/descriptor.h"

#include <optional>

#include <sys/types.h>

// The user ids for boxes if the judge is root. No distribution assigns them (systemd's table of
// user ids calls them unused).

namespace grader::sandbox {

struct UserRange {
  uid_t first = 0, count = 0;
};

// Tiers must not share ids: when a box of tier B ends, all processes of its user are killed.
inline constexpr UserRange kUsersOfTierA{60578, 303}, kUsersOfTierB{60881, 303};
static_assert(kUsersOfTierA.first + kUsersOfTierA.count <= kUsersOfTierB.first);

// No other box has this user while `lock` is open anywhere.
struct User {
  uid_t id = 0;
  base::Descriptor lock;
};

// Returns nothing if another box has the user.
std::optional<User> take_user(uid_t id);

// In a user namespace, root cannot become other users.
bool is_root_of_the_machine();

}  // namespace grader::sandbox
