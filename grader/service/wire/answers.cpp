#include "grader/service/wire/session.h"
#include "grader/tasks.h"
#include "pt/error.h"

#include <algorithm>

namespace grader::wire {

// The judge answers a task's inner calls only if the task's properties are about them. A worker has
// to compute everything else itself: the judge computes nothing for a submission.
bool answers(std::string_view task, Function function) {
  const auto number = static_cast<std::size_t>(function);
  return number < kFunctionNames.size() &&
         std::ranges::count(task_of(task).judge_answers, kFunctionNames[number]) > 0;
}

namespace {

template <auto Pointer>
Writer answer_with(Reader& in, std::uint64_t code, const Session& session) {
  using Signature = SignatureOf<Pointer>;
  if (code != Signature::code()) throw BadMessage("it called the judge with other types");
  auto held = Signature::get(in, session);
  in.expect_end();
  Writer out;
  put(out, Signature::code());
  put(out, Signature::apply(Pointer, held));
  if constexpr (Signature::kDraws) put(out, Signature::sampler(held));
  return out;
}

}  // namespace

Writer answer(std::string_view task, std::string_view question, const Session& session) {
  Reader in(question);
  const auto head = get<AskHead>(in);
  const auto function = static_cast<Function>(head.function);
  if (!answers(task, function))
    throw BadMessage("it called a function that the judge does not answer");
  switch (function) {
    case Function::radiance:
      return answer_with<&pt::radiance>(in, head.code, session);
    case Function::hit_box:
      return answer_with<&pt::hit_box>(in, head.code, session);
    case Function::hit_triangle:
      return answer_with<&pt::hit_triangle>(in, head.code, session);
    case Function::hit_sphere:
      return answer_with<&pt::hit_sphere>(in, head.code, session);
    default:
      throw pt::Error("the task.json of a task says that the judge answers " +
                      std::string(kFunctionNames[head.function]) +
                      ", and grader/service/wire/answers.cpp has no case for it; write it there");
  }
}

}  // namespace grader::wire
