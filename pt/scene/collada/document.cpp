#include "pt/scene/collada/document.h"

#include "pt/error.h"
#include "pt/scene/collada/attributes.h"
#include "pt/scene/collada/utf16.h"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <optional>
#include <system_error>

#include <tinyxml2.h>

namespace pt {

namespace {

// A mesh of a million triangles needs about 80 MB. Markup takes far more memory than its length in
// the file, so it has a separate limit.
constexpr std::uintmax_t kMaxBytes = std::uintmax_t{512} << 20;
constexpr std::ptrdiff_t kMaxMarkup = 2'000'000;
constexpr std::size_t kMaxAttributes = 250;  // of one tag; COLLADA knows some ten
constexpr std::size_t kHeadBytes = 64 * 1024;

bool is_course_profile(const XMLElement& technique) {
  const char* profile = technique.Attribute("profile");
  return profile != nullptr &&
         (std::strcmp(profile, "CGL") == 0 || std::strcmp(profile, "CMU462") == 0);
}

// The tag may have the prefix of a namespace.
bool has_collada_tag(std::string_view text) {
  return text.find("<COLLADA") != text.npos || text.find(":COLLADA") != text.npos;
}

// Checks the file before it reads all of it. A file that is not COLLADA is recognised by its
// beginning, so that a large file of something else costs nothing.
std::string read_file(const std::filesystem::path& file) {
  const std::string name = file.string();
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(file, error);
  if (!std::filesystem::exists(status)) throw Error(name + ": no such file; check the path");
  if (std::filesystem::is_directory(status)) {
    throw Error(name + ": is a directory; name a .dae file in it");
  }
  if (!std::filesystem::is_regular_file(status)) {
    throw Error(name + ": is not a regular file; name a .dae file");
  }
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  if (error) throw Error(name + ": cannot be read (" + error.message() + "); check the path");
  if (size == 0) throw Error(name + ": is empty; export the scene again");
  if (size > kMaxBytes) throw Error(name + ": is larger than 512 MiB; split the scene");

  std::ifstream in(file, std::ios::binary);
  if (!in) throw Error(name + ": cannot be opened; check its permissions");
  std::string text(std::min<std::size_t>(size, kHeadBytes), '\0');
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (!has_collada_tag(utf8_from_utf16(text).value_or(text))) {
    throw Error(name +
                ":1: is not a COLLADA file (no <COLLADA> near its beginning); name a .dae file");
  }
  const std::size_t head = text.size();
  text.resize(size);
  in.read(text.data() + head, static_cast<std::streamsize>(size - head));
  if (size > head && !in) throw Error(name + ": cannot be read to its end; copy it again");
  if (std::optional<std::string> converted = utf8_from_utf16(text)) return std::move(*converted);
  return text;
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

// How the numbers of a list are written. Other text, and a single number, have no style.
struct NumberStyle {
  bool points = false;
  bool commas = false;  // each within a number, and at most one per number: 0,5 1,25
};

NumberStyle number_style(std::string_view text) {
  NumberStyle style;
  bool is_list = false;
  std::size_t commas = 0;  // in this word
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (!std::strchr("0123456789+-eE., \t\r\n", c)) return {};
    const bool is_space = c <= ' ';
    is_list = is_list || (is_space && style.points + commas > 0);
    if (is_space) commas = 0;
    if (c == '.') style.points = true;
    if (c != ',') continue;
    if (++commas > 1 || i + 1 == text.size() || text[i + 1] < '0' || text[i + 1] > '9') return {};
    style.commas = true;
  }
  return is_list ? style : NumberStyle{};
}

// Adds an element to the elements with its id. Returns whether it is the first.
bool is_new(ColladaDocument::Identified& known, const XMLElement& element) {
  if (known.first == nullptr) {
    known.first = &element;
    return true;
  }
  if (known.second == nullptr) known.second = &element;
  return false;
}

// The mesh that the element is a part of, or null.
const XMLElement* mesh_around(const XMLElement& element) {
  for (const tinyxml2::XMLNode* above = element.Parent(); above != nullptr;
       above = above->Parent()) {
    const XMLElement* found = above->ToElement();
    if (found != nullptr && std::strcmp(found->Name(), "mesh") == 0) return found;
  }
  return nullptr;
}

// The up axis, or the length of the unit, of an <asset> (null: none); both have a default.
std::string setting_of(const XMLElement* asset, const char* name) {
  const XMLElement* found = asset ? asset->FirstChildElement(name) : nullptr;
  if (std::strcmp(name, "up_axis") == 0) {
    return std::string(found ? trimmed_text(*found) : "Y_UP");
  }
  return std::to_string(found ? found->DoubleAttribute("meter", 1) : 1);
}

}  // namespace

ColladaDocument::ColladaDocument(const std::filesystem::path& file)
    : file_(file.string()), xml_(std::make_unique<tinyxml2::XMLDocument>()) {
  parse(read_file(file));
  XMLElement* root = xml_->RootElement();
  const std::string_view name = root ? root->Name() : "";
  const std::size_t prefix = name.find(':') == name.npos ? 0 : name.find(':') + 1;
  if (name.substr(prefix) != "COLLADA") {
    throw Error(file_ + ":1: the outermost element is not <COLLADA>; name a .dae file");
  }
  root_ = root;
  prefix_ = name.substr(0, prefix);
  index(*root);
}

ColladaDocument::~ColladaDocument() = default;

void ColladaDocument::parse(const std::string& text) {
  if (text.find('\0') != std::string::npos) {
    throw Error(file_ + ": holds a zero byte, so it is not text; export the scene again");
  }
  if (std::count_if(text.begin(), text.end(), [](char c) { return c == '<' || c == '='; }) >
      kMaxMarkup) {
    throw Error(file_ + ": has more than two million tags and attributes; split the scene");
  }
  if (const auto line = line_of_too_many_attributes(text, kMaxAttributes)) {
    throw Error(file_ + ":" + std::to_string(*line) + ": a tag has more than " +
                std::to_string(kMaxAttributes) + " attributes; keep those that COLLADA knows");
  }
  const tinyxml2::XMLError error = xml_->Parse(text.data(), text.size());
  if (error == tinyxml2::XML_SUCCESS) return;
  const std::string where = file_ + ":" + std::to_string(xml_->ErrorLineNum()) + ": ";
  if (error == tinyxml2::XML_ELEMENT_DEPTH_EXCEEDED) {
    throw Error(where + "elements are nested more than " +
                std::to_string(TINYXML2_MAX_ELEMENT_DEPTH) + " deep; flatten the scene");
  }
  throw Error(where + "the XML is malformed (" + tinyxml2::XMLDocument::ErrorIDToName(error) +
              "); correct it there, or copy the file again if it was cut off");
}

void ColladaDocument::index(XMLElement& element) {
  if (!prefix_.empty() && std::string_view(element.Name()).starts_with(prefix_)) {
    element.SetName(std::string(element.Name() + prefix_.size()).c_str());
  }
  const std::string_view name = element.Name();
  if (name == "asset") assets_.push_back(&element);
  if (name == "technique" && is_course_profile(element)) has_course_profile_ = true;
  look_at_numbers(element);
  if (const char* id = element.Attribute("id")) {
    const std::string key = std::string(name) + "#" + id;
    if (!is_new(by_id_[key], element) && duplicates_++ == 0) first_duplicate_ = &element;
    if (const XMLElement* mesh = mesh_around(element)) is_new(in_mesh_[{mesh, key}], element);
  }
  for (XMLElement* child = element.FirstChildElement(); child != nullptr;
       child = child->NextSiblingElement()) {
    index(*child);
  }
}

void ColladaDocument::look_at_numbers(const XMLElement& element) {
  const tinyxml2::XMLNode* first = element.FirstChild();
  const tinyxml2::XMLText* text = first ? first->ToText() : nullptr;
  const NumberStyle style = text ? number_style(text->Value()) : NumberStyle{};
  has_points_ = has_points_ || style.points;
  has_commas_ = has_commas_ || style.commas;
}

void ColladaDocument::fail(const XMLElement& at, const std::string& what) const {
  throw Error(file_ + ":" + std::to_string(at.GetLineNum()) + ": " + what);
}

const XMLElement& ColladaDocument::child(const XMLElement& parent, const char* name) const {
  const XMLElement* found = parent.FirstChildElement(name);
  if (found == nullptr) {
    fail(parent, std::string("<") + parent.Name() + "> has no <" + name + ">; add one");
  }
  return *found;
}

std::string_view ColladaDocument::attribute(const XMLElement& element, const char* name) const {
  const char* value = element.Attribute(name);
  if (value == nullptr) {
    fail(element, std::string("<") + element.Name() + "> has no attribute " + name + "; add it");
  }
  return value;
}

// "#part" of "#part", "scene.dae#part" or "../models/scene.dae#part", where this file is scene.dae;
// empty if the url names another file or no part.
std::string_view ColladaDocument::own_part(std::string_view url) const {
  const std::size_t hash = url.find('#');
  if (hash == url.npos) return {};
  const std::string named = decoded(url.substr(0, hash));
  const std::size_t slash = named.find_last_of("/\\");
  const std::string file = named.substr(slash == named.npos ? 0 : slash + 1);
  const bool is_own = named.empty() || file == std::filesystem::path(file_).filename().string();
  return is_own ? url.substr(hash) : std::string_view{};
}

ColladaDocument::Identified ColladaDocument::find(const XMLElement& from, std::string_view url,
                                                  const char* kind) const {
  const std::string_view part = own_part(url);
  if (part.empty()) return {};
  const std::string key = std::string(kind) + std::string(part);
  if (const XMLElement* mesh = mesh_around(from)) {
    const auto own = in_mesh_.find({mesh, key});
    if (own != in_mesh_.end()) return own->second;
  }
  const auto found = by_id_.find(key);
  if (found != by_id_.end()) return found->second;
  const std::string plain = decoded(part);
  return plain == part ? Identified{} : find(from, plain, kind);
}

std::string ColladaDocument::missing(std::string_view url, const char* kind) const {
  if (url.find('#') != url.npos && own_part(url).empty()) {
    return "the <" + std::string(kind) + "> " + quoted(url) +
           " is in another file, which is not read";
  }
  return std::string("there is no <") + kind + "> with the id that " + quoted(url) + " names";
}

std::string ColladaDocument::ambiguity(std::string_view url, const Identified& found) {
  return quoted(url) + " may be the <" + found.first->Name() + "> of line " +
         std::to_string(found.first->GetLineNum()) + " or that of line " +
         std::to_string(found.second->GetLineNum());
}

const XMLElement& ColladaDocument::resolve(const XMLElement& from, const char* name,
                                           const char* kind) const {
  const std::string_view url = attribute(from, name);
  const Identified found = find(from, url, kind);
  if (found.first == nullptr) {
    fail(from, missing(url, kind) + "; define it in this file or correct the " + name);
  }
  if (found.second != nullptr) fail(from, ambiguity(url, found) + "; give each an id of its own");
  return *found.first;
}

std::vector<std::string> ColladaDocument::notes() const {
  std::vector<std::string> notes;
  if (first_duplicate_ != nullptr) {
    notes.push_back(
        std::to_string(duplicates_) + " elements have the id of another (the first: <" +
        first_duplicate_->Name() + "> " + quoted(first_duplicate_->Attribute("id")) + " in line " +
        std::to_string(first_duplicate_->GetLineNum()) +
        "): what refers to one means that of its own mesh; else a note says which is taken.");
  }
  if (has_decimal_commas()) {
    notes.push_back("the file's numbers have decimal commas, which are read as points.");
  }
  for (const XMLElement* asset : assets_) {
    if (asset->Parent() == root_) continue;
    for (const char* setting : {"unit", "up_axis"}) {
      if (asset->FirstChildElement(setting) == nullptr) continue;
      if (setting_of(asset, setting) == setting_of(root_->FirstChildElement("asset"), setting)) {
        continue;
      }
      notes.push_back("the <asset> of a <" + std::string(asset->Parent()->Value()) +
                      "> states its own " + setting + " (line " +
                      std::to_string(asset->GetLineNum()) + "), which is ignored.");
    }
  }
  return notes;
}

const XMLElement* course_child(const XMLElement& element, const char* name) {
  for (const XMLElement* extra = element.FirstChildElement("extra"); extra != nullptr;
       extra = extra->NextSiblingElement("extra")) {
    for (const XMLElement* technique = extra->FirstChildElement("technique"); technique != nullptr;
         technique = technique->NextSiblingElement("technique")) {
      if (!is_course_profile(*technique)) continue;
      if (const XMLElement* found = technique->FirstChildElement(*name ? name : nullptr)) {
        return found;
      }
    }
  }
  return nullptr;
}

std::string label(const XMLElement& element) {
  const char* name = element.Attribute("name");
  if (name == nullptr || *name == '\0') name = element.Attribute("id");
  return quoted(name == nullptr ? "" : name);
}

std::string_view trimmed_text(const XMLElement& element) {
  constexpr const char* kSpace = " \t\r\n";
  const std::string_view text = element.GetText() ? element.GetText() : "";
  const std::size_t first = text.find_first_not_of(kSpace);
  if (first == text.npos) return {};
  return text.substr(first, text.find_last_not_of(kSpace) + 1 - first);
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
