#pragma once

#include "grader/sandbox/users.h"

#include <optional>

namespace grader::sandbox::box {

using sandbox::User;

// A user of tier B. Only root can have one. Throws pt::Error if all are taken.
User take_any_user();

// This process becomes the user, for good. Throws pt::Error if that cannot be.
void become(const User& user);

// Starts a process that waits until this one or the one that started it has ended, then ends what
// is left: this process's group, and all processes of the user if there is one. It holds the user's
// lock meanwhile, and no other descriptor.
void start_keeper(const std::optional<User>& user);

// In a process namespace of its own, this process goes on as a child; the parent waits, writes the
// child's status to the descriptor `told` (-1: nowhere), and ends with its exit status, or 128 and the
// number of its signal. All others end with it.
void continue_as_child(int told);

}  // namespace grader::sandbox::box
