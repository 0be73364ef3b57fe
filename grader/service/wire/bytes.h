#pragma once

#include <cstring>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>

// Both ends: raw bytes of messages between the judge and a worker. Both are programs of one build
// on one machine, so numbers are sent as they are in memory.

namespace grader::wire {

// Bytes that no honest sender writes. Everything read so far is worthless.
class BadMessage : public std::runtime_error {
 public:
  explicit BadMessage(const std::string& what) : std::runtime_error(what) {}
};

class Writer {
 public:
  void raw(const void* from, std::size_t size) {
    bytes_.append(static_cast<const char*>(from), size);
  }

  template <class Number>
  void number(Number value) {
    static_assert(std::is_arithmetic_v<Number>);
    raw(&value, sizeof value);
  }

  std::string_view bytes() const { return bytes_; }
  void clear() { bytes_.clear(); }

 private:
  std::string bytes_;
};

// Reads from the front. Throws BadMessage instead of reading beyond the end.
class Reader {
 public:
  explicit Reader(std::string_view bytes) : bytes_(bytes) {}

  std::string_view raw(std::size_t size) {
    if (size > bytes_.size()) throw BadMessage("the message is too short");
    const std::string_view front = bytes_.substr(0, size);
    bytes_.remove_prefix(size);
    return front;
  }

  template <class Number>
  Number number() {
    static_assert(std::is_arithmetic_v<Number> && !std::is_same_v<Number, bool>);
    Number value;
    std::memcpy(&value, raw(sizeof value).data(), sizeof value);
    return value;
  }

  std::size_t left() const { return bytes_.size(); }

  void expect_end() const {
    if (!bytes_.empty()) throw BadMessage("the message is too long");
  }

 private:
  std::string_view bytes_;
};

}  // namespace grader::wire
