#include "grader/service/intake/gradescope.h"

#include "pt/error.h"

#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <yaml-cpp/yaml.h>

namespace grader::intake {

namespace {

// The value of the key, or an empty node if there is no table: there yaml-cpp would throw.
YAML::Node value_of(const YAML::Node& table, const char* key) {
  return table.IsMap() ? table[key] : YAML::Node();
}

std::string text_of(const YAML::Node& table, const char* key) {
  const YAML::Node value = value_of(table, key);
  return value && value.IsScalar() ? value.as<std::string>("") : "";
}

// IDs are joined by a comma and a blank, which a learner's own may have in it.
std::string as_one_id(std::string id) {
  for (std::size_t at = 0; (at = id.find(", ", at)) != id.npos;) id.erase(at + 1, 1);
  return id;
}

Submitters submitters_of(const YAML::Node& entry) {
  std::vector<std::string> names, ids;
  const std::string handed_in = text_of(entry, ":created_at");
  const YAML::Node people = value_of(entry, ":submitters");
  if (!people || !people.IsSequence()) return {"", "", handed_in};
  for (const auto& each : people) {
    const YAML::Node& person = each;
    const std::string name = text_of(person, ":name"), number = text_of(person, ":sid");
    const std::string id = number.empty() ? text_of(person, ":email") : number;
    if (!name.empty()) names.push_back(name);
    if (!id.empty()) ids.push_back(as_one_id(id));
  }
  return {fmt::format("{}", fmt::join(names, ", ")), fmt::format("{}", fmt::join(ids, ", ")),
          handed_in};
}

}  // namespace

std::map<std::string, Submitters> read_gradescope_list(const std::string& file) {
  try {
    const YAML::Node listed = YAML::LoadFile(file);
    if (!listed.IsMap()) {
      throw pt::Error(file + ":1: it is not a list of submissions; export them again");
    }
    std::map<std::string, Submitters> all;
    for (const auto& entry : listed) {
      if (entry.first.IsScalar()) all[entry.first.Scalar()] = submitters_of(entry.second);
    }
    return all;
  } catch (const YAML::Exception& error) {
    throw pt::Error(fmt::format("{}:{}: {}; export the submissions again", file,
                                error.mark.line + 1, error.msg));
  }
}

}  // namespace grader::intake
