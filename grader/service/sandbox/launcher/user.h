#pragma once

#include "grader/service/sandbox/users.h"

#include <optional>

namespace grader::sandbox::box {

using sandbox::User;

// A user for tier B, which only root can have. Throws pt::Error if all are taken.
User take_any_user();

// This process becomes the user, irrevocably. Throws pt::Error if that is impossible.
void become(const User& user);

// Starts a keeper process. It waits until this process or its parent has ended, and then ends the
// rest: this process's group, and all processes of the user if there is one. Meanwhile it holds the
// user's lock and no other descriptor.
void start_keeper(const std::optional<User>& user);

// In its own process namespace, this process continues as a child. The parent waits, writes the
// child's status to the descriptor `told` (-1: nowhere), and ends with the child's exit status, or
// with 128 plus the number of its signal. All other processes of the namespace end with it.
void continue_as_child(int told);

}  // namespace grader::sandbox::box
