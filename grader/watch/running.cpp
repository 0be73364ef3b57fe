#include "grader/watch/running.h"

#include "grader/service/process/run_command.h"

#include <algorithm>
#include <cerrno>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace grader::watch {

Running::Running(const std::vector<std::string>& command) {
  process::Child child{command, process::own_environment(), {}, "", {}};
  const base::Descriptor nothing(open("/dev/null", O_RDONLY | O_CLOEXEC));
  base::Pipe pipe = base::make_pipe();
  child.descriptors = {nothing.number(), pipe.write_end.number(), pipe.write_end.number()};
  pid_ = process::spawn(child);
  output_ = std::move(pipe.read_end);
  base::set_nonblocking(output_);
}

Running::~Running() {
  if (pid_ > 0) process::kill_child(pid_);
}

std::optional<int> Running::poll() {
  read_output();
  int status = 0;
  if (pid_ < 0 || waitpid(pid_, &status, WNOHANG) != pid_) return std::nullopt;
  pid_ = -1;
  read_output();
  return status;
}

double Running::seconds() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

void Running::read_output() {
  char buffer[1 << 14];
  while (output_.is_open()) {
    const ssize_t got = read(output_.number(), buffer, sizeof buffer);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0 && errno == EAGAIN) return;
    if (got <= 0) {
      output_.close();  // or poll would find the end of it again and again
      return;
    }
    const std::size_t room = process::kMaxOutput - text_.size();
    text_.append(buffer, std::min(room, static_cast<std::size_t>(got)));
  }
}

}  // namespace grader::watch
