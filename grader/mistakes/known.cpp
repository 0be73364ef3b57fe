#include "grader/mistakes/known.h"

#include "grader/mistakes/compare.h"
#include "pt/error.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace grader::mistakes {

namespace {

using nlohmann::json;
using nlohmann::ordered_json;

constexpr const char* kAbout =
    "How each known mistake shows: its answers to the battery of its task where they differ from "
    "the right ones. Made by the program known_mistakes; see CONTRIBUTING.md.";

ordered_json describe(const Fingerprint& print, const Answers& right) {
  ordered_json differs = ordered_json::object();
  for (std::size_t i = 0; i < print.answers.size(); ++i) {
    if (!is_as_right(print.answers[i], right.at(i))) {
      differs[std::to_string(i)] = describe(print.answers[i]);
    }
  }
  ordered_json all{{"name", print.name}, {"sentence", print.sentence}, {"source", print.source}};
  all["broken"] = print.broken;
  all["unsure"] = print.unsure;
  all["differs"] = differs;
  return all;
}

Fingerprint read_fingerprint(const json& from, const Answers& right) {
  Fingerprint print;
  from.at("name").get_to(print.name);
  from.at("sentence").get_to(print.sentence);
  from.at("source").get_to(print.source);
  from.at("broken").get_to(print.broken);
  from.at("unsure").get_to(print.unsure);
  print.answers = right;
  for (const auto& [index, answer] : from.at("differs").items()) {
    print.answers.at(std::stoul(index)) = read_answer(answer);
  }
  return print;
}

}  // namespace

std::string to_json(const KnownMistakes& known) {
  // One line per mistake, so that a diff shows which mistakes changed.
  std::string text = fmt::format("{{\n\"about\": {},\n\"tasks\": {{", json(kAbout).dump());
  const char* before = "\n";
  for (const auto& [slug, task] : known) {
    text += fmt::format("{}\"{}\": {{\n\"battery\": {},\n\"right\": {},\n\"mistakes\": [", before,
                        slug, json(task.battery).dump(), to_json(task.right));
    const char* first = "\n";
    for (const Fingerprint& print : task.mistakes) {
      text += first + describe(print, task.right).dump();
      first = ",\n";
    }
    text += "]}";
    before = ",\n";
  }
  return text + "}\n}\n";
}

KnownMistakes known_from_json(const std::string& text, const std::string& path) {
  try {
    KnownMistakes known;
    const json all = json::parse(text);
    for (const auto& [slug, from] : all.at("tasks").items()) {
      KnownTask& task = known[slug];
      from.at("battery").get_to(task.battery);
      for (const json& answer : from.at("right")) task.right.push_back(read_answer(answer));
      for (const json& each : from.at("mistakes")) {
        task.mistakes.push_back(read_fingerprint(each, task.right));
      }
    }
    return known;
  } catch (const std::exception& error) {
    throw pt::Error(fmt::format("{} holds no known mistakes: {}", path, error.what()));
  }
}

}  // namespace grader::mistakes
