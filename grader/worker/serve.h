#pragma once

#include "grader/remote/message.h"

namespace grader::worker {

// Answers one call, a message's payload, by the functions that this program is linked with.
std::string serve(std::string_view call);

// Runs the call that is being answered once more, about another ray, in another thread, and waits
// for its end. Only for functions whose last argument is a ray; for others, does nothing.
void run_again(const pt::Ray& ray);

// Where hit_bvh's inner tests are written down while a call of it runs; else nullptr.
remote::Tests* tests_of_this_call();

}  // namespace grader::worker
