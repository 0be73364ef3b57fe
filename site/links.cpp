#include "site/links.h"

#include <cctype>
#include <map>

namespace site {

namespace {

// The words of a heading, without tags and entities.
std::string id_of(const std::string& heading) {
  std::string id;
  char until = 0;
  for (const char c : heading) {
    if (until != 0) {
      if (c == until) until = 0;
    } else if (c == '<' || c == '&') {
      until = c == '<' ? '>' : ';';
    } else if (c == ' ') {
      id += '-';
    } else if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '_') {
      id += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
  }
  return id;
}

// A tag's attribute: where its value begins and ends.
struct Value {
  std::size_t begin = std::string::npos, end = std::string::npos;
};
Value value_of(const std::string& html, std::size_t tag, const std::string& name) {
  const std::size_t close = html.find('>', tag), at = html.find(name + "=\"", tag);
  if (at == html.npos || at > close) return {};
  const std::size_t begin = at + name.size() + 2;
  return {begin, html.find('"', begin)};
}

}  // namespace

std::string with_ids(const std::string& html) {
  std::string out;
  std::map<std::string, int> seen;
  std::size_t done = 0;
  for (std::size_t at = 0; (at = html.find("<h", at)) != html.npos; ++at) {
    const std::string open = html.substr(at, 4);
    if (open != "<h1>" && open != "<h2>" && open != "<h3>") continue;
    const std::size_t end = html.find("</h", at);
    std::string id = id_of(html.substr(at + 4, end - at - 4));
    const int before = seen[id]++;
    if (before > 0) id += "-" + std::to_string(before);
    out += html.substr(done, at + 3 - done) + " id=\"" + id + "\">";
    done = at + 4;
  }
  return out + html.substr(done);
}

std::string with_addresses(const std::string& html, const Address& address) {
  std::string out;
  std::size_t done = 0;
  for (std::size_t at = 0; (at = html.find('<', at)) != html.npos; ++at) {
    const bool is_link = html.compare(at, 3, "<a ") == 0;
    if (!is_link && html.compare(at, 5, "<img ") != 0) continue;
    const Value value = value_of(html, at, is_link ? "href" : "src");
    if (value.end == html.npos) continue;
    const std::string found = address(html.substr(value.begin, value.end - value.begin));
    if (is_link && found.empty()) {
      const std::size_t text = html.find('>', at) + 1, end = html.find("</a>", at);
      out += html.substr(done, at - done) + html.substr(text, end - text);
      done = end + 4;
    } else {
      out += html.substr(done, value.begin - done) + found;
      done = value.end;
    }
  }
  return out + html.substr(done);
}

}  // namespace site
