// Compares the table of tasks (grader/tasks/<slug>/task.json) with the contracts and the compiled
// reference: the functions that it defines, the tasks that it calls, and whether it traces rays.
#include "grader/tasks.h"

#include "grader/calls.h"
#include "grader/service/audit/object_file.h"
#include "pt/error.h"
#include "pt/file.h"
#include "pt/render/choose_engine.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <memory>
#include <set>
#include <sstream>
#include <utility>

#include <cxxabi.h>
#include <elf.h>
#include <fmt/format.h>
#include <gtest/gtest.h>

namespace grader::tests {
namespace {

namespace fs = std::filesystem;
using Names = std::set<std::string>;

// Returns "pt::hit_box" for "pt::hit_box(pt::Box const&, pt::Ray const&)".
std::string name_of(const std::string& symbol) {
  int status = 0;
  const std::unique_ptr<char, decltype(&std::free)> text(
      abi::__cxa_demangle(symbol.c_str(), nullptr, nullptr, &status), &std::free);
  return text ? std::string(text.get()).substr(0, std::string(text.get()).find('(')) : symbol;
}

// The functions in the reference's object of a task, without "pt::". `symbols` are the defined
// functions under the linker's names.
struct Object {
  Names defined, called, symbols;
};

Object object_of(const Task& task) {
  std::ifstream paths(FIRSTLIGHT_OBJECTS "/" + task.slug + ".contract");
  Object object;
  for (std::string path; std::getline(paths, path);) {
    for (const audit::ObjectSymbol& symbol : audit::read_object(pt::read_file(path)).symbols) {
      const std::string name = name_of(symbol.name);
      // A function that is defined in a header does not belong to the task.
      if (!name.starts_with("pt::") || symbol.in_group) continue;
      (symbol.section == SHN_UNDEF ? object.called : object.defined).insert(name.substr(4));
      if (symbol.section != SHN_UNDEF) object.symbols.insert(symbol.name);
    }
  }
  return object;
}

std::map<std::string, std::string> tasks_by_function() {
  std::map<std::string, std::string> all;
  for (const Task& task : tasks()) {
    for (const std::string& function : task.functions) all[function] = task.slug;
  }
  return all;
}

Names called_tasks(const Object& object) {
  static const auto by_function = tasks_by_function();
  Names called;
  for (const std::string& name : object.called) {
    const auto found = by_function.find(name);
    if (found != by_function.end()) called.insert(found->second);
  }
  return called;
}

bool traces(const Object& object) {
  return object.called.contains("Scene::closest") || object.called.contains("Scene::occluded");
}

TEST(tasks, define_the_functions_of_the_table) {
  for (const Task& task : tasks()) {
    EXPECT_EQ(object_of(task).defined, Names(task.functions.begin(), task.functions.end()))
        << task.slug;
  }
}

TEST(tasks, call_the_tasks_of_the_table) {
  for (const Task& task : tasks()) {
    const Object object = object_of(task);
    EXPECT_EQ(called_tasks(object), Names(task.calls.begin(), task.calls.end())) << task.slug;
    EXPECT_EQ(traces(object), task.traces) << task.slug;
    EXPECT_EQ(object.called.contains("radiance"),
              std::ranges::count(task.judge_answers, "radiance") > 0)
        << task.slug;
  }
}

// The tasks whose contracts the scene tracer includes: it calls these.
Names tracers() {
  Names all;
  std::istringstream lines(pt::read_file(FIRSTLIGHT_ROOT "/pt/scene/tracer.cpp"));
  const std::string before = "#include \"pt/tasks/";
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with(before))
      all.insert(line.substr(before.size(), line.find(".h\"") - before.size()));
  }
  return all;
}

// Follows the calls of the objects from task to task.
TEST(tasks, need_what_their_calls_reach) {
  for (const Task& task : tasks()) {
    Names reached, next{task.slug};
    while (!next.empty()) {
      const std::string slug = *next.begin();
      next.erase(next.begin());
      const Object object = object_of(task_of(slug));
      Names calls = called_tasks(object);
      if (traces(object)) calls.merge(tracers());
      for (const std::string& call : calls) {
        if (reached.insert(call).second) next.insert(call);
      }
    }
    const std::vector<std::string>& needed = needs(task.slug);
    EXPECT_EQ(Names(needed.begin(), needed.end()), reached) << task.slug;
  }
}

// A scene is traced by the tree and its shapes: parts 1 and 2 without the camera and the pixel.
TEST(tasks, trace_what_the_tree_and_the_shapes_are) {
  EXPECT_EQ(tracing_tasks(), (std::vector<std::string>{"hit_triangle", "hit_sphere", "build_bvh",
                                                       "hit_box", "hit_bvh"}));
  std::vector<std::string> tree;
  for (const Task& task : tasks()) {
    if (task.part == task_of("build_bvh").part) tree.push_back(task.slug);
  }
  EXPECT_EQ(std::vector<std::string>(pt::kTreeTasks.begin(), pt::kTreeTasks.end()), tree)
      << "pt/render/choose_engine.h";
}

