#pragma once

#include <functional>
#include <string>

// The text of a page: Markdown in which a line {{figure NAME}} stands for a figure, and {{NAME}} in a
// sentence for a number that was measured. {{if A < B}} or {{if A > B}} in a sentence says when it is
// true; A and B are names, numbers, or a number times a name: 2*NAME. A sentence that is not true, or
// whose numbers are not measured, is left out.

namespace writeup {

inline constexpr const char* kDash = "\u2013";  // there is no number

struct Names {
  // HTML of a figure; text of a number, kDash if it is not measured. Empty if there is none of that
  // name.
  std::function<std::string(const std::string&)> figure, number;
};

// `file` is the name of the text in messages. Throws pt::Error, "FILE:LINE: ...", for a name that
// is not known.
std::string page_from_text(const std::string& file, const std::string& text, const Names& names);

// Plain Markdown, without names. HTML tags in it are shown as they are written, or kept: for texts of our own.
enum class Tags { shown, kept };
std::string html_from_markdown(const std::string& text, Tags tags = Tags::shown);

// HTML's own characters, written so that they stand for themselves.
std::string escaped(const std::string& text);

}  // namespace writeup
