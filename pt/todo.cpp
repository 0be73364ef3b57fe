#include "pt/todo.h"

#include "pt/todo_list.h"

#include <cstdio>
#include <functional>
#include <mutex>
#include <set>
#include <string>

namespace pt {

namespace {

struct Reached {
  std::mutex mutex;
  std::set<std::string, std::less<>> slugs;
  bool print = true;
};

Reached& reached() {
  static Reached instance;
  return instance;
}

}  // namespace

void todo(std::string_view slug) {
  // Stubs are called once per ray, so a thread uses the lock only the first time.
  thread_local std::set<std::string, std::less<>> known;
  if (known.contains(slug)) return;
  known.emplace(slug);
  const std::lock_guard lock(reached().mutex);
  if (reached().slugs.emplace(slug).second && reached().print) {
    std::fprintf(stderr, "%.*s is not written yet\n", static_cast<int>(slug.size()), slug.data());
  }
}

void silence_todo() {
  const std::lock_guard lock(reached().mutex);
  reached().print = false;
}

bool todo_reached(std::string_view slug) {
  const std::lock_guard lock(reached().mutex);
  return reached().slugs.contains(slug);
}

std::vector<std::string> todo_list() {
  const std::lock_guard lock(reached().mutex);
  return {reached().slugs.begin(), reached().slugs.end()};
}

}  // namespace pt
