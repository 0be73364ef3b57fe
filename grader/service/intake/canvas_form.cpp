#include "grader/service/intake/canvas_form.h"

#include <algorithm>
#include <cctype>
#include <string_view>

namespace grader::intake {

namespace {

constexpr std::size_t kMaxDigits = 20;
constexpr double kApart = 20;  // IDs of one school have numbers of one size, to this factor
constexpr std::size_t kMaxDigitsOfFile = 12;  // Canvas: users of another school have more

// The digits at a place of a text; empty if there are none, or too many for a number.
std::string digits_at(std::string_view text, std::size_t at) {
  const std::string_view rest = text.substr(std::min(at, text.size()));
  const std::size_t end = std::min(rest.find_first_not_of("0123456789"), rest.size());
  return end > kMaxDigits ? "" : std::string(rest.substr(0, end));
}

// Numbers of any length as texts that compare like the numbers.
std::string padded(const std::string& digits) {
  return std::string(kMaxDigits - std::min(kMaxDigits, digits.size()), '0') + digits;
}

// Canvas (lib/content_zipper.rb): NAME_[LATE_]ID_NUMBER_FILE, where the first `_` after the name is
// at `at`; or NAME_[LATE_]ID_text.html for text that was typed.
Found canvas_at(const std::string& name, std::size_t at) {
  Label label;
  label.platform = Platform::canvas;
  label.name = name.substr(0, at++);
  label.late = name.compare(at, 5, "LATE_") == 0;
  if (label.late) at += 5;
  label.id = digits_at(name, at);
  at += label.id.size() + 1;
  if (label.name.empty() || label.id.empty() || at >= name.size() || name[at - 1] != '_') return {};
  label.key = label.name + '\n' + label.id;
  label.file = name.substr(at);
  label.text = label.file == "text.html" || label.file == "link.html";
  if (label.text) return label;
  const std::string number = digits_at(name, at);
  at += number.size() + 1;
  if (number.empty() || number.size() > kMaxDigitsOfFile || at >= name.size() ||
      name[at - 1] != '_')
    return {};
  label.order = padded(number);
  label.file = name.substr(at);
  return label;
}

// With anonymous grading: [LATE_]anon_aB3xz_[LATE_]NUMBER_FILE.
Found anonymous(const std::string& name) {
  constexpr std::size_t kSize = 10;
  const std::size_t begin = name.starts_with("LATE_") ? 5 : 0;
  const std::string id = name.substr(begin, kSize);
  const bool is_id =
      id.size() == kSize && id.starts_with("anon_") &&
      std::all_of(id.begin() + 5, id.end(), [](unsigned char c) { return std::isalnum(c) != 0; });
  // Without a name and an ID, the rest is as usual.
  const std::string rest = is_id ? name.substr(begin + kSize) : "";
  const bool late = rest.starts_with("_LATE_");
  Found label =
      rest.starts_with("_") ? canvas_at("anon_0" + rest.substr(late ? 5 : 0), 4) : Found();
  if (!label) return label;
  label->name = label->id = label->key = id;
  label->late = late || begin > 0;
  return label;
}

}  // namespace

double number(const std::string& digits) { return std::stod(digits); }

Found canvas_among(const std::string& name, const Numbers& certain) {
  const auto is_of_a_file = [&](const Label& label) {
    const double value = number(label.order);
    return value >= certain.least / 2 && value <= certain.largest * 2;
  };
  if (Found label = anonymous(name)) return label;
  for (std::size_t at = name.find('_'); at != name.npos; at = name.find('_', at + 1)) {
    Found first = canvas_at(name, at);
    if (!first) continue;
    const Found second = first->late ? Found() : canvas_at(name, at + 1 + first->id.size());
    if (!second) return first;
    const bool may_be_first = first->text || is_of_a_file(*first);
    const bool is_id = number(second->id) <= kApart * certain.largest_id;
    const bool may_be_second = second->text || (is_of_a_file(*second) && is_id);
    const bool is_second = may_be_first == may_be_second
                               ? !may_be_first && number(second->order) > number(second->id)
                               : may_be_second;
    Found label = is_second ? second : first;
    label->certain = false;
    if (may_be_first && may_be_second && !second->text) {
      label->rival_key = second->key;
      label->rival_name = second->name;
      label->rival_id = second->id;
    }
    return label;
  }
  return {};
}

Found canvas(const std::string& name) { return canvas_among(name, {}); }

}  // namespace grader::intake
