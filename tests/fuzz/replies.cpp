// Messages of a worker: its replies to calls of each function, and its own calls back. The first
// byte chooses the function, and a reply or a call.
#include "grader/check/language/fail.h"
#include "grader/check/mocks/scripted_radiance.h"
#include "grader/service/wire/finite.h"
#include "grader/service/wire/session.h"
#include "grader/tasks/build_bvh/walk.h"
#include "tests/fuzz/input.h"

namespace grader::wire {
namespace {

// Looks at a result as the judge does. Rows of a picture have their own test (grader/pictures).
template <class Result>
void look_at(const Result& result) {
  if constexpr (!std::is_same_v<Result, pt::PictureRows>) has_valid_numbers(result);
}

// Reads a reply like call() of grader/service/wire/call.h and Session::take_head.
template <auto Function>
void read_reply(std::string_view bytes) {
  using Signature = SignatureOf<Function>;
  Reader in(bytes);
  const auto head = get<ReplyHead>(in);
  has_valid_numbers(head.tests.boxes);
  const auto result = get<typename Signature::Result>(in);
  if constexpr (Signature::kDraws) get<pt::Sampler>(in);
  in.expect_end();
  look_at(result);
  if constexpr (std::is_same_v<std::decay_t<decltype(result)>, pt::Bvh>) {
    check::build_bvh_inputs::walk_from_root(result);
  }
}

template <auto Function>
void read_replies(std::string_view bytes) {
  Reader in(bytes);
  get<ReplyHead>(in);
  using Result = typename SignatureOf<Function>::Result;
  for (const auto& each : get<std::vector<Result>>(in)) look_at(static_cast<const Result&>(each));
  in.expect_end();
}

void read_reply_of(int function, std::string_view bytes) {
  int number = 0;
#define FIRSTLIGHT_READ(result, function_, parameters, names)  \
  if (number++ == function) read_reply<&pt::function_>(bytes); \
  if (number++ == function) read_replies<&pt::function_>(bytes);
  FIRSTLIGHT_TASKS(FIRSTLIGHT_ROWS, FIRSTLIGHT_READ, FIRSTLIGHT_READ)
  FIRSTLIGHT_CALLS_render_rows(FIRSTLIGHT_READ, FIRSTLIGHT_READ)
}

// Puts correct type codes into the message, because every question would be refused without them.
void answer_question(int which, std::string_view bytes) {
  static const pt::Scene scene;
  Session session({});
  session.begin();
  const Handle handle = session.name(scene);
  Writer out;
  const auto ask = [&](Function function, std::uint64_t code) {
    put(out, AskHead{static_cast<std::uint32_t>(function), code});
  };
  if (which == 0) ask(Function::hit_box, SignatureOf<&pt::hit_box>::code());
  if (which == 1) ask(Function::hit_triangle, SignatureOf<&pt::hit_triangle>::code());
  if (which == 2) ask(Function::hit_sphere, SignatureOf<&pt::hit_sphere>::code());
  if (which == 3) ask(Function::radiance, SignatureOf<&pt::radiance>::code());
  if (which == 3 && bytes.size() % 2 == 1) put(out, handle);
  out.raw(bytes.data(), bytes.size());
  check::script_radiance([](int, const pt::Ray&) { return pt::Rgb{1, 1, 1}; });
  answer(which == 3 ? "estimate_pixel" : "hit_bvh", out.bytes(), session);
}

}  // namespace
}  // namespace grader::wire

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  if (size == 0) return 0;
  const std::string_view rest = fuzz::as_text(bytes + 1, size - 1);
  try {
    if (bytes[0] < 128) {
      grader::wire::read_reply_of(bytes[0], rest);
    } else {
      grader::wire::answer_question(bytes[0] % 8, rest);
    }
  } catch (const grader::wire::BadMessage& bad) {
    fuzz::expect_sentence(bad.what());
  } catch (const grader::check::CaseFailed&) {
  }
  return 0;
}
