#include "pt/scene/collada/utf16.h"

#include <cstddef>
#include <cstdint>

namespace pt {

namespace {

enum class Order { little, big };

std::optional<Order> byte_order(std::string_view bytes) {
  const std::string_view first = bytes.substr(0, 2);
  if (first == "\xff\xfe" || first == std::string_view("<\0", 2)) return Order::little;
  if (first == "\xfe\xff" || first == std::string_view("\0<", 2)) return Order::big;
  return std::nullopt;
}

std::uint32_t unit(std::string_view bytes, std::size_t at, Order order) {
  const auto first = static_cast<unsigned char>(bytes[at]);
  const auto second = static_cast<unsigned char>(bytes[at + 1]);
  return order == Order::big ? first << 8 | second : second << 8 | first;
}

void append_utf8(std::string& text, std::uint32_t code) {
  const auto add = [&](std::uint32_t byte) { text += static_cast<char>(byte); };
  if (code < 0x80) return add(code);
  if (code < 0x800) {
    add(0xc0 | code >> 6);
  } else {
    if (code < 0x10000) {
      add(0xe0 | code >> 12);
    } else {
      add(0xf0 | code >> 18);
      add(0x80 | (code >> 12 & 0x3f));
    }
    add(0x80 | (code >> 6 & 0x3f));
  }
  add(0x80 | (code & 0x3f));
}

}  // namespace

std::optional<std::string> utf8_from_utf16(std::string_view bytes) {
  const std::optional<Order> order = byte_order(bytes);
  if (!order) return std::nullopt;
  std::string text;
  text.reserve(bytes.size() / 2);
  for (std::size_t at = 0; at + 1 < bytes.size(); at += 2) {
    std::uint32_t code = unit(bytes, at, *order);
    if (code == 0xfeff && at == 0) continue;
    if (code >= 0xd800 && code < 0xe000) {  // half of a pair of units, the higher half first
      const std::uint32_t low = at + 3 < bytes.size() ? unit(bytes, at + 2, *order) : 0;
      const bool is_pair = code < 0xdc00 && low >= 0xdc00 && low < 0xe000;
      code = is_pair ? 0x10000 + ((code - 0xd800) << 10) + (low - 0xdc00) : 0xfffd;
      if (is_pair) at += 2;
    }
    append_utf8(text, code);
  }
  return text;
}

}  // namespace pt
