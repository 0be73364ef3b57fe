#include "grader/check/generators/precision.h"

namespace grader::check {

namespace {

bool is_allowed = false;

}  // namespace

void allow_single_precision() { is_allowed = true; }

bool is_single_precision_allowed() { return is_allowed; }

}  // namespace grader::check
