#pragma once

#include "grader/base/descriptor.h"

#include <optional>

#include <termios.h>

namespace grader::watch {

// Sets up the terminal on standard input so that keys arrive one by one and are not shown, while
// this object lives. However the program ends, short of SIGKILL, the terminal is left as it was
// found: signals that ask it to end come out of next_signal(), and those of a crash put the
// terminal back first. Only one may live at a time.
class RawTerminal {
 public:
  // Throws pt::Error if standard input is not a terminal.
  RawTerminal();
  ~RawTerminal();
  RawTerminal(const RawTerminal&) = delete;
  RawTerminal& operator=(const RawTerminal&) = delete;

  // Readable when there is a signal to take.
  int signal_descriptor() const { return signals_.read_end.number(); }

  // SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGTSTP or SIGCHLD, if one has come since the last call.
  std::optional<int> next_signal();

  // Stops the program, as Ctrl-Z should, with the terminal as it was found until it goes on.
  void stop_program();

 private:
  void enter() const;
  void leave() const;

  base::Pipe signals_;
  termios found_;
};

}  // namespace grader::watch
