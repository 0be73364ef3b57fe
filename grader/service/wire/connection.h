#pragma once

#include "grader/service/wire/message.h"

#include <optional>
#include <string>
#include <string_view>

// The worker's end of the conversation (grader/service/wire/message.h), on two descriptors that are
// open when it starts.

namespace grader::wire {

inline constexpr int kFromJudge = 3;
inline constexpr int kToJudge = 4;

// Returns the next message's payload. Ends the process if the judge is gone or sends another kind.
std::string receive(Kind kind);

// Sends a message about the last received call.
void send(Kind kind, std::string_view payload);

// The radiances that the judge has given in advance for the call that begins.
void begin_with(std::optional<RadiancesAhead> ahead);

// The same radiances from the first one on.
void begin_again();

// Returns the next of them, if there are any, and draws from the sampler as radiance() does.
std::optional<pt::Rgb> next_ahead(pt::Sampler& sampler);

// The judge may want to hear of the calls that get them. It gets such a question before any other message.
bool wants_to_be_told();
void tell(std::string_view question);

}  // namespace grader::wire
