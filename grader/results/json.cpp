#include "grader/results/json.h"

#include "grader/results/members.h"
#include "pt/file.h"

#include <nlohmann/json.hpp>

namespace grader::results {

namespace {

using nlohmann::ordered_json;

template <class T>
ordered_json describe(const T& value) {
  return value;
}

ordered_json describe(State state) { return name(state); }
ordered_json describe(Cause cause) { return name(cause); }

template <class T>
ordered_json describe(const std::vector<T>& values);

template <class T>
requires requires(const T& value) {
  members(value, [](auto&&...) {});
}
ordered_json describe(const T& value) {
  ordered_json object;
  members(value, [&](const char* member, const auto& each) { object[member] = describe(each); });
  return object;
}

template <class T>
ordered_json describe(const std::vector<T>& values) {
  ordered_json list = ordered_json::array();
  for (const T& value : values) list.push_back(describe(value));
  return list;
}

}  // namespace

std::string to_json(const Results& results) {
  ordered_json all{{"schema_version", kSchemaVersion}};
  all["passed"] = results.complete && passes(results);
  all.update(describe(results));
  // Texts may hold what a submission printed or threw, which need not be UTF-8.
  return all.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

void write_json(const Results& results, const std::string& path) {
  pt::write_file(path, to_json(results));
}

}  // namespace grader::results
