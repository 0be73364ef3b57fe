#pragma once

#include <utility>

#include <unistd.h>

namespace grader::base {

// Owns an open file descriptor.
class Descriptor {
 public:
  Descriptor() = default;
  explicit Descriptor(int number) : number_(number) {}
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  ~Descriptor() { close(); }

  int number() const { return number_; }
  bool is_open() const { return number_ >= 0; }
  void close() {
    if (number_ >= 0) ::close(number_);
    number_ = -1;
  }

 private:
  int number_ = -1;
};

// A pipe that no child inherits by accident. Throws pt::Error if there are no descriptors left.
struct Pipe {
  Descriptor read_end, write_end;
};
Pipe make_pipe();

// From now on, reads and writes fail instead of waiting.
void set_nonblocking(const Descriptor& descriptor);

}  // namespace grader::base
