#include "pt/scene/collada/text.h"

#include "pt/error.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <locale>
#include <optional>
#include <string_view>
#include <system_error>

namespace pt {

namespace {

// A mesh of a million triangles needs about 80 MB. Markup takes far more memory than its length in
// the file, so it has a separate limit.
constexpr std::uintmax_t kMaxBytes = std::uintmax_t{512} << 20;
constexpr std::ptrdiff_t kMaxMarkup = 2'000'000;
constexpr std::size_t kMaxAttributes = 250;  // of one tag; COLLADA knows some ten
constexpr std::size_t kHeadBytes = 64 * 1024;

// XML in UTF-16, of either byte order, as UTF-8; other text as it is. Such a file begins with a
// byte order mark or with "<". Nothing if a unit in the middle belongs to no character.
std::optional<std::string> as_utf8(const std::string& bytes) {
  const std::string_view first = std::string_view(bytes).substr(0, 2);
  const bool is_big = first == "\xfe\xff" || first == std::string_view("\0<", 2);
  if (!is_big && first != "\xff\xfe" && first != std::string_view("<\0", 2)) return bytes;
  std::u16string units;
  for (std::size_t i = 0; i + 1 < bytes.size(); i += 2) {
    const auto a = static_cast<unsigned char>(bytes[i]);
    const auto b = static_cast<unsigned char>(bytes[i + 1]);
    units += static_cast<char16_t>(is_big ? a << 8 | b : b << 8 | a);
  }
  using Codec = std::codecvt<char16_t, char8_t, std::mbstate_t>;
  std::u8string text(3 * units.size(), u8'\0');
  std::mbstate_t state{};
  const char16_t* read = nullptr;
  char8_t* written = nullptr;
  const auto result = std::use_facet<Codec>(std::locale::classic())
                          .out(state, units.data(), units.data() + units.size(), read, text.data(),
                               text.data() + text.size(), written);
  if (result == std::codecvt_base::error) return std::nullopt;
  return std::string(text.data(), written);
}

// "a Wavefront OBJ" and the like, by how such files begin; empty if it is none that is known.
std::string other_format(std::string_view head, std::uintmax_t size) {
  const auto begins_a_line = [&](const char* word) {
    return head.starts_with(word) || head.find("\n" + std::string(word)) != head.npos;
  };
  if (head.starts_with("glTF")) return "a binary glTF";
  if (head.find("\"asset\"") != head.npos && head.find('{') != head.npos) return "a glTF";
  if (head.starts_with("Kaydara FBX Binary") || head.starts_with("; FBX")) return "an FBX";
  if (head.starts_with("ply\n") || head.starts_with("ply\r")) return "a PLY";
  if (head.starts_with("solid") && head.find("facet") != head.npos) return "an STL";
  if (begins_a_line("v ")) return "a Wavefront OBJ";
  // A binary STL: 80 bytes, the number of triangles, and 50 bytes for each.
  std::uint32_t triangles = 0;
  if (head.size() >= 84) std::memcpy(&triangles, head.data() + 80, 4);
  return size == 84 + std::uintmax_t{50} * triangles ? "a binary STL" : "";
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
  const std::string head = as_utf8(text).value_or("<COLLADA");
  // The tag may have the prefix of a namespace.
  if (head.find("<COLLADA") == head.npos && head.find(":COLLADA") == head.npos) {
    const std::string other = other_format(text, size);
    throw Error(name + (other.empty()
                            ? ":1: is not a COLLADA file (no <COLLADA> near its beginning); "
                              "name a .dae file"
                            : ": is not a COLLADA file but " + other +
                                  "; ./run convert, in the whole project, makes a .dae of it"));
  }
  const std::size_t read = text.size();
  text.resize(size);
  in.read(text.data() + read, static_cast<std::streamsize>(size - read));
  if (size > read && !in) throw Error(name + ": cannot be read to its end; copy it again");
  return text;
}

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

// The line, counted from 1, of the first tag with too many attributes, if there is one. tinyxml2
// compares the attributes of a tag in pairs, and would read a tag of a megabyte for minutes.
std::optional<std::size_t> line_of_too_many_attributes(std::string_view xml) {
  for (std::size_t tag = xml.find('<'); tag < xml.size();) {
    std::size_t at = behind_markup(xml, tag);
    std::size_t count = 0;
    for (at = at == 0 ? tag + 1 : at - 1; at < xml.size() && xml[at] != '>'; ++at) {
      if (xml[at] == '"' || xml[at] == '\'') at = behind(xml, at + 1, xml.substr(at, 1)) - 1;
      if (xml[at] == '=' && ++count > kMaxAttributes) {
        return 1 + static_cast<std::size_t>(std::count(
                       xml.begin(), xml.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
      }
    }
    tag = xml.find('<', std::min(at, xml.size()));
  }
  return std::nullopt;
}

}  // namespace

std::string read_text(const std::filesystem::path& file) {
  const std::string name = file.string();
  std::optional<std::string> converted = as_utf8(read_file(file));
  if (!converted) throw Error(name + ": is not valid UTF-16; export the scene again");
  std::string text = std::move(*converted);
  if (text.find('\0') != std::string::npos) {
    throw Error(name + ": holds a zero byte, so it is not text; export the scene again");
  }
  if (std::count_if(text.begin(), text.end(), [](char c) { return c == '<' || c == '='; }) >
      kMaxMarkup) {
    throw Error(name + ": has more than two million tags and attributes; split the scene");
  }
  if (const auto line = line_of_too_many_attributes(text)) {
    throw Error(name + ":" + std::to_string(*line) + ": a tag has more than " +
                std::to_string(kMaxAttributes) + " attributes; keep those that COLLADA knows");
  }
  return text;
}

}  // namespace pt
