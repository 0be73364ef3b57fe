#include "grader/watch/raw_terminal.h"

#include "pt/error.h"

#include <cerrno>
#include <csignal>

#include <unistd.h>

namespace grader::watch {

namespace {

constexpr int kAsked[] = {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGTSTP, SIGCHLD};
constexpr int kCrashes[] = {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT};

// Variables of the signal handlers, which have no other arguments.
int signal_pipe = -1;
termios terminal_as_found;

void note(int signal) {
  const int before = errno;
  const auto byte = static_cast<unsigned char>(signal);
  [[maybe_unused]] const auto written = write(signal_pipe, &byte, 1);
  errno = before;
}

// SA_RESETHAND: a second signal ends the program.
void restore_and_crash(int signal) {
  tcsetattr(STDIN_FILENO, TCSANOW, &terminal_as_found);
  raise(signal);
}

void handle(int signal, void (*handler)(int), int flags) {
  struct sigaction action {};
  action.sa_handler = handler;
  action.sa_flags = flags;
  sigaction(signal, &action, nullptr);
}

}  // namespace

RawTerminal::RawTerminal() : signals_(base::make_pipe()) {
  if (tcgetattr(STDIN_FILENO, &found_) != 0) {
    throw pt::Error("watch needs a terminal for its keys, and this is not one; use grade instead");
  }
  base::set_nonblocking(signals_.read_end);
  base::set_nonblocking(signals_.write_end);
  signal_pipe = signals_.write_end.number();
  terminal_as_found = found_;
  for (const int signal : kCrashes) handle(signal, restore_and_crash, SA_RESETHAND);
  for (const int signal : kAsked) handle(signal, note, SA_RESTART);
  enter();
}

RawTerminal::~RawTerminal() {
  leave();
  for (const int signal : kAsked) handle(signal, SIG_DFL, 0);
  for (const int signal : kCrashes) handle(signal, SIG_DFL, 0);
}

std::optional<int> RawTerminal::next_signal() {
  unsigned char signal = 0;
  if (read(signals_.read_end.number(), &signal, 1) != 1) return std::nullopt;
  return signal;
}

void RawTerminal::stop_program() {
  leave();
  raise(SIGSTOP);
  enter();
}

void RawTerminal::enter() const {
  termios raw = found_;
  raw.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);
  raw.c_cc[VMIN] = 1;
  raw.c_cc[VTIME] = 0;
  tcsetattr(STDIN_FILENO, TCSADRAIN, &raw);
}

// Keys that were typed and not read are dropped: they were meant for us, not for the shell.
void RawTerminal::leave() const { tcsetattr(STDIN_FILENO, TCSAFLUSH, &found_); }

}  // namespace grader::watch
