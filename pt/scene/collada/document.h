#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <unordered_map>

namespace tinyxml2 {
class XMLDocument;
class XMLElement;
}  // namespace tinyxml2

namespace pt {

using tinyxml2::XMLElement;

// A COLLADA file as a tree of elements, which live as long as the document does. Throws Error for a
// file that is missing, not a regular file, empty, too large, not COLLADA or malformed, and for an
// id that two elements of one kind share.
class ColladaDocument {
 public:
  explicit ColladaDocument(const std::filesystem::path& file);
  ~ColladaDocument();

  const XMLElement& root() const { return *root_; }
  bool has_course_profile() const { return has_course_profile_; }

  // Throws Error: "file:line: what", with the element's line. `what` ends with what to do.
  [[noreturn]] void fail(const XMLElement& at, const std::string& what) const;

  // The first child of that name; an error if there is none.
  const XMLElement& child(const XMLElement& parent, const char* name) const;

  // The attribute's text; an error if it is missing.
  std::string_view attribute(const XMLElement& element, const char* name) const;

  // The element of that kind whose id the attribute names as "#id"; an error if there is none.
  const XMLElement& resolve(const XMLElement& from, const char* attribute, const char* kind) const;

  // The same, or null: for references that may lead to elements of several kinds.
  const XMLElement* find(std::string_view url, const char* kind) const;

 private:
  void parse(const std::string& text);
  void index(const XMLElement& element);

  std::string file_;
  std::unique_ptr<tinyxml2::XMLDocument> xml_;
  const XMLElement* root_ = nullptr;
  std::unordered_map<std::string, const XMLElement*> by_id_;  // "kind#id"
  bool has_course_profile_ = false;
};

// The first child called `name` of the course's own techniques, extra/technique[@profile CGL or
// CMU462], of an element; null if there is none. With an empty name, the first child of all.
const XMLElement* course_child(const XMLElement& element, const char* name);

// The name of an element in messages: its name, else its id, in quotes, fit to be printed.
std::string label(const XMLElement& element);

// Text from a file in quotes: shortened, and without bytes that a terminal might obey.
std::string quoted(std::string_view text);

}  // namespace pt
