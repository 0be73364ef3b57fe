#pragma once

#include "grader/judge/config.h"
#include "grader/pictures/known_mistakes.h"
#include "grader/pictures/recipes.h"

#include <string>
#include <vector>

// The pictures of wrong solutions that verdict_mistakes keeps, and the mistakes that these pictures
// name.

namespace grader::self_check {

// The beginning of the hash of a solution's text.
std::string content_of(const std::string& text);

// The sentence that says the mistake, from the second line on; empty if there is no comment.
std::string sentence_of(const std::string& text);

// The files beside the CSV at `out`: the known pictures, and those of other samples.
std::string known_path(const std::string& out);
std::string seen_path(const std::string& out);

// The picture as it was judged.
pictures::KnownMistake::Picture picture_of(const results::PictureResult& result);

// The same of a picture that was wrong before: if it is right now nobody knows.
pictures::KnownMistake::Picture known_picture(const results::PictureResult& result);

// Puts the known pictures into golden/known_mistakes.jsonl: those found beside `out` replace those
// in the file; no solution that has changed or is gone.
void write_known(const judge::Config& config, const std::string& out);

// Markdown: of each task, how many wrong solutions a picture sees, and how many of these are named
// right, wrongly, or not, by what was seen and golden/known_mistakes.jsonl.
std::string table_of_names(const judge::Config& config,
                           const std::vector<pictures::Recipe>& recipes, const std::string& out);

}  // namespace grader::self_check
