#pragma once

#include "grader/wire/message.h"

// The worker's end: from the bytes of a call to those of its reply.

namespace grader::wire {

// Answers one call, a message's payload, by the functions that this program is linked with.
std::string serve(std::string_view call);

// The record of hit_bvh's inner tests while a call of it runs; else nullptr.
Tests* tests_of_this_call();

}  // namespace grader::wire
