#pragma once

#include <functional>
#include <string>

namespace site {

// HTML in which every heading of the levels 1 to 3 has an id, by the rule of the platforms that show Markdown: its words in small
// letters, joined by hyphens. So links to a heading work as they do there.
std::string with_ids(const std::string& html);

// The address that stands for a link's; nothing if the site has no such page.
using Address = std::function<std::string(const std::string&)>;

// HTML in which every link and picture has its new address. A link without one becomes text.
std::string with_addresses(const std::string& html, const Address& address);

}  // namespace site
