#pragma once

#include "grader/wire/message.h"

#include <string>

// The worker's end of the conversation (grader/wire/message.h), on two descriptors that it finds
// open when it starts.

namespace grader::wire {

inline constexpr int kFromJudge = 3;
inline constexpr int kToJudge = 4;

// The next message's payload; ends the process if the judge is gone or sends another kind.
std::string receive(Kind kind);

// About the call that was received last.
void send(Kind kind, std::string_view payload);

}  // namespace grader::wire
