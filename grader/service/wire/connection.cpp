#include "grader/service/wire/connection.h"

#include <algorithm>
#include <cerrno>
#include <utility>

#include <unistd.h>

namespace grader::wire {

namespace {

std::uint64_t current_sequence = 0;

std::optional<RadiancesAhead> known;
std::size_t taken = 0;  // of the known ones
Writer asked;           // the questions that the judge has not got yet

// So many bytes of questions are sent at once.
constexpr std::size_t kManyAsked = std::size_t{1} << 18;

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

void send_asked() {
  if (asked.bytes().empty()) return;
  send(Kind::asked, asked.bytes());
  asked.clear();
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
  if (kind != Kind::asked) send_asked();
  const Header header{kMagic, kind, current_sequence, payload.size()};
  std::string bytes(reinterpret_cast<const char*>(&header), sizeof header);
  bytes.append(payload);
  for (std::size_t sent = 0; sent < bytes.size();) {
    const ssize_t count = write(kToJudge, bytes.data() + sent, bytes.size() - sent);
    if (count > 0) sent += static_cast<std::size_t>(count);
    if (count < 0 && errno != EINTR) leave();
  }
}

void begin_with(std::optional<RadiancesAhead> ahead) {
  known = std::move(ahead);
  taken = 0;
}

void begin_again() { taken = 0; }

bool wants_to_be_told() { return known && known->are_told; }

void tell(std::string_view question) {
  put(asked, std::string(question));
  if (asked.bytes().size() > kManyAsked) send_asked();
}

std::optional<pt::Rgb> next_ahead(pt::Sampler& sampler) {
  if (!known) return std::nullopt;
  for (int i = 0; i < known->numbers; ++i) sampler.next_1d();
  return known->values[std::min(taken++, known->values.size() - 1)];
}

}  // namespace grader::wire
