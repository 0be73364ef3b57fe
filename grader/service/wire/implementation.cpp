// The judge's end: the implementation `remote` of the task FIRSTLIGHT_TASK; compiled once per task.
#include "grader/service/wire/call.h"

// `names` comes with its parentheses: it is the argument list of the call.
// NOLINTBEGIN(bugprone-macro-parentheses)
#define FIRSTLIGHT_DEFINE(result, function, parameters, names) \
  result function parameters { return grader::wire::call<&pt::function> names; }
// NOLINTEND(bugprone-macro-parentheses)

namespace pt {

FIRSTLIGHT_CALLS_OF(FIRSTLIGHT_TASK)(FIRSTLIGHT_DEFINE, FIRSTLIGHT_DEFINE)

}  // namespace pt

FIRSTLIGHT_REPEATED(FIRSTLIGHT_TASK)
