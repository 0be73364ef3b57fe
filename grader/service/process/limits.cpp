#include "grader/service/process/limits.h"

#include <sys/resource.h>

namespace grader::process {

namespace {

// The type of a resource differs between systems.
bool limit(auto resource, const std::optional<std::uint64_t>& most) {
  if (!most) return true;
  const rlimit both{*most, *most};
  return setrlimit(resource, &both) == 0;
}

}  // namespace

bool set_limits(const Limits& limits) {
  return limit(RLIMIT_CPU, limits.cpu_seconds) &&
         (kSanitized || limit(RLIMIT_AS, limits.address_space)) &&
         limit(RLIMIT_FSIZE, limits.file_size) && limit(RLIMIT_NPROC, limits.processes) &&
         limit(RLIMIT_NOFILE, limits.open_files) && limit(RLIMIT_CORE, 0);
}

}  // namespace grader::process
