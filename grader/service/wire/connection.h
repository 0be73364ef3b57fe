#pragma once

#include "grader/service/wire/message.h"

#include <string>

// The worker's end of the conversation (grader/service/wire/message.h), on two descriptors that are
// open when it starts.

namespace grader::wire {

inline constexpr int kFromJudge = 3;
inline constexpr int kToJudge = 4;

// Returns the next message's payload. Ends the process if the judge is gone or sends another kind.
std::string receive(Kind kind);

// Sends a message about the last received call.
void send(Kind kind, std::string_view payload);

}  // namespace grader::wire
