#pragma once

#include "grader/service/wire/message.h"

// The worker's end: turns the bytes of a call into the bytes of its reply.

namespace grader::wire {

// Answers one call, the payload of a message, with the functions that are linked into this program.
std::string serve(std::string_view call);

}  // namespace grader::wire
