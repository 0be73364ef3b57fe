#pragma once

#include "grader/task_calls.h"
#include "pt/render/radiance.h"
#include "pt/render/render_rows.h"

#include <array>
#include <cstdint>
#include <string_view>

// The one table of what crosses the border between judge and worker. The build makes the part of the tasks from their
// contracts, FIRSTLIGHT_CALLS_<slug> and FIRSTLIGHT_TASKS (cmake/tasks.cmake). CALL is a pure function, DRAW one that also takes
// a Sampler& (last), so that it can be repeated.
//   (result, function, (parameters), (their names))

// Not a task, but two tasks call it.
#define FIRSTLIGHT_CALLS_radiance(CALL, DRAW)                                                \
  DRAW(Rgb, radiance,                                                                        \
       (const Scene& scene, const Ray& ray, const PathSettings& settings, Sampler& sampler), \
       (scene, ray, settings, sampler))

// Not a task either: the pictures that the judge looks at.
#define FIRSTLIGHT_CALLS_render_rows(CALL, DRAW) \
  CALL(PictureRows, render_rows, (const View& view, const RowsRequest& request), (view, request))

// The rows of one task whose slug is itself a macro.
#define FIRSTLIGHT_JOIN(a, b) a##b
#define FIRSTLIGHT_CALLS_OF(slug) FIRSTLIGHT_JOIN(FIRSTLIGHT_CALLS_, slug)

// All rows.
#define FIRSTLIGHT_ROWS(slug, CALL, DRAW) FIRSTLIGHT_CALLS_OF(slug)(CALL, DRAW)
#define FIRSTLIGHT_CALLS(CALL, DRAW)            \
  FIRSTLIGHT_TASKS(FIRSTLIGHT_ROWS, CALL, DRAW) \
  FIRSTLIGHT_CALLS_radiance(CALL, DRAW) FIRSTLIGHT_CALLS_render_rows(CALL, DRAW)

// For the body of a file that defines Repeated (grader/check/language/repeat.h): makes it for one task.
#define FIRSTLIGHT_NO_ROW(result, function, parameters, names)
#define FIRSTLIGHT_REPEATED_ROW(result, function, parameters, names) \
  template struct grader::check::Repeated<&pt::function>;
#define FIRSTLIGHT_REPEATED(slug) \
  FIRSTLIGHT_CALLS_OF(slug)(FIRSTLIGHT_NO_ROW, FIRSTLIGHT_REPEATED_ROW)

namespace grader::wire {

#define FIRSTLIGHT_NAME(result, function, parameters, names) function,
enum class Function : std::uint32_t { FIRSTLIGHT_CALLS(FIRSTLIGHT_NAME, FIRSTLIGHT_NAME) };
#undef FIRSTLIGHT_NAME

#define FIRSTLIGHT_NAME(result, function, parameters, names) #function,
inline constexpr std::array kFunctionNames{FIRSTLIGHT_CALLS(FIRSTLIGHT_NAME, FIRSTLIGHT_NAME)};
#undef FIRSTLIGHT_NAME

#define FIRSTLIGHT_NAME(slug, CALL, DRAW) std::string_view(#slug),
inline constexpr std::array kTasks{FIRSTLIGHT_TASKS(FIRSTLIGHT_NAME, , )};
#undef FIRSTLIGHT_NAME

// The number of a function: kFunction<&pt::hit_box> is Function::hit_box.
template <auto Pointer>
inline constexpr Function kFunction{};
#define FIRSTLIGHT_NAME(result, function, parameters, names) \
  template <>                                                \
  inline constexpr Function kFunction<&pt::function> = Function::function;
FIRSTLIGHT_CALLS(FIRSTLIGHT_NAME, FIRSTLIGHT_NAME)
#undef FIRSTLIGHT_NAME

}  // namespace grader::wire
