#include "grader/door/dialect.h"

#include "grader/base/json_text.h"
#include "grader/door/texts.h"
#include "pt/error.h"
#include "pt/file.h"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace grader::door {

namespace {

namespace fs = std::filesystem;

using nlohmann::json;

Change change_of(const std::string& word) {
  if (word == "dropped") return Change::dropped;
  if (word == "bonus") return Change::bonus;
  if (word == "slower") return Change::slower;
  throw pt::Error("'" + word + "' means nothing; write dropped, bonus or slower");
}

const Change* change_in(const Dialect& dialect, const std::string& slug,
                        const std::string& promise) {
  const auto task = dialect.promises.find(slug);
  if (task == dialect.promises.end()) return nullptr;
  const auto found = task->second.find(promise);
  return found == task->second.end() ? nullptr : &found->second;
}

// In 2019, functions have other names where an adapter says so.
std::string name_in(const Adapter& adapter, Generation generation) {
  const bool is_old = generation == Generation::of_2019;
  return is_old ? adapter.functions.back() : adapter.functions.front();
}

}  // namespace

Dialect no_dialect(const fs::path& texts, Generation generation) {
  Dialect dialect{"the contracts of pt/tasks/, and none of the course"};
  for (const auto& [slug, adapter] : read_texts(texts).tasks)
    dialect.functions[slug] = name_in(adapter, generation);
  return dialect;
}

Dialect load_dialect(const fs::path& texts, Generation generation) {
  const fs::path path = texts / "dialects" / fmt::format("{}.json", first_year(generation));
  const json all = base::parse_json(pt::read_file(path), path);
  Dialect dialect = no_dialect(texts, generation);
  try {
    dialect.name = all.at("name").get<std::string>();
    for (const auto& [slug, promises] : all.at("tasks").items()) {
      for (const auto& [promise, change] : promises.items())
        dialect.promises[slug][promise] = change_of(change.at(0).get<std::string>());
    }
  } catch (const json::exception& error) {
    throw pt::Error(
        fmt::format("{}: {}; see grader/door/dialect.h", path.string(), base::words_of(error)));
  } catch (const pt::Error& error) {
    throw pt::Error(fmt::format("{}: {}", path.string(), error.what()));
  }
  return dialect;
}

bool is_dropped(const Dialect& dialect, const std::string& slug, const std::string& promise) {
  const Change* change = change_in(dialect, slug, promise);
  return change != nullptr && *change == Change::dropped;
}

void translate(const Dialect& dialect, results::TaskResult& task) {
  std::erase_if(task.promises, [&](const results::PromiseResult& promise) {
    return is_dropped(dialect, task.slug, promise.name);
  });
  for (results::PromiseResult& promise : task.promises) {
    const Change* change = change_in(dialect, task.slug, promise.name);
    if (change == nullptr) continue;
    promise.bonus = true;
    promise.words += *change == Change::slower ? " (the course allows it: slower, not wrong)"
                                               : " (the course does not ask for it)";
  }
  const auto name = dialect.functions.find(task.slug);
  if (name != dialect.functions.end()) task.called = name->second;
}

}  // namespace grader::door
