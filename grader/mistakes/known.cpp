#include "grader/mistakes/known.h"

#include "grader/mistakes/naming.h"
#include "pt/error.h"

#include <sstream>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace grader::mistakes {

namespace {

using nlohmann::json;
using nlohmann::ordered_json;

ordered_json describe(const Fingerprint& print, const Answers& right) {
  ordered_json differs = ordered_json::object();
  for (std::size_t i = 0; i < print.answers.size(); ++i) {
    if (!is_as_right(print.answers[i], right.at(i))) {
      differs[std::to_string(i)] = describe(print.answers[i]);
    }
  }
  return {{"name", print.name},
          {"breaks", print.breaks},
          {"sentence", print.sentence},
          {"hint", print.hint},
          {"differs", differs}};
}

Fingerprint read_fingerprint(const json& from, const Answers& right) {
  Fingerprint print{from.at("name"), from.at("breaks"), from.at("sentence"), from.at("hint"),
                    right};
  for (const auto& [index, answer] : from.at("differs").items()) {
    print.answers.at(std::stoul(index)) = read_answer(answer);
  }
  return print;
}

}  // namespace

Fingerprint described(const std::string& name, const std::string& code) {
  const std::string breaks = "// breaks: ", hint = "// hint: ";
  Fingerprint print;
  print.name = name;
  std::string* field = &print.sentence;
  std::istringstream lines(code);
  for (std::string line; std::getline(lines, line) && line.starts_with("// ");) {
    if (line.starts_with(breaks)) {
      print.breaks = line.substr(breaks.size());
      continue;
    }
    const bool begins = line.starts_with(hint);
    if (begins) field = &print.hint;
    *field += (field->empty() ? "" : " ") + line.substr(begins ? hint.size() : 3);
  }
  return print;
}

std::string to_json(const KnownTask& known) {
  // Writes one line per mistake, so that two of these files can be compared.
  std::string text = fmt::format("{{\n\"right\": {},\n\"mistakes\": [", to_json(known.right));
  const char* before = "\n";
  for (const Fingerprint& print : known.mistakes) {
    text += before + describe(print, known.right).dump();
    before = ",\n";
  }
  return text + "]\n}\n";
}

KnownTask known_from_json(const std::string& text, const std::string& path) {
  try {
    const json all = json::parse(text);
    KnownTask known;
    for (const json& answer : all.at("right")) known.right.push_back(read_answer(answer));
    for (const json& each : all.at("mistakes")) {
      known.mistakes.push_back(read_fingerprint(each, known.right));
    }
    return known;
  } catch (const std::exception& error) {
    throw pt::Error(fmt::format("{} does not contain known mistakes: {}", path, error.what()));
  }
}

}  // namespace grader::mistakes
