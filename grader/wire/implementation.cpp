// The judge's end: the implementation `remote` of one task, FIRSTLIGHT_TASK: compiled once for each.
#include "grader/wire/call.h"

// The names come in parentheses: those of the call.
// NOLINTBEGIN(bugprone-macro-parentheses)
#define FIRSTLIGHT_DEFINE(result, function, parameters, names) \
  result function parameters { return grader::wire::call<&pt::function> names; }
// NOLINTEND(bugprone-macro-parentheses)

namespace pt {

FIRSTLIGHT_CALLS_OF(FIRSTLIGHT_TASK)(FIRSTLIGHT_DEFINE, FIRSTLIGHT_DEFINE)

}  // namespace pt

FIRSTLIGHT_REPEATED(FIRSTLIGHT_TASK)
