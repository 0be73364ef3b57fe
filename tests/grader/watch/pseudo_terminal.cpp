#include "tests/grader/watch/pseudo_terminal.h"

#include <algorithm>
#include <csignal>
#include <stdexcept>

#include <gtest/gtest.h>
#include <poll.h>
#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>
#include <utmp.h>

PseudoTerminal::PseudoTerminal(std::vector<std::string> command) {
  if (openpty(&screen_, &device_, nullptr, nullptr, nullptr) != 0) {
    throw std::runtime_error("cannot open a pseudo-terminal");
  }
  before_ = mode();
  std::vector<char*> arguments;
  for (std::string& word : command) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  pid_ = fork();
  if (pid_ == 0) {
    close(screen_);
    if (login_tty(device_) != 0) _exit(127);
    execv(arguments[0], arguments.data());
    _exit(127);
  }
}

PseudoTerminal::~PseudoTerminal() {
  if (!ended_) {
    kill(pid_, SIGKILL);
    waitpid(pid_, nullptr, 0);
  }
  close(screen_);
  close(device_);
}

void PseudoTerminal::type(const std::string& keys) {
  ASSERT_EQ(write(screen_, keys.data(), keys.size()), static_cast<ssize_t>(keys.size()));
}

void PseudoTerminal::send_signal(int signal) const { kill(pid_, signal); }

std::string PseudoTerminal::expect(const std::string& text) {
  while (unread_.find(text) == std::string::npos) {
    pollfd ready{screen_, POLLIN, 0};
    if (poll(&ready, 1, 30000) <= 0) {
      ADD_FAILURE() << "waited for '" << text << "', but there was only\n" << unread_;
      return unread_;
    }
    char buffer[4096];
    const ssize_t got = read(screen_, buffer, sizeof buffer);
    unread_.append(buffer, static_cast<std::size_t>(std::max<ssize_t>(got, 0)));
  }
  const std::size_t end = unread_.find(text) + text.size();
  std::string seen = unread_.substr(0, end);
  unread_.erase(0, end);
  return seen;
}

int PseudoTerminal::wait() {
  int status = 0;
  waitpid(pid_, &status, WUNTRACED);
  ended_ = !WIFSTOPPED(status);
  return status;
}

termios PseudoTerminal::mode() const {
  termios mode{};
  if (tcgetattr(device_, &mode) != 0) throw std::runtime_error("a terminal without a mode");
  return mode;
}

bool operator==(const termios& a, const termios& b) {
  return a.c_iflag == b.c_iflag && a.c_oflag == b.c_oflag && a.c_cflag == b.c_cflag &&
         a.c_lflag == b.c_lflag && std::equal(std::begin(a.c_cc), std::end(a.c_cc), b.c_cc);
}
