#include "grader/check/cause.h"

namespace grader::check {

const char* name(Cause cause) {
  switch (cause) {
    case Cause::wrong:
      return "wrong";
    case Cause::crash:
      return "crash";
    case Cause::timeout:
      return "timeout";
    case Cause::bad_reply:
      return "bad reply";
    case Cause::not_attempted:
      return "not attempted";
  }
  return "";
}

}  // namespace grader::check
