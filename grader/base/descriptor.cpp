#include "grader/base/descriptor.h"

#include "pt/error.h"

#include <cerrno>
#include <cstring>

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

namespace grader::base {

Pipe make_pipe() {
  int ends[2];
#ifdef __APPLE__
  const bool is_made = pipe(ends) == 0;
  if (is_made) {
    for (const int end : ends) fcntl(end, F_SETFD, FD_CLOEXEC);
  }
#else
  const bool is_made = pipe2(ends, O_CLOEXEC) == 0;
#endif
  if (!is_made) throw pt::Error(fmt::format("cannot make a pipe: {}", std::strerror(errno)));
  return {Descriptor(ends[0]), Descriptor(ends[1])};
}

void set_nonblocking(const Descriptor& descriptor) {
  fcntl(descriptor.number(), F_SETFL, fcntl(descriptor.number(), F_GETFL) | O_NONBLOCK);
}

}  // namespace grader::base
