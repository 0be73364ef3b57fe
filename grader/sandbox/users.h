#pragma once

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

}  // namespace grader::sandbox
