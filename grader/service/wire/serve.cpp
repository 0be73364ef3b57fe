#include "grader/service/wire/serve.h"

#include "grader/service/wire/connection.h"
#include "grader/service/wire/kept_state.h"
#include "grader/service/wire/record.h"
#include "grader/service/wire/store.h"
#include "pt/scene/recorder.h"
#include "pt/todo.h"

#include <cerrno>
#include <ctime>
#include <optional>
#include <utility>

namespace grader::wire {

namespace {

pt::Tested tests;
std::uint64_t kept = 0;  // of all calls so far

// Calls the task, or the function in the slot, and notes whether the task keeps state of the call. errno is the same before each
// call, so it keeps nothing.
template <class Signature, class Function, class Held>
auto apply(Function function, Held& held) {
  static const unsigned mode = processor_mode();
  errno = 0;
  auto result = Signature::apply(function, held);
  if (kept == 0) kept = processor_mode() == mode ? kept_state() : kProcessorMode;
  return result;
}

// Milliseconds, from a clock that moves a few of them at a time: reading it is much faster than a short
// call, and reading the usual clock is not.
std::int64_t coarse_time() {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC_COARSE, &now);
  return std::int64_t{now.tv_sec} * 1000 + now.tv_nsec / 1'000'000;
}

// Tells the judge that a call of a batch has ended, often enough for the limit of any call.
void tell_that_it_goes_on() {
  static std::int64_t told = coarse_time();
  const std::int64_t now = coarse_time();
  if (now - told < 20) return;
  told = now;
  send(Kind::going_on, {});
}

// Writes the results and records of a batch of calls. The task's first argument is the scene.
template <auto Pointer, class Held>
void run_recorded(Held& held, const CallBatch& batch, Writer& results) {
  using Signature = SignatureOf<Pointer>;
  constexpr bool kInScene = std::is_same_v<std::tuple_element_t<0, Held>, const pt::Scene*> &&
                            std::is_same_v<typename Signature::Result, pt::Rgb>;
  if constexpr (kInScene) {
    std::vector<explain::Told> all;
    for (int i = batch.first; i < batch.first + batch.count; ++i) {
      all.push_back(
          explain::record_one(*std::get<0>(held), batch.seed, i, [&](pt::Sampler& sampler) {
            Signature::sampler(held) = sampler;
            const pt::Rgb result = apply<Signature>(Pointer, held);
            sampler = Signature::sampler(held);
            return result;
          }));
      tell_that_it_goes_on();
    }
    put(results, all);
  } else {
    throw BadMessage("the calls of this function are not recorded");
  }
}

// Writes the answer of a call, and makes so many more of the same call, up to one that has another answer.
template <auto Pointer, class Held>
void run_alike(Held& held, int others, Writer& results) {
  using Signature = SignatureOf<Pointer>;
  std::optional<pt::Sampler> start;
  if constexpr (Signature::kDraws) start = Signature::sampler(held);
  const auto answer = [&] {
    Writer out;
    put(out, apply<Signature>(Pointer, held));
    if constexpr (Signature::kDraws) put(out, std::exchange(Signature::sampler(held), *start));
    return out;
  };
  results = answer();
  for (int i = 0; i < others; ++i) {
    begin_again();
    Writer again = answer();
    tell_that_it_goes_on();
    if (again.bytes() == results.bytes()) continue;
    results = std::move(again);
    return;
  }
}

// Writes the results of a call or of a batch of calls, after the head.
template <auto Pointer>
void run(Reader& in, const CallHead& head, Writer& results) {
  using Signature = SignatureOf<Pointer>;
  if (head.code != Signature::code()) throw BadMessage("the judge means other types");
  auto held = Signature::get(in, store());
  in.expect_end();
  if (head.batch.count == 0) return run_alike<Pointer>(held, head.others, results);
  if constexpr (Signature::kDraws) {
    const auto [first, count, seed] = head.batch;
    if (head.records) return run_recorded<Pointer>(held, head.batch, results);
    std::vector<typename Signature::Result> all;
    for (int i = first; i < first + count; ++i) {
      Signature::sampler(held) = pt::Sampler::for_pixel(seed, i, 0);
      all.push_back(apply<Signature>(Pointer, held));
      tell_that_it_goes_on();
    }
    put(results, all);
  } else {
    throw BadMessage("a function that draws nothing is not repeated");
  }
}

using Handler = void (*)(Reader&, const CallHead&, Writer&);
#define FIRSTLIGHT_HANDLER(result, function, parameters, names) run<&pt::function>,
constexpr std::array<Handler, kFunctionNames.size()> kHandlers{
    FIRSTLIGHT_CALLS(FIRSTLIGHT_HANDLER, FIRSTLIGHT_HANDLER)};
#undef FIRSTLIGHT_HANDLER

std::uint32_t tasks_to_do() {
  std::uint32_t bits = 0;
  for (std::size_t i = 0; i < kTasks.size(); ++i) {
    if (pt::todo_reached(kTasks[i])) bits |= std::uint32_t{1} << i;
  }
  return bits;
}

}  // namespace

std::string serve(std::string_view call) {
  Reader in(call);
  const auto head = get<CallHead>(in);
  if (head.function >= kHandlers.size()) throw BadMessage("there is no such function");
  for (std::uint64_t i = 0; i < head.definitions; ++i) store().define(get<Definition>(in));

  const auto function = static_cast<Function>(head.function);
  if (function == Function::hit_bvh || function == Function::occluded_bvh) {
    pt::recorder.tested = &tests;
  }
  tests = {};
  begin_with(head.ahead);
  Writer results;
  const pt::RayCount before = pt::rays_traced();
  kHandlers[head.function](in, head, results);
  const pt::RayCount after = pt::rays_traced();
  pt::recorder.tested = nullptr;

  Writer out;
  put(out, ReplyHead{head.code, tasks_to_do(), after.closest - before.closest,
                     after.occluded - before.occluded, kept, tests});
  out.raw(results.bytes().data(), results.bytes().size());
  return std::string(out.bytes());
}

}  // namespace grader::wire
