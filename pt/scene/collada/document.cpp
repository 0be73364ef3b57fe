#include "pt/scene/collada/document.h"

#include "pt/error.h"
#include "pt/scene/collada/attributes.h"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <fstream>
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
  if (text.find("<COLLADA") == std::string::npos) {
    throw Error(name +
                ":1: is not a COLLADA file (no <COLLADA> near its beginning); name a .dae file");
  }
  const std::size_t head = text.size();
  text.resize(size);
  in.read(text.data() + head, static_cast<std::streamsize>(size - head));
  if (size > head && !in) throw Error(name + ": cannot be read to its end; copy it again");
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

}  // namespace

ColladaDocument::ColladaDocument(const std::filesystem::path& file)
    : file_(file.string()), xml_(std::make_unique<tinyxml2::XMLDocument>()) {
  parse(read_file(file));
  root_ = xml_->RootElement();
  if (root_ == nullptr || std::strcmp(root_->Name(), "COLLADA") != 0) {
    throw Error(file_ + ":1: the outermost element is not <COLLADA>; name a .dae file");
  }
  index(*root_);
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
    throw Error(where + "elements are nested too deep; flatten the scene");
  }
  throw Error(where + "the XML is malformed (" + tinyxml2::XMLDocument::ErrorIDToName(error) +
              "); correct it there, or copy the file again if it was cut off");
}

void ColladaDocument::index(const XMLElement& element) {
  if (const char* id = element.Attribute("id")) {
    const std::string key = std::string(element.Name()) + "#" + id;
    if (!is_new(by_id_[key], element) && duplicates_++ == 0) first_duplicate_ = &element;
    if (const XMLElement* mesh = mesh_around(element)) is_new(in_mesh_[{mesh, key}], element);
  }
  for (const XMLElement* child = element.FirstChildElement(); child != nullptr;
       child = child->NextSiblingElement()) {
    index(*child);
  }
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

ColladaDocument::Identified ColladaDocument::find(const XMLElement& from, std::string_view url,
                                                  const char* kind) const {
  if (url.empty() || url.front() != '#') return {};
  const std::string key = std::string(kind) + std::string(url);
  if (const XMLElement* mesh = mesh_around(from)) {
    const auto own = in_mesh_.find({mesh, key});
    if (own != in_mesh_.end()) return own->second;
  }
  const auto found = by_id_.find(key);
  if (found != by_id_.end()) return found->second;
  const std::string plain = decoded(url);
  return plain == url ? Identified{} : find(from, plain, kind);
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
    fail(from, std::string("there is no <") + kind + "> with the id that " + quoted(url) +
                   " names; define it in this file or correct the " + name);
  }
  if (found.second != nullptr) fail(from, ambiguity(url, found) + "; give each an id of its own");
  return *found.first;
}

std::string ColladaDocument::note_on_ids() const {
  if (first_duplicate_ == nullptr) return "";
  return std::to_string(duplicates_) + " elements have the id of another (the first: <" +
         first_duplicate_->Name() + "> " + quoted(first_duplicate_->Attribute("id")) + " in line " +
         std::to_string(first_duplicate_->GetLineNum()) +
         "): what refers to one means that of its own mesh; else a note says which is taken.";
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

std::string quoted(std::string_view text) {
  constexpr std::size_t kLongest = 40;
  std::string out = "'";
  for (const char c : text.substr(0, kLongest)) out += c >= ' ' && c <= '~' ? c : '?';
  return out + (text.size() > kLongest ? "...'" : "'");
}

}  // namespace pt
