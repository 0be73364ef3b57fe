#include "pt/scene/collada/attributes.h"

#include <algorithm>

namespace pt {

namespace {

// Returns the place after the next `end`, or the end of the text.
std::size_t behind(std::string_view xml, std::size_t at, std::string_view end) {
  const std::size_t found = xml.find(end, at);
  return found == xml.npos ? xml.size() : found + end.size();
}

// Returns the place after a comment, CDATA or a directive that begins here; 0 if none begins here.
std::size_t behind_markup(std::string_view xml, std::size_t at) {
  const std::string_view rest = xml.substr(at);
  if (rest.starts_with("<!--")) return behind(xml, at + 4, "-->");
  if (rest.starts_with("<![CDATA[")) return behind(xml, at, "]]>");
  if (rest.starts_with("<?")) return behind(xml, at, "?>");
  return rest.starts_with("<!") ? behind(xml, at, ">") : 0;
}

}  // namespace

std::optional<std::size_t> line_of_too_many_attributes(std::string_view xml, std::size_t most) {
  for (std::size_t tag = xml.find('<'); tag < xml.size();) {
    std::size_t at = behind_markup(xml, tag);
    std::size_t count = 0;
    for (at = at == 0 ? tag + 1 : at - 1; at < xml.size() && xml[at] != '>'; ++at) {
      if (xml[at] == '"' || xml[at] == '\'') at = behind(xml, at + 1, xml.substr(at, 1)) - 1;
      if (xml[at] == '=' && ++count > most) {
        return 1 + static_cast<std::size_t>(std::count(
                       xml.begin(), xml.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
      }
    }
    tag = xml.find('<', std::min(at, xml.size()));
  }
  return std::nullopt;
}

}  // namespace pt
