#include "pt/scene/collada/document.h"

#include "pt/error.h"
#include "pt/scene/collada/text.h"

#include <charconv>
#include <cstring>

#include <tinyxml2.h>

namespace pt {

namespace {

bool is_course_profile(const XMLElement& technique) {
  const std::string_view profile = attribute(&technique, "profile");
  return profile == "CGL" || profile == "CMU462";
}

// A URL writes a space as "%20": exporters write spaces and letters outside ASCII like this.
std::string decoded(std::string_view url) {
  std::string text;
  for (std::size_t i = 0; i < url.size(); ++i) {
    unsigned char byte = 0;
    const char* const code = url.data() + i + 1;
    const bool is_code = url[i] == '%' && i + 2 < url.size() &&
                         std::from_chars(code, code + 2, byte, 16).ptr == code + 2;
    text += is_code ? static_cast<char>(byte) : url[i];
    if (is_code) i += 2;
  }
  return text;
}

// Adds an element to the elements with its id. Returns whether it is the first.
bool is_new(Document::Identified& known, const XMLElement& element) {
  if (known.first == nullptr) {
    known.first = &element;
    return true;
  }
  if (known.second == nullptr) known.second = &element;
  return false;
}

const XMLElement* mesh_around(const XMLElement& element) {
  for (const tinyxml2::XMLNode* above = element.Parent(); above != nullptr;
       above = above->Parent()) {
    const XMLElement* found = above->ToElement();
    if (found != nullptr && std::strcmp(found->Name(), "mesh") == 0) return found;
  }
  return nullptr;
}

// The up axis and the unit that an <asset> states, with their defaults.
std::pair<std::string, double> stated_axis_and_unit(const XMLElement* asset) {
  const std::string_view axis = trimmed_text(find_below(asset, {"up_axis"}));
  const XMLElement* unit = find_below(asset, {"unit"});
  return {std::string(axis.empty() ? "Y_UP" : axis), unit ? unit->DoubleAttribute("meter", 1) : 1};
}

const char* what_is_wrong(tinyxml2::XMLError error) {
  switch (error) {
    case tinyxml2::XML_ERROR_MISMATCHED_ELEMENT:
      return "an element is not closed, or closed by another name";
    case tinyxml2::XML_ERROR_PARSING_ELEMENT:
      return "a tag is not complete";
    case tinyxml2::XML_ERROR_PARSING_ATTRIBUTE:
      return "an attribute is not written as name=\"value\", or stands twice in its tag";
    case tinyxml2::XML_ERROR_PARSING_COMMENT:
      return "a comment is not closed by -->";
    case tinyxml2::XML_ERROR_PARSING_CDATA:
      return "a CDATA section is not closed by ]]>";
    case tinyxml2::XML_ERROR_PARSING_DECLARATION:
      return "a <?...?> stands between elements, or is not closed";
    case tinyxml2::XML_ERROR_EMPTY_DOCUMENT:
      return "there are no elements";
    default:
      return "text stands where a tag must be, or a tag is not closed";
  }
}

std::string_view trimmed(const char* value) {
  constexpr const char* kSpace = " \t\r\n";
  const std::string_view text = value ? value : "";
  const std::size_t first = text.find_first_not_of(kSpace);
  return first == text.npos ? "" : text.substr(first, text.find_last_not_of(kSpace) + 1 - first);
}

}  // namespace

Document::Document(const std::filesystem::path& file, std::vector<std::string>& notes)
    : file_(file.string()), xml_(std::make_unique<tinyxml2::XMLDocument>()), notes_(notes) {
  parse(read_text(file));
  XMLElement* root = xml_->RootElement();
  const std::string_view name = root ? root->Name() : "";
  const std::size_t prefix = name.find(':') == name.npos ? 0 : name.find(':') + 1;
  if (name.substr(prefix) != "COLLADA") {
    throw Error(file_ + ":1: the outermost element is not <COLLADA>; name a .dae file");
  }
  root_ = root;
  prefix_ = name.substr(0, prefix);
  index(*root);
  look_for_decimals(*root);
}

Document::~Document() = default;

void Document::parse(const std::string& text) {
  const tinyxml2::XMLError error = xml_->Parse(text.data(), text.size());
  if (error == tinyxml2::XML_SUCCESS) return;
  const std::string where = file_ + ":" + std::to_string(xml_->ErrorLineNum()) + ": ";
  if (error == tinyxml2::XML_ELEMENT_DEPTH_EXCEEDED) {
    throw Error(where + "elements are nested more than " +
                std::to_string(TINYXML2_MAX_ELEMENT_DEPTH) + " deep; flatten the scene");
  }
  throw Error(where + "the XML cannot be read: " + what_is_wrong(error) +
              "; correct it there, or copy the file again if it was cut off");
}

void Document::index(XMLElement& element) {
  if (!prefix_.empty() && std::string_view(element.Name()).starts_with(prefix_)) {
    element.SetName(std::string(element.Name() + prefix_.size()).c_str());
  }
  const std::string_view name = element.Name();
  if (name == "asset") assets_.push_back(&element);
  if (name == "technique" && is_course_profile(element)) has_course_profile_ = true;
  if (const std::string_view id = attribute(&element, "id"); !id.empty()) {
    const std::string key = std::string(name).append("#").append(id);
    if (!is_new(by_id_[{nullptr, key}], element) && duplicates_++ == 0) first_duplicate_ = &element;
    if (const XMLElement* mesh = mesh_around(element)) is_new(by_id_[{mesh, key}], element);
  }
  for (XMLElement* child = element.FirstChildElement(); child != nullptr;
       child = child->NextSiblingElement()) {
    index(*child);
  }
}

// An <asset> does not count: it has dates, and versions of programs.
void Document::look_for_decimals(const tinyxml2::XMLNode& node) {
  const std::string_view text = node.Value();
  if (has_points_ || text == "asset") return;
  for (auto part = node.FirstChild(); part != nullptr; part = part->NextSibling()) {
    look_for_decimals(*part);
  }
  if (node.ToText() == nullptr || has_points_) return;
  constexpr const char* kDigits = "0123456789";
  const bool is_numbers = text.find_first_not_of("0123456789+-.,eE \t\r\n") == text.npos;
  const std::size_t comma = is_numbers ? text.find(',') : text.npos;
  has_points_ = is_numbers && text.find('.') != text.npos;
  has_commas_ = has_commas_ || text.find_first_of(kDigits, comma) == comma + 1;
}

void Document::fail(const XMLElement& at, const std::string& what) const {
  throw Error(file_ + ":" + std::to_string(at.GetLineNum()) + ": " + what);
}

const XMLElement& Document::child(const XMLElement& parent, const char* name) const {
  const XMLElement* found = parent.FirstChildElement(name);
  if (found == nullptr) fail(parent, tag(parent) + " has no <" + name + ">; add one");
  return *found;
}

// "#part" of "#part", "scene.dae#part" or "../models/scene.dae#part", where this file is scene.dae;
// empty if the url names another file or no part.
std::string_view Document::own_part(std::string_view url) const {
  const std::size_t hash = url.find('#');
  if (hash == url.npos) return {};
  const std::string named = decoded(url.substr(0, hash));
  const std::size_t slash = named.find_last_of("/\\");
  const std::string file = named.substr(slash == named.npos ? 0 : slash + 1);
  const bool is_own = named.empty() || file == std::filesystem::path(file_).filename().string();
  return is_own ? url.substr(hash) : std::string_view{};
}

Document::Identified Document::find(const XMLElement* from, const char* name,
                                    const char* kind) const {
  const std::string part(own_part(attribute(from, name)));
  if (part.empty()) return {};
  for (const std::string& id : {part, decoded(part)}) {
    for (const XMLElement* around : {mesh_around(*from), static_cast<const XMLElement*>(nullptr)}) {
      const auto found = by_id_.find({around, kind + id});
      if (found != by_id_.end()) return found->second;
    }
  }
  return {};
}

Document::Identified Document::find_or_note(const XMLElement& from, const char* name,
                                            const char* kind,
                                            const std::string& what_happens) const {
  const Identified found = find(&from, name, kind);
  if (found.first == nullptr) {
    note(missing(attribute(&from, name), kind) + ": " + what_happens + ".");
  }
  return found;
}

// "there is no <light> with the id that '#sun' names", that it is in another file, or not named
std::string Document::missing(std::string_view url, const char* kind) const {
  if (url.empty()) return "no <" + std::string(kind) + "> is named";
  if (url.find('#') != url.npos && own_part(url).empty()) {
    return "the <" + std::string(kind) + "> " + quoted(url) +
           " is in another file, which is not read";
  }
  return std::string("there is no <") + kind + "> with the id that " + quoted(url) + " names";
}

std::string Document::ambiguity(std::string_view url, const Identified& found) {
  return quoted(url) + " may be the " + tag(*found.first) + " of " + line(*found.first) +
         " or that of " + line(*found.second);
}

const XMLElement& Document::resolve(const XMLElement& from, const char* name,
                                    const char* kind) const {
  const std::string_view url = attribute(&from, name);
  if (url.empty()) fail(from, tag(from) + " has no attribute " + name + "; add it");
  const Identified found = find(&from, name, kind);
  if (found.first == nullptr) {
    fail(from, missing(url, kind) + "; define it in this file or correct the " + name);
  }
  if (found.second != nullptr) fail(from, ambiguity(url, found) + "; give each an id of its own");
  return *found.first;
}

void Document::note_on_the_whole() const {
  if (first_duplicate_ != nullptr) {
    note(std::to_string(duplicates_) +
         " elements have the id of another (the first: " + tag(*first_duplicate_) + " " +
         quoted(first_duplicate_->Attribute("id")) + " in " + line(*first_duplicate_) +
         "): what refers to one means that of its own mesh; else a note says which is taken.");
  }
  if (has_decimal_commas()) {
    note("the file's numbers have decimal commas, which are read as points.");
  }
  for (const XMLElement* asset : assets_) {
    const bool states_some =
        asset->FirstChildElement("up_axis") || asset->FirstChildElement("unit");
    if (!states_some ||
        stated_axis_and_unit(asset) == stated_axis_and_unit(root_->FirstChildElement("asset"))) {
      continue;
    }
    note("the <asset> of a " + tag(*asset->Parent()->ToElement()) +
         " states its own up_axis or unit (" + line(*asset) + "), which is ignored.");
  }
}

std::string_view attribute(const XMLElement* element, const char* name) {
  return trimmed(element ? element->Attribute(name) : nullptr);
}

std::vector<const XMLElement*> children(const XMLElement& parent, const char* name) {
  std::vector<const XMLElement*> found;
  for (const XMLElement* child = parent.FirstChildElement(name); child != nullptr;
       child = child->NextSiblingElement(name)) {
    found.push_back(child);
  }
  return found;
}

const XMLElement* find_below(const XMLElement* from, std::initializer_list<const char*> path) {
  for (const char* name : path) from = from ? from->FirstChildElement(name) : nullptr;
  return from;
}

const XMLElement* course_child(const XMLElement& element, const char* name) {
  for (const XMLElement* extra : children(element, "extra")) {
    for (const XMLElement* technique : children(*extra, "technique")) {
      const XMLElement* found = technique->FirstChildElement(name);
      if (found != nullptr && is_course_profile(*technique)) return found;
    }
  }
  return nullptr;
}

std::string label(const XMLElement& element) {
  const std::string_view name = attribute(&element, "name");
  return quoted(name.empty() ? attribute(&element, "id") : name);
}

std::string tag(const XMLElement& element) { return std::string("<") + element.Name() + ">"; }

std::string line(const XMLElement& element) {
  return "line " + std::to_string(element.GetLineNum());
}

std::string_view trimmed_text(const XMLElement* element) {
  return trimmed(element ? element->GetText() : nullptr);
}

std::string quoted(std::string_view text) {
  constexpr std::size_t kLongest = 40;
  std::string out = "'";
  for (const char c : text.substr(0, kLongest)) {
    out += c >= ' ' && c <= '~' && c != '\'' ? c : '?';
  }
  return out + (text.size() > kLongest ? "...'" : "'");
}

}  // namespace pt
