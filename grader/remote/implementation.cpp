// The implementation `remote` of one task, FIRSTLIGHT_TASK: compiled once for each.
#include "grader/remote/call.h"

#define FIRSTLIGHT_DEFINE(result, function, parameters, names) \
  result function parameters { return grader::remote::call<&pt::function> names; }

namespace pt {

FIRSTLIGHT_CALLS_OF(FIRSTLIGHT_TASK)(FIRSTLIGHT_DEFINE, FIRSTLIGHT_DEFINE)

}  // namespace pt

FIRSTLIGHT_REPEATED(FIRSTLIGHT_TASK)
