#pragma once

#include "grader/base/descriptor.h"
#include "grader/service/sandbox/box.h"

#include <optional>
#include <string>

namespace grader::sandbox {

// The messages of a box's launcher to its judge, through Box::tells_start. No program in a box can
// write there, so no submission can forge them. The first byte comes when only the program is left
// to start; then a second byte if that fails, or the status of the program when it has ended.
class LauncherMessages {
 public:
  // Reads what has arrived, without waiting. The descriptor must not block (base::set_nonblocking).
  void listen(const base::Descriptor& launcher);

  // Returns whether the program was started.
  bool has_started() const;

  // The program's own status, as waitpid gives it. Only tier A sends it, because there the judge
  // waits for bubblewrap; nothing is sent if the whole box was killed at once.
  std::optional<int> status() const;

 private:
  std::string bytes_;
};

// Returns the exit status of the program itself, given the child's status (both as from waitpid).
// The launcher's message counts more than the child's own status, in which 137 means exit(137) or a
// signal.
int program_status(int status, Tier tier, const LauncherMessages& messages = {});

}  // namespace grader::sandbox
