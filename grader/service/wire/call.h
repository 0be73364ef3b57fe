#pragma once

#include "grader/check/language/repeat.h"
#include "grader/service/wire/finite.h"
#include "grader/service/wire/record.h"
#include "grader/service/wire/session.h"

// The judge's end: the implementation `remote` of a contract's function, which calls the worker.

namespace grader::wire {

// Reads the value at the front of a reply. A malformed value is a failed case.
template <class Value, class Read>
Value read_reply(std::string_view bytes, const Read& read) {
  try {
    Reader in(bytes);
    Value value = read(in);
    in.expect_end();
    return value;
  } catch (const BadMessage& bad) {
    session().reject(bad.what());
  }
}

template <class Result>
const Result& expect_numbers(const Result& result) {
  if (const MaybeBad bad = bad_number(result)) {
    const std::string which = bad->member.empty() ? "that" : "in which " + bad->member;
    check::fail_call(
        results::Cause::bad_reply,
        "an answer " + which + (std::isnan(bad->value) ? " is not a number" : " is infinite"));
  }
  return result;
}

template <auto Function, class... Arguments>
auto call(Arguments&... arguments) {
  using Signature = SignatureOf<Function>;
  using Result = typename Signature::Result;
  Writer out;
  session().begin();
  Signature::put(out, session(), arguments...);
  const std::string_view reply =
      session().call(kFunction<Function>, Signature::code(), CallBatch{}, out);
  if constexpr (Signature::kDraws) {
    auto [result, state] = read_reply<std::pair<Result, pt::Sampler>>(reply, [](Reader& in) {
      Result value = get<Result>(in);
      return std::pair(std::move(value), get<pt::Sampler>(in));
    });
    std::get<sizeof...(Arguments) - 1>(std::tie(arguments...)) = state;
    return expect_numbers(result);
  } else {
    return expect_numbers(read_reply<Result>(reply, get<Result>));
  }
}

// Makes n calls of a function that draws random numbers. `arguments` are all arguments except the
// sampler. One message contains a batch of calls. The worker replies one Each per call: the result, or the record too.
template <auto Task, class Each, class Arguments>
std::vector<Each> call_repeatedly(int n, std::uint64_t seed, const Arguments& arguments) {
  using Signature = SignatureOf<Task>;
  std::vector<Each> results;
  for (int first = 0; first < n; first += kBatch) {
    const CallBatch batch{first, std::min(kBatch, n - first), seed};
    Writer out;
    session().begin();
    std::apply(
        [&](const auto&... each) {
          Signature::put(out, session(), each..., pt::Sampler::for_pixel(seed, first, 0));
        },
        arguments);
    const std::string_view reply = session().call(kFunction<Task>, Signature::code(), batch, out,
                                                  std::is_same_v<Each, explain::Told>);
    auto some = read_reply<std::vector<Each>>(reply, get<std::vector<Each>>);
    if (static_cast<int>(some.size()) != batch.count) session().reject("the number of results");
    for (Each& each : some) {
      expect_numbers(each);
      results.push_back(std::move(each));
    }
  }
  return results;
}

}  // namespace grader::wire

namespace grader::check {

template <auto Task, class Result, class... Parameters>
std::vector<Result> Repeated<Task, Result (*)(Parameters...)>::run(int n, std::uint64_t seed,
                                                                   const Arguments& arguments) {
  return wire::call_repeatedly<Task, Result>(n, seed, arguments);
}

template <auto Task, class Result, class... Parameters>
std::vector<explain::Told> Repeated<Task, Result (*)(Parameters...)>::run_recorded(
    int n, std::uint64_t seed, const Arguments& arguments) {
  if constexpr (kIsRecorded) {
    if (!wire::session().can_record()) return {};
    auto all = wire::call_repeatedly<Task, explain::Told>(n, seed, arguments);
    // The judge knows with which sampler each call began.
    for (int i = 0; i < n; ++i) all[i].before = pt::Sampler::for_pixel(seed, i, 0).state();
    return all;
  }
  return {};
}

}  // namespace grader::check
