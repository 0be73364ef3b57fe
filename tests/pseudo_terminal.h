#pragma once

#include <string>
#include <vector>

#include <sys/types.h>
#include <termios.h>

// A program that runs in a terminal of its own, and the person in front of it.
class PseudoTerminal {
 public:
  explicit PseudoTerminal(std::vector<std::string> command);
  ~PseudoTerminal();
  PseudoTerminal(const PseudoTerminal&) = delete;
  PseudoTerminal& operator=(const PseudoTerminal&) = delete;

  void type(const std::string& keys);
  void send_signal(int signal) const;

  // Reads until the program has printed `text` since the last call that saw something, and returns
  // all it printed until then. Fails the test after 30 s.
  std::string expect(const std::string& text);

  // The status as waitpid gives it, also of a program that was stopped.
  int wait();

  termios mode() const;
  const termios& mode_before() const { return before_; }

 private:
  int screen_ = -1;  // our end
  int device_ = -1;  // the program's end: kept open, so that its mode can be read to the end
  pid_t pid_ = -1;
  bool ended_ = false;
  termios before_;
  std::string unread_;
};

bool operator==(const termios& a, const termios& b);
