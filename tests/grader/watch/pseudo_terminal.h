#pragma once

#include <string>
#include <vector>

#include <sys/types.h>
#include <termios.h>

// A program that runs in its own terminal, and the person who uses it.
class PseudoTerminal {
 public:
  explicit PseudoTerminal(std::vector<std::string> command);
  ~PseudoTerminal();
  PseudoTerminal(const PseudoTerminal&) = delete;
  PseudoTerminal& operator=(const PseudoTerminal&) = delete;

  void type(const std::string& keys);
  void send_signal(int signal) const;

  // Reads until the program has printed `text` after the last successful call, and returns
  // everything printed so far. Fails the test after 30 s.
  std::string expect(const std::string& text);

  // Returns the status from waitpid, also for a stopped program.
  int wait();

  termios mode() const;
  const termios& mode_before() const { return before_; }

 private:
  int screen_ = -1;  // our end
  int device_ = -1;  // the program's end, which stays open so that its mode can be read to the end
  pid_t pid_ = -1;
  bool ended_ = false;
  termios before_;
  std::string unread_;
};

bool operator==(const termios& a, const termios& b);
