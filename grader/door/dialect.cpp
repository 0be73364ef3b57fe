#include "grader/door/dialect.h"

#include "grader/base/json_text.h"
#include "grader/base/wrap.h"
#include "grader/results/points.h"
#include "pt/error.h"
#include "pt/file.h"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace grader::door {

namespace {

namespace fs = std::filesystem;

using nlohmann::json;

constexpr const char* kNotKept = "not kept: ";  // around/common.txt

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

// The promises that are not kept, each with what the adapter says about the first call that shows it.
std::map<std::string, std::string> broken_in(const std::string& printed) {
  std::map<std::string, std::string> broken;
  for (const std::string& line : base::lines_of(printed)) {
    const std::size_t name = std::string_view(kNotKept).size(), colon = line.find(": ", name);
    if (line.starts_with(kNotKept) && colon != line.npos)
      broken.try_emplace(line.substr(name, colon - name), line.substr(colon + 2));
  }
  return broken;
}

results::Failure failure_of(const std::string& what, const std::string& replay) {
  results::Failure failure;
  // The answer, and the lines of the input behind it.
  std::size_t end = what.find("; ");
  failure.got = what.substr(0, end);
  while (end != what.npos) {
    const std::size_t begin = end + 2;
    end = what.find("; ", begin);
    failure.input.push_back(what.substr(begin, end == what.npos ? end : end - begin));
  }
  failure.expected = "what the promise says";
  failure.replay = replay;
  return failure;
}

// In 2019, functions have other names where an adapter says so.
std::string name_in(const Adapter& adapter, Generation generation) {
  const bool is_old = generation == Generation::of_2019;
  return is_old ? adapter.functions.back() : adapter.functions.front();
}

}  // namespace

Dialect no_dialect(const fs::path& texts, const Course& course) {
  Dialect dialect{"the contracts of pt/tasks/, and none of the course"};
  for (const auto& [slug, adapter] : read_texts(texts).tasks)
    dialect.functions[slug] = name_in(adapter, course.generation);
  return dialect;
}

Dialect load_dialect(const fs::path& texts, const Course& course) {
  const fs::path path = texts / "dialects" / fmt::format("{}.json", first_year(course.generation));
  const json all = base::parse_json(pt::read_file(path), path);
  Dialect dialect = no_dialect(texts, course);
  for (const auto& [slug, adapter] : read_texts(texts).tasks) {
    for (const AddedPromise& each : adapter.promises) {
      if (each.since <= year_of(course)) dialect.own[slug].push_back({each.name, each.words});
    }
    dialect.adapters[slug] = adapter;
  }
  try {
    dialect.name = all.at("name").get<std::string>();
    dialect.single_precision = all.contains("single_precision");
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

bool is_own(const Dialect& dialect, const std::string& slug, const std::string& promise) {
  const auto found = dialect.own.find(slug);
  return found != dialect.own.end() &&
         std::ranges::count(found->second, promise, &OwnPromise::name) > 0;
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
  if (const auto own = dialect.own.find(task.slug); own != dialect.own.end()) {
    for (const OwnPromise& each : own->second) {
      results::PromiseResult& promise = task.promises.emplace_back();
      promise.name = each.name;
      promise.words = each.words;
      promise.bonus = each.name.ends_with("_bonus");
    }
  }
  const auto name = dialect.functions.find(task.slug);
  if (name != dialect.functions.end()) task.called = name->second;
}

std::string without_notes(const std::string& printed) {
  std::string rest;
  for (const std::string& line : base::lines_of(printed)) {
    if (!line.starts_with(kNotKept)) rest += line + '\n';
  }
  return rest.find_first_not_of('\n') == rest.npos ? "" : rest;
}

void settle_own(const Dialect& dialect, const std::string& printed, const std::string& replay,
                results::TaskResult& task) {
  if (!dialect.adapters.contains(task.slug)) return;
  const std::map<std::string, std::string> broken = broken_in(printed);
  for (results::PromiseResult& promise : task.promises) {
    if (!is_own(dialect, task.slug, promise.name)) continue;
    const auto found = broken.find(promise.name);
    promise.held = found == broken.end();
    promise.checks = 1;
    if (!promise.held) promise.failures.push_back(failure_of(found->second, replay));
  }
  const bool is_right = std::ranges::all_of(
      task.promises, [](const auto& promise) { return promise.held || promise.bonus; });
  for (const auto& [name, sentence] : dialect.adapters.at(task.slug).named) {
    if (broken.contains(name) && !is_right)
      task.mistake = {name, sentence, results::kNamedOnly, "", false};
  }
}

void settle_cause(const Dialect& dialect, results::TaskResult& task) {
  const auto adapter = dialect.adapters.find(task.slug);
  if (adapter == dialect.adapters.end()) return;
  if (!adapter->second.causes.contains(task.mistake.name)) return;
  const bool explains = std::ranges::all_of(task.promises, [](const auto& promise) {
    return promise.held || promise.bonus ||
           std::ranges::count(promise.failures, results::Cause::wrong, &results::Failure::cause) ==
               0;
  });
  if (explains) task.mistake.found_by = results::kOneCause;
}

void works_only_together(const Dialect& dialect, const std::string& replay,
                         results::TaskResult& task) {
  std::string broken;
  for (results::PromiseResult& promise : task.promises) {
    if (promise.held || promise.bonus) continue;
    broken += (broken.empty() ? "" : ", ") + promise.words.substr(0, promise.words.find(':'));
    promise.held = true;
    promise.failures.clear();
  }
  for (results::PromiseResult& promise : task.promises) {
    if (!promise.bonus || !is_own(dialect, task.slug, promise.name)) continue;
    promise.held = false;
    promise.failures.push_back(
        failure_of("with a right one that is not yours, this fails: " + broken, replay));
  }
  task.mistake = {};
  task.state = results::state_of(task);
}

}  // namespace grader::door
