#include "grader/report/address.h"

#include <cctype>

#include <fmt/format.h>

namespace grader::report {

std::string address_of(const std::string& file) {
  std::string address;
  for (const char c : file) {
    const auto byte = static_cast<unsigned char>(c);
    const bool plain = std::isalnum(byte) != 0 || c == '-' || c == '_' || c == '.';
    address += plain && byte < 0x80 ? std::string(1, c) : fmt::format("%{:02X}", byte);
  }
  return address;
}

}  // namespace grader::report
