// The worker's answers (its main is in grader/service/wire/worker_main.cpp): times the task that is
// linked here, or measures the errors of its answers.
#include "grader/service/wire/serve.h"

#include "grader/service/wire/bytes.h"
#include "measure/calls/subject.h"
#include "measure/calls/tasks.h"
#include "pt/render/cpu_time.h"
#include "pt/todo.h"

#include <map>
#include <utility>

namespace measure::calls {
namespace {

constexpr double kWarmUp = 0.0005;  // seconds: longer passes need no warm-up

Subject make_subject(const std::string& slug, int of_case) {
#define FIRSTLIGHT_MAKE(name, CALL, DRAW) \
  if (slug == #name) return measure_##name(of_case);
  FIRSTLIGHT_TASKS(FIRSTLIGHT_MAKE, , )
#undef FIRSTLIGHT_MAKE
  throw grader::wire::BadMessage("there is no such task");
}

struct Ready {
  Subject subject;
  bool is_short = true;  // a pass is so short that other workers' caches slow it
};

Ready& ready(const Request& request) {
  static std::map<std::pair<std::uint32_t, std::uint32_t>, Ready> all;
  const auto key = std::pair(request.task, request.of_cases);
  const auto found = all.find(key);
  if (found != all.end()) return found->second;
  const std::string& slug = tasks().at(request.task).slug;
  return all[key] = {make_subject(slug, static_cast<int>(request.of_cases)), true};
}

double seconds_of(const Subject& subject, std::uint32_t passes) {
  const double start = pt::thread_cpu_seconds();
  for (std::uint32_t i = 0; i < passes; ++i) subject.pass();
  return pt::thread_cpu_seconds() - start;
}

// Other workers have used this processor since the last batch: a short pass first warms up its caches.
Timed time(Ready& ready, std::uint32_t passes) {
  if (ready.is_short) ready.is_short = seconds_of(ready.subject, 1) < kWarmUp;
  return {seconds_of(ready.subject, passes),
          std::uint64_t{passes} * static_cast<std::uint64_t>(ready.subject.calls)};
}

template <class Content>
std::string bytes_of(const Request& request, const Content& content) {
  const Reply<Content> reply{pt::todo_reached(tasks().at(request.task).slug) ? 1U : 0U, content};
  return {reinterpret_cast<const char*>(&reply), sizeof reply};
}

}  // namespace
}  // namespace measure::calls

namespace grader::wire {

std::string serve(std::string_view call) {
  using namespace measure::calls;
  Request request;
  std::memcpy(&request, Reader(call).raw(sizeof request).data(), sizeof request);
  Ready& subject = ready(request);
  if (request.what == What::time) return bytes_of(request, time(subject, request.passes));
  return bytes_of(request, subject.subject.find(request.seed));
}

}  // namespace grader::wire
