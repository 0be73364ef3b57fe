#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

namespace grader::pictures {

// Takes the fields of one JSON object and says what is wrong with them: all functions throw
// pt::Error, "where: what is wrong; what to do".
class Fields {
 public:
  // The object has to outlive this. Throws if it is not an object.
  Fields(const nlohmann::json& object, std::string where);

  [[noreturn]] void fail(const std::string& what) const;

  bool has(const std::string& key) const { return object_.contains(key); }

  const nlohmann::json& required(const std::string& key);
  std::string text(const std::string& key);  // required, not empty
  bool flag(const std::string& key);         // false if it is missing
  int whole(const std::string& key, int low, int high);
  double number(const std::string& key, double low, double high);  // above low, up to high
  const nlohmann::json& list(const std::string& key, std::size_t length);

  // Returns `value`, which is somewhere inside `key`, as a whole number.
  int whole(const nlohmann::json& value, const std::string& key, int low, int high) const;

  template <class Meaning>
  Meaning choice(const std::string& key, const std::map<std::string, Meaning>& choices,
                 Meaning otherwise) {
    if (!has(key)) return otherwise;
    const nlohmann::json& value = take(key);
    std::vector<std::string> names;
    for (const auto& [name, meaning] : choices) {
      if (value == name) return meaning;
      names.push_back(name);
    }
    fail(fmt::format("'{}' must be one of {}, not {}", key, fmt::join(names, ", "), value.dump()));
  }

  // Call this when all known fields have been taken. Throws if others are left.
  void require_no_more() const;

 private:
  const nlohmann::json& take(const std::string& key);

  const nlohmann::json& object_;
  std::string where_;
  std::set<std::string> taken_;
};

}  // namespace grader::pictures
