#include "grader/pictures/recipes/read_recipe.h"

#include "grader/tasks.h"
#include "pt/error.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

namespace grader::pictures {

namespace {

using nlohmann::json;

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

constexpr int kMaxSide = 1024;  // a larger picture counts as a typing error
constexpr int kMaxBounces = 1000;
constexpr int kMaxSamples = 1 << 20;

const std::map<std::string, pt::Framing> kFramings{
    {"course", pt::Framing::course}, {"fit", pt::Framing::fit}, {"file", pt::Framing::file}};
const std::map<std::string, pt::PathSettings::Direct> kDirect{
    {"hemisphere", pt::PathSettings::Direct::hemisphere},
    {"lights", pt::PathSettings::Direct::lights}};

std::string read_name(Fields& fields) {
  std::string name = fields.text("name");
  const bool fits_a_file =
      name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_") == std::string::npos;
  if (!fits_a_file) fields.fail("a name may have only lower-case letters, digits and underscores");
  return name;
}

std::filesystem::path read_scene(Fields& fields, const std::filesystem::path& file) {
  const std::string name = fields.text("scene");
  std::filesystem::path path = file.parent_path() / name;
  if (!std::filesystem::is_regular_file(path)) {
    fields.fail(fmt::format("there is no scene '{}'; scenes are named relative to the recipes",
                            path.string()));
  }
  return path;
}

pt::PathSettings read_settings(Fields& fields) {
  pt::PathSettings settings;
  settings.show_normals = fields.flag("normals");
  if (settings.show_normals) {
    for (const char* key : {"bounces", "direct", "light_samples", "survival"}) {
      if (fields.has(key)) fields.fail(fmt::format("normals show no light: remove '{}'", key));
    }
    return settings;
  }
  const json& bounces = fields.list("bounces", 2);
  settings.from = fields.whole(bounces[0], "bounces", 0, kMaxBounces);
  settings.to = fields.whole(bounces[1], "bounces", 0, kMaxBounces);
  if (settings.from > settings.to) {
    fields.fail(fmt::format("'bounces' goes from {} to {}; write the smaller first", settings.from,
                            settings.to));
  }
  settings.direct = fields.choice("direct", kDirect, settings.direct);
  if (fields.has("light_samples")) {
    settings.light_samples = fields.whole("light_samples", 1, kMaxSamples);
  }
  if (fields.has("survival")) settings.survival = fields.number("survival", 0, 1);
  return settings;
}

std::optional<pt::AdaptiveSettings> read_adaptive(Fields& of_recipe, const std::string& where) {
  if (!of_recipe.has("adaptive")) return {};
  Fields fields(of_recipe.required("adaptive"), where + ": 'adaptive'");
  const int max_samples = fields.whole("max_samples", 2, kMaxSamples);
  const int batch = fields.whole("batch", 2, max_samples);
  const double tolerance = fields.number("tolerance", 0, 1);
  fields.require_no_more();
  return pt::AdaptiveSettings{max_samples, batch, tolerance};
}

std::vector<std::string> read_tasks(Fields& fields) {
  const json& list = fields.required("tasks");
  if (!list.is_array() || list.empty()) {
    fields.fail("'tasks' lists the tasks that the picture judges; name at least one");
  }
  std::vector<std::string> tasks;
  const auto is_in = [](const std::vector<std::string>& all, const std::string& one) {
    return std::find(all.begin(), all.end(), one) != all.end();
  };
  for (const json& each : list) {
    const std::string slug = each.is_string() ? each.get<std::string>() : each.dump();
    if (!is_in(task_slugs(), slug)) {
      fields.fail(fmt::format("there is no task '{}'; take some of {}", slug,
                              fmt::join(task_slugs(), ", ")));
    }
    if (is_in(tasks, slug)) fields.fail(fmt::format("'tasks' names {} twice", slug));
    tasks.push_back(slug);
  }
  return tasks;
}

std::optional<pt::Rgb> read_uniform(Fields& fields) {
  if (!fields.has("uniform")) return {};
  const json& list = fields.list("uniform", 3);
  pt::Rgb radiance;
  for (int channel = 0; channel < 3; ++channel) {
    if (!list[channel].is_number() || !(list[channel] >= 0)) {
      fields.fail("'uniform' must be the radiance in red, green and blue, none below zero");
    }
    radiance[channel] = list[channel];
  }
  return radiance;
}

std::string place(const json& object, const std::filesystem::path& file, std::size_t number) {
  const bool named = object.is_object() && object.contains("name") && object["name"].is_string();
  return named ? fmt::format("{}: recipe '{}'", file.string(), object["name"].get<std::string>())
               : fmt::format("{}: recipe number {}", file.string(), number);
}

}  // namespace

const std::vector<std::string>& task_slugs() {
  static const std::vector<std::string> slugs = [] {
    std::vector<std::string> all;
    for (const Task& task : tasks()) all.push_back(task.slug);
    return all;
  }();
  return slugs;
}

Recipe read_recipe(const json& object, const std::filesystem::path& file, std::size_t number) {
  const std::string where = place(object, file, number);
  Fields fields(object, where);
  Recipe recipe;
  recipe.name = read_name(fields);
  recipe.title = fields.text("title");
  recipe.scene = read_scene(fields, file);
  recipe.framing = fields.choice("camera", kFramings, pt::Framing::file);
  if (fields.has("size")) {
    const json& size = fields.list("size", 2);
    recipe.width = fields.whole(size[0], "size", 1, kMaxSide);
    recipe.height = fields.whole(size[1], "size", 1, kMaxSide);
  }
  recipe.settings = read_settings(fields);
  recipe.adaptive = read_adaptive(fields, where);
  recipe.seed = fields.whole("seed", 1, std::numeric_limits<std::int32_t>::max());
  recipe.tasks = read_tasks(fields);
  recipe.noisy = fields.flag("noisy");
  if (fields.has("most_noise")) recipe.most_noise = fields.number("most_noise", 1, 1000);
  recipe.uniform = read_uniform(fields);
  fields.require_no_more();
  return recipe;
}

}  // namespace grader::pictures
