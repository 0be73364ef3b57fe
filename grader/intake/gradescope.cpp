#include "grader/intake/gradescope.h"

#include "pt/error.h"

#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <yaml-cpp/yaml.h>

namespace grader::intake {

namespace {

std::string text_of(const YAML::Node& node) {
  return node && node.IsScalar() ? node.as<std::string>("") : "";
}

Submitters submitters_of(const YAML::Node& entry) {
  std::vector<std::string> names, ids;
  for (const auto& who : entry[":submitters"]) {
    const std::string id = text_of(who[":sid"]);
    names.push_back(text_of(who[":name"]));
    ids.push_back(id.empty() ? text_of(who[":email"]) : id);
  }
  return {fmt::format("{}", fmt::join(names, ", ")), fmt::format("{}", fmt::join(ids, ", "))};
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