// firstlight_symbol in cmake/tasks.cmake puts these names together: "hit_box=_ZN2pt7hit_boxE...".
TEST(tasks, have_the_names_that_the_linker_is_told) {
  std::istringstream words(FIRSTLIGHT_SYMBOLS);
  int count = 0;
  for (std::string word; words >> word; ++count) {
    const std::size_t end = word.find('=');
    const std::string slug = word.substr(0, end);
    EXPECT_TRUE(object_of(task_of(slug)).symbols.contains(word.substr(end + 1))) << word;
  }
  EXPECT_GT(count, 0);
}

// grader/service/wire/answers.cpp is written by hand, since few calls are answered.
TEST(tasks, are_answered_where_the_table_says) {
  const std::string answers = pt::read_file(FIRSTLIGHT_ROOT "/grader/service/wire/answers.cpp");
  int count = 0;
  for (const Task& task : tasks()) {
    for (const std::string& call : task.judge_answers) {
      EXPECT_NE(answers.find(fmt::format("case Function::{}:\n      return answer_with<&pt::{}>(",
                                         call, call)),
                std::string::npos)
          << call;
      ++count;
    }
  }
  EXPECT_GT(count, 0);
}

TEST(tasks, are_answered_only_where_they_are_called) {
  for (const Task& task : tasks()) {
    Names answered(task.judge_answers.begin(), task.judge_answers.end());
    answered.insert(task.mocks.begin(), task.mocks.end());
    answered.erase("radiance");
    for (const std::string& slug : answered) {
      EXPECT_GT(std::ranges::count(task.calls, slug), 0) << task.slug << " " << slug;
    }
  }
}

TEST(tasks, stand_in_the_same_order_in_the_calls) {
  std::vector<std::string> slugs, functions;
  for (const Task& task : tasks()) {
    slugs.push_back(task.slug);
    functions.insert(functions.end(), task.functions.begin(), task.functions.end());
  }
  functions.insert(functions.end(), {"radiance", "render_rows"});
  EXPECT_EQ(std::vector<std::string>(wire::kTasks.begin(), wire::kTasks.end()), slugs);
  EXPECT_EQ(std::vector<std::string>(wire::kFunctionNames.begin(), wire::kFunctionNames.end()),
            functions);
}

TEST(tasks, are_found_by_their_slugs_only) {
  EXPECT_EQ(task_of("hit_triangle").number, "1.3");
  EXPECT_EQ(task_of("adaptive_pixel").file(), "5_adaptive/adaptive_pixel.cpp");
  EXPECT_THROW(task_of("hit_everything"), pt::Error);
  EXPECT_TRUE(needs("hit_everything").empty());
}

// Returns the words of a contract's paragraph "May call: ...", or none without this paragraph.
Names promised_calls(const std::string& slug) {
  const std::string text = pt::read_file(fmt::format("{}/pt/tasks/{}.h", FIRSTLIGHT_ROOT, slug));
  constexpr std::string_view kBegin = "// May call:";
  const std::size_t at = text.find(kBegin);
  if (at == std::string::npos) return {};
  std::size_t end = text.find('\n', at);
  while (text.compare(end + 1, 3, "// ") == 0) end = text.find('\n', end + 1);
  Names words;
  std::string word;
  for (const char c : text.substr(at + kBegin.size(), end - at)) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_') {
      word += c;
    } else {
      words.insert(std::exchange(word, ""));
    }
  }
  return words;
}

TEST(tasks, may_call_what_their_contracts_say) {
  Names slugs;
  for (const auto& entry : fs::directory_iterator(FIRSTLIGHT_ROOT "/pt/tasks")) {
    slugs.insert(entry.path().stem());
  }
  for (const std::string& slug : slugs) {
    const Names words = promised_calls(slug);
    EXPECT_TRUE(words.contains("Threads")) << slug << " does not say what it may call";
    const Task& task = task_of(slug);
    Names named;
    std::ranges::set_intersection(words, slugs, std::inserter(named, named.end()));
    named.erase(slug);
    EXPECT_EQ(named, Names(task.calls.begin(), task.calls.end()))
        << "pt/tasks/" << slug << ".h and its task.json";
    for (const std::string& function : task.framework) {
      const std::string name = function.substr(function.rfind(':') + 1);
      EXPECT_TRUE(words.contains(name)) << slug << ": " << name;
    }
  }
}

TEST(tasks, are_those_that_have_a_contract) {
  for (const auto& entry : fs::directory_iterator(FIRSTLIGHT_ROOT "/pt/tasks")) {
    EXPECT_EQ(task_of(entry.path().stem().string()).slug, entry.path().stem());
  }
  EXPECT_THROW(task_of("hit_everything"), pt::Error);
}

}  // namespace
}  // namespace grader::tests
