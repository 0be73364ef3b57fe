#include "grader/service/wire/connection.h"

#include <cerrno>

#include <unistd.h>

namespace grader::wire {

namespace {

std::uint64_t current_sequence = 0;

// Without the judge nothing is left to do.
[[noreturn]] void leave() { _exit(0); }

std::string read_bytes(std::size_t size) {
  std::string bytes(size, '\0');
  for (std::size_t have = 0; have < size;) {
    const ssize_t count = read(kFromJudge, bytes.data() + have, size - have);
    if (count > 0) have += static_cast<std::size_t>(count);
    if (count == 0 || (count < 0 && errno != EINTR)) leave();
  }
  return bytes;
}

}  // namespace

std::string receive(Kind kind) {
  Header header;
  std::memcpy(&header, read_bytes(sizeof header).data(), sizeof header);
  if (header.magic != kMagic || header.kind != kind) leave();
  current_sequence = header.sequence;
  return read_bytes(header.length);
}

void send(Kind kind, std::string_view payload) {
  const Header header{kMagic, kind, current_sequence, payload.size()};
  std::string bytes(reinterpret_cast<const char*>(&header), sizeof header);
  bytes.append(payload);
  for (std::size_t sent = 0; sent < bytes.size();) {
    const ssize_t count = write(kToJudge, bytes.data() + sent, bytes.size() - sent);
    if (count > 0) sent += static_cast<std::size_t>(count);
    if (count < 0 && errno != EINTR) leave();
  }
}

}  // namespace grader::wire
