#include "grader/pictures/recipes/recipe_fields.h"

#include "pt/error.h"

#include <utility>

namespace grader::pictures {

using nlohmann::json;

Fields::Fields(const json& object, std::string where) : object_(object), where_(std::move(where)) {
  if (!object.is_object()) fail("write an object, {...}");
}

void Fields::fail(const std::string& what) const { throw pt::Error(where_ + ": " + what); }

const json& Fields::take(const std::string& key) {
  taken_.insert(key);
  return object_.at(key);
}

const json& Fields::required(const std::string& key) {
  if (!has(key)) fail(fmt::format("'{}' is missing; add it", key));
  return take(key);
}

std::string Fields::text(const std::string& key) {
  const json& value = required(key);
  if (!value.is_string() || value.get_ref<const std::string&>().empty()) {
    fail(fmt::format("'{}' must be a text; write it in quotes", key));
  }
  return value;
}

bool Fields::flag(const std::string& key) {
  if (!has(key)) return false;
  const json& value = take(key);
  if (!value.is_boolean()) fail(fmt::format("'{}' must be true or false", key));
  return value;
}

int Fields::whole(const std::string& key, int low, int high) {
  return whole(required(key), key, low, high);
}

int Fields::whole(const json& value, const std::string& key, int low, int high) const {
  if (!value.is_number_integer() || value < low || value > high) {
    fail(fmt::format("'{}' takes whole numbers from {} to {}, not {}", key, low, high,
                     value.dump()));
  }
  return value;
}

double Fields::number(const std::string& key, double low, double high) {
  const json& value = required(key);
  if (!value.is_number() || !(value > low) || !(value <= high)) {
    fail(fmt::format("'{}' must be a number above {} and up to {}, not {}", key, low, high,
                     value.dump()));
  }
  return value;
}

const json& Fields::list(const std::string& key, std::size_t length) {
  const json& value = required(key);
  if (!value.is_array() || value.size() != length) {
    fail(fmt::format("'{}' must be a list of {} numbers, not {}", key, length, value.dump()));
  }
  return value;
}

void Fields::require_no_more() const {
  for (const auto& [key, value] : object_.items()) {
    if (!taken_.contains(key)) {
      fail(fmt::format("there is no field '{}' here; correct or remove it", key));
    }
  }
}

}  // namespace grader::pictures
