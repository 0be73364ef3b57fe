#pragma once

#include "grader/base/descriptor.h"
#include "grader/sandbox/box.h"

#include <optional>
#include <string>

namespace grader::sandbox {

// The messages of a box's launcher to its judge, through Box::tells_start. No program in a box can
// write there, so no submission can forge them. First comes a byte when nothing but the program is
// left to start, then a second byte if that fails, or the status of the program when it has ended.
class LauncherMessages {
 public:
  // Takes what has come; does not wait for more. The descriptor does not block (base::set_nonblocking).
  void listen(const base::Descriptor& launcher);

  // Returns whether nothing but the program itself was left to start, and it could be started.
  bool has_started() const;

  // The program's own status, as waitpid gives it. Only tier A tells it, where the judge waits for
  // bubblewrap, and not where all of the box was killed at once.
  std::optional<int> status() const;

 private:
  std::string bytes_;
};

// Returns the exit status of the program itself, given that of the child (as waitpid gives both). The
// launcher's message counts more than the child's own status, in which 137 is either exit(137) or a
// signal.
int program_status(int status, Tier tier, const LauncherMessages& messages = {});

}  // namespace grader::sandbox
