#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>

namespace tinyxml2 {
class XMLDocument;
class XMLElement;
}  // namespace tinyxml2

namespace pt {

using tinyxml2::XMLElement;

// A COLLADA file as a tree of elements, which live as long as the document does. Throws Error for a
// file that is missing, not a regular file, empty, too large, not COLLADA or malformed.
class ColladaDocument {
 public:
  explicit ColladaDocument(const std::filesystem::path& file);
  ~ColladaDocument();

  const XMLElement& root() const { return *root_; }

  // Throws Error: "file:line: what", with the element's line. `what` ends with what to do.
  [[noreturn]] void fail(const XMLElement& at, const std::string& what) const;

  // The first child of that name; an error if there is none.
  const XMLElement& child(const XMLElement& parent, const char* name) const;

  // The attribute's text; an error if it is missing.
  std::string_view attribute(const XMLElement& element, const char* name) const;

  // The element of that kind whose id the attribute names as "#id"; an error if there is none, or
  // more than one.
  const XMLElement& resolve(const XMLElement& from, const char* attribute, const char* kind) const;

  // The first two elements of that kind with the id of the url at `from`, null if there are fewer. In a mesh, only
  // its own parts count if one has the id: some exporters give the parts of every mesh the same ids.
  struct Identified {
    const XMLElement* first = nullptr;
    const XMLElement* second = nullptr;
  };
  Identified find(const XMLElement& from, std::string_view url, const char* kind) const;

  // "'#sun' may be the <light> of line 8 or that of line 9"
  static std::string ambiguity(std::string_view url, const Identified& found);

  // A sentence about ids that several elements of one kind have; empty if there are none.
  std::string note_on_ids() const;

 private:
  void parse(const std::string& text);
  void index(const XMLElement& element);

  std::string file_;
  std::unique_ptr<tinyxml2::XMLDocument> xml_;
  const XMLElement* root_ = nullptr;
  std::unordered_map<std::string, Identified> by_id_;  // "kind#id"
  std::map<std::pair<const XMLElement*, std::string>, Identified> in_mesh_;
  const XMLElement* first_duplicate_ = nullptr;
  std::size_t duplicates_ = 0;
};

// The first child called `name` of the course's own techniques, extra/technique[@profile CGL or
// CMU462], of an element; null if there is none. With an empty name, the first child of all.
const XMLElement* course_child(const XMLElement& element, const char* name);

// The name of an element in messages: its name, else its id, in quotes, safe to print.
std::string label(const XMLElement& element);

// Text from a file in quotes: shortened, and without bytes that a terminal might obey.
std::string quoted(std::string_view text);

}  // namespace pt
