#include "grader/pictures/name_mistake.h"

#include "pt/error.h"

#include <algorithm>
#include <fstream>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace grader::pictures {
namespace {

using Json = nlohmann::ordered_json;

// Words after the hash for a picture that is right, and for one that is not known.
constexpr const char* kRight = "right";
constexpr const char* kUnknown = "unknown";

std::string text_of(const KnownMistake::Picture& picture) {
  const std::string what = !picture.known   ? kUnknown
                           : picture.blocks ? to_text(*picture.blocks)
                                            : kRight;
  return picture.recipe_hash + " " + what;
}

KnownMistake::Picture picture_of(const std::string& text) {
  const std::size_t space = text.find(' ');
  if (space == std::string::npos) throw pt::Error("a picture begins with the hash of its recipe");
  KnownMistake::Picture picture{text.substr(0, space), {}, true};
  const std::string what = text.substr(space + 1);
  picture.known = what != kUnknown;
  if (picture.known && what != kRight) picture.blocks = block_means_from(what);
  return picture;
}

KnownMistake mistake_of(const Json& json) {
  KnownMistake mistake{
      json.at("task"), json.at("name"), json.at("content"), json.at("sentence"), {}};
  for (const auto& [recipe, text] : json.at("pictures").items()) {
    mistake.pictures[recipe] = picture_of(text.get<std::string>());
  }
  return mistake;
}

}  // namespace

void add(std::vector<KnownMistake>& mistakes, KnownMistake mistake) {
  const auto before = std::find_if(mistakes.begin(), mistakes.end(), [&](const auto& other) {
    return other.task == mistake.task && other.name == mistake.name;
  });
  if (before == mistakes.end()) {
    mistakes.push_back(std::move(mistake));
    return;
  }
  // An entry that insert() finds already stays.
  if (before->content == mistake.content)
    mistake.pictures.insert(before->pictures.begin(), before->pictures.end());
  *before = std::move(mistake);
}

std::vector<KnownMistake> read_mistakes(const std::filesystem::path& file,
                                        const std::string& task) {
  std::vector<KnownMistake> mistakes;
  const std::string start = task.empty() ? "" : fmt::format("{{\"task\":\"{}\"", task);
  std::ifstream in(file);
  int number = 0;
  for (std::string line; std::getline(in, line);) {
    ++number;
    if (!line.starts_with(start)) continue;
    try {
      add(mistakes, mistake_of(Json::parse(line)));
    } catch (const std::exception& error) {  // of JSON, or our own
      throw pt::Error(
          fmt::format("{}:{}: does not describe a known mistake ({}); make the file again",
                      file.string(), number, error.what()));
    }
  }
  return mistakes;
}

std::string to_line(const KnownMistake& mistake) {
  Json pictures = Json::object();
  for (const auto& [recipe, picture] : mistake.pictures) pictures[recipe] = text_of(picture);
  const Json json{{"task", mistake.task},
                  {"name", mistake.name},
                  {"content", mistake.content},
                  {"sentence", mistake.sentence},
                  {"pictures", pictures}};
  return json.dump() + "\n";
}

Likeness compare(const std::string& recipe, const std::string& recipe_hash,
                 const JudgedPicture& picture, const BlockMeans& golden,
                 std::span<const KnownMistake> mistakes) {
  const bool wrong = picture.outcome == JudgedPicture::Outcome::wrong && picture.blocks;
  // Some faults do not show in these means: a sequence of random numbers that repeats itself.
  const bool shows = wrong && !can_be(*picture.blocks, golden);
  Likeness found;
  for (const KnownMistake& mistake : mistakes) {
    const auto known = mistake.pictures.find(recipe);
    if (known == mistake.pictures.end() || known->second.recipe_hash != recipe_hash ||
        !known->second.known) {
      continue;
    }
    const std::optional<BlockMeans>& blocks = known->second.blocks;
    if (picture.outcome == JudgedPicture::Outcome::right) {
      if (blocks) found.unlike.push_back(mistake.name);
    } else if (!blocks) {
      found.unlike.push_back(mistake.name);
    } else if (wrong) {
      if (!can_be(*picture.blocks, *blocks)) {
        found.unlike.push_back(mistake.name);
      } else if (shows) {
        found.like.push_back(mistake.name);
      }
    }
  }
  return found;
}

}  // namespace grader::pictures
