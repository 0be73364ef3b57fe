#include "grader/service/classes/claim.h"

#include "pt/error.h"

#include <cerrno>
#include <cstring>
#include <functional>

#include <fcntl.h>
#include <fmt/format.h>

namespace grader::classes {

// All names share one file. Each locks a byte of its own, far beyond the end of the file, as POSIX
// allows. If two names have the same byte, one claim only waits for the other.
Claim::Claim(const std::string& folder, const std::string& name) {
  const std::string path = folder + "/claims";
  file_ = base::Descriptor(open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644));
  struct flock range {};
  range.l_type = F_WRLCK;
  range.l_whence = SEEK_SET;
  range.l_start = static_cast<off_t>(std::hash<std::string>{}(name) >> 2);
  range.l_len = 1;
  int taken = -1;
  do {
    taken = file_.is_open() ? fcntl(file_.number(), F_OFD_SETLKW, &range) : -1;
  } while (taken < 0 && file_.is_open() && errno == EINTR);
  if (taken < 0) {
    throw pt::Error(fmt::format("{}: cannot be locked ({}); put the reports on a disk that can",
                                path, std::strerror(errno)));
  }
}

}  // namespace grader::classes
