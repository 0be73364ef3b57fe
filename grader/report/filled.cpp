#include "grader/report/filled.h"

#include "grader/report/page/sources.h"
#include "pt/error.h"

#include <cctype>

#include <fmt/format.h>

namespace grader::report {

std::string filled(std::string_view page, kainjow::mustache::data data) {
  kainjow::mustache::partial head{[] { return std::string(head_html); }};
  data.set("head", kainjow::mustache::data{head});
  kainjow::mustache::mustache filling{std::string(page)};
  std::string text = filling.render(data);
  if (!filling.is_valid()) throw pt::Error("the page cannot be made: " + filling.error_message());
  return text;
}

void set_text(kainjow::mustache::data& out, const std::string& key, const std::string& text) {
  out.set(key, text);
  out.set("has_" + key, !text.empty());
}

void set_texts(kainjow::mustache::data& out, const std::string& list, const std::string& key,
               const std::vector<std::string>& texts) {
  kainjow::mustache::data items{kainjow::mustache::data::type::list};
  for (const std::string& text : texts) items.push_back(kainjow::mustache::data{key, text});
  out.set(list, items);
  out.set("has_" + list, !texts.empty());
}

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
