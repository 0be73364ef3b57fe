#pragma once

#include "grader/base/descriptor.h"

#include <optional>

#include <sys/types.h>

// The numbers of users that boxes become where the judge is root: no distribution gives them to anyone
// (systemd's table of user ids calls them unused).

namespace grader::sandbox {

struct UserRange {
  uid_t first = 0, count = 0;
};

// Apart from each other: when a box of tier B ends, everything that runs as its user is killed.
inline constexpr UserRange kUsersOfTierA{60578, 303}, kUsersOfTierB{60881, 303};
static_assert(kUsersOfTierA.first + kUsersOfTierA.count <= kUsersOfTierB.first);

// A user that no other box has as long as `lock` is open anywhere.
struct User {
  uid_t id = 0;
  base::Descriptor lock;
};

// Returns nothing if a box has that user.
std::optional<User> take_user(uid_t id);

// In a user namespace root is root of nothing else: there, no other user can be had.
bool is_root_of_the_machine();

}  // namespace grader::sandbox
