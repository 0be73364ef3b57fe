#include "grader/results/json.h"

#include "grader/base/json_text.h"
#include "grader/results/members.h"
#include "pt/error.h"
#include "pt/file.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <set>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace grader::results {

namespace {

using nlohmann::json;
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

namespace {

// More than twelve tasks need, even if each text has its largest length.
constexpr std::size_t kMaxBytes = std::size_t{1} << 26;
constexpr std::size_t kMaxEntries = 1000;
constexpr int kMaxNumber =
    1 << 24;  // more than any grader writes; sums of such numbers fit into an int

template <class T>
void read(const json& from, T& value) {
  from.get_to(value);
}

// A number that is not finite is written as null.
void read(const json& from, double& value) {
  value = from.is_null() ? std::numeric_limits<double>::quiet_NaN() : from.get<double>();
}

void read(const json& from, int& value) {
  // get<long long>() would turn a number above the largest long long into a negative one.
  const bool whole = from.is_number_integer() &&
                     !(from.is_number_unsigned() && from.get<std::uint64_t>() > kMaxNumber);
  const auto number = whole ? from.get<long long>() : 0;
  if (!whole || number < -kMaxNumber || number > kMaxNumber) {
    throw pt::Error("a whole number was expected, not " + from.dump().substr(0, 40));
  }
  value = static_cast<int>(number);
}

// One of `all`, by its name.
template <class Choice, std::size_t n>
Choice choice(const json& from, const std::array<Choice, n>& all, const std::string& kind) {
  const std::string text = from;
  const auto found =
      std::ranges::find(all, text, [](Choice each) { return std::string(name(each)); });
  if (found == all.end()) throw pt::Error("there is no " + kind + " '" + text.substr(0, 40) + "'");
  return *found;
}

void read(const json& from, State& state) { state = choice(from, kStates, "state"); }
void read(const json& from, Cause& cause) { cause = choice(from, kCauses, "cause"); }

template <class T>
void read(const json& from, std::vector<T>& values);

// A missing member keeps its default: an older file of the same version has fewer members.
template <class T>
requires requires(T& value) {
  members(value, [](auto&&...) {});
}
void read(const json& from, T& value) {
  if (!from.is_object()) throw pt::Error("an object was expected");
  members(value, [&](const char* member, auto& each) {
    if (from.contains(member)) read(from.at(member), each);
  });
}

template <class T>
void read(const json& from, std::vector<T>& values) {
  if (!from.is_array()) throw pt::Error("a list was expected");
  if (from.size() > kMaxEntries) throw pt::Error("a list is longer than any of the grader's");
  values.clear();
  for (const json& each : from) read(each, values.emplace_back());
}

// Grades are computed from results, so faulty results are refused.
void expect_sound(const Results& results) {
  std::set<std::string> slugs;
  for (const TaskResult& task : results.tasks) {
    if (!slugs.insert(task.slug).second)
      throw pt::Error("the task " + task.slug + " is there twice");
    bool sound = task.points >= 0 && task.points <= task.max_points && task.bonus_points >= 0;
    for (const PictureResult& picture : task.pictures) {
      sound = sound && picture.points >= 0 && picture.points <= picture.max_points;
    }
    if (!sound)
      throw pt::Error("the points of " + task.slug + " are more than possible, or negative");
  }
}

}  // namespace

Results results_from_json(const std::string& text, const std::string& path) {
  try {
    const json from = json::parse(text);
    if (from.at("schema_version") != kSchemaVersion) {
      throw pt::Error(fmt::format("the schema is not version {}", kSchemaVersion));
    }
    from.at("tasks");
    Results results;
    read(from, results);
    expect_sound(results);
    return results;
  } catch (const std::exception& error) {
    throw pt::Error(fmt::format("{} holds no results of this grader: {}; judge again", path,
                                base::words_of(error)));
  }
}

Results read_results(const std::string& path) {
  return results_from_json(pt::read_file(path, kMaxBytes), path);
}

}  // namespace grader::results
