#pragma once

#include <filesystem>
#include <initializer_list>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tinyxml2 {
class XMLDocument;
class XMLElement;
class XMLNode;
}  // namespace tinyxml2

namespace pt {

using tinyxml2::XMLElement;

// A COLLADA file as a tree of elements, which live as long as the document does. Throws Error for a
// file that read_text refuses, or that is malformed. Names of elements have no prefix of a
// namespace. `notes` receives a sentence for each thing that is
// corrected or ignored, and outlives the document.
class Document {
 public:
  Document(const std::filesystem::path& file, std::vector<std::string>& notes);
  ~Document();

  const XMLElement& root() const { return *root_; }

  // Returns whether the file has something in the course's own technique.
  bool has_course_profile() const { return has_course_profile_; }

  // Returns whether numbers are written as 0,5 and none as 0.5.
  bool has_decimal_commas() const { return has_commas_ && !has_points_; }

  // Throws Error: "file:line: what", with the element's line. `what` ends with what to do.
  [[noreturn]] void fail(const XMLElement& at, const std::string& what) const;

  void note(const std::string& sentence) const { notes_.push_back(sentence); }

  // The first child of that name; an error if there is none.
  const XMLElement& child(const XMLElement& parent, const char* name) const;

  // The element of that kind whose id the attribute names as "#id"; an error if there is none, or
  // more than one.
  const XMLElement& resolve(const XMLElement& from, const char* attribute, const char* kind) const;

  // The first two elements of that kind whose id the attribute names, null if there are fewer. In a
  // mesh, only its own parts count if one has the id: some exporters give the parts of every mesh
  // the same ids. The attribute may begin with the name of the file itself.
  struct Identified {
    const XMLElement* first = nullptr;
    const XMLElement* second = nullptr;
  };
  Identified find(const XMLElement* from, const char* attribute, const char* kind) const;

  // The same, with a note if there is none, which ends with what happens then.
  Identified find_or_note(const XMLElement& from, const char* attribute, const char* kind,
                          const std::string& what_happens) const;

  // "'#sun' may be the <light> of line 8 or that of line 9"
  static std::string ambiguity(std::string_view url, const Identified& found);

  // Notes ids that several elements have, parts with an <asset> of their own, and commas.
  void note_on_the_whole() const;

 private:
  void parse(const std::string& text);
  void look_for_decimals(const tinyxml2::XMLNode& node);
  void index(XMLElement& element);
  std::string_view own_part(std::string_view url) const;
  std::string missing(std::string_view url, const char* kind) const;

  std::string file_;
  std::unique_ptr<tinyxml2::XMLDocument> xml_;
  const XMLElement* root_ = nullptr;
  std::vector<std::string>& notes_;
  std::string prefix_;  // of all names: "ns0:", or nothing
  // By "kind#id", within a <mesh>; null stands for the whole file.
  std::map<std::pair<const XMLElement*, std::string>, Identified> by_id_;
  const XMLElement* first_duplicate_ = nullptr;
  std::size_t duplicates_ = 0;
  bool has_course_profile_ = false;
  bool has_commas_ = false;  // in a number
  bool has_points_ = false;
  std::vector<const XMLElement*> assets_;  // of all elements
};

// The children of an element that have this name; without a name, all.
std::vector<const XMLElement*> children(const XMLElement& parent, const char* name = nullptr);

// The element that a path of names leads to, by the first child of each name; null if there is none.
const XMLElement* find_below(const XMLElement* from, std::initializer_list<const char*> path);

// The text of an attribute; empty if it is missing, or the element is null.
std::string_view attribute(const XMLElement* element, const char* name);

// The first child of that name (without one, of any) in the course's own techniques of an element,
// extra/technique[@profile CGL or CMU462]; null if there is none.
const XMLElement* course_child(const XMLElement& element, const char* name = nullptr);

// An element in messages: its name, else its id, in quotes, safe to print; "<node>"; "line 12".
std::string label(const XMLElement& element);
std::string tag(const XMLElement& element);
std::string line(const XMLElement& element);

// The text of an element without the white space around it; empty if there is none, or no element.
std::string_view trimmed_text(const XMLElement* element);

// Text from a file in quotes: shortened, and without quotes and bytes that a terminal might obey.
std::string quoted(std::string_view text);

}  // namespace pt
