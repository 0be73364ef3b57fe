// The worker's end: the implementation `callback` of one task or slot, FIRSTLIGHT_TASK; compiled
// once for each. The call goes back to the judge, which answers with its counting versions
// (grader/check/mocks/counting.h), its mocks or its scripted radiance. Radiances that it has given in
// advance are answered here.
#include "grader/service/wire/connection.h"
#include "grader/service/wire/store.h"

namespace grader::wire {

template <auto Function, class... Arguments>
auto ask(Arguments&... arguments) {
  using Signature = SignatureOf<Function>;
  const auto question = [&] {
    Writer out;
    put(out, AskHead{static_cast<std::uint32_t>(kFunction<Function>), Signature::code()});
    Signature::put(out, store(), arguments...);
    return out;
  };
  if constexpr (kFunction<Function> == wire::Function::radiance) {
    pt::Sampler& sampler = std::get<sizeof...(Arguments) - 1>(std::tie(arguments...));
    if (wants_to_be_told()) tell(question().bytes());
    if (const auto ahead = next_ahead(sampler)) return *ahead;
  }
  send(Kind::ask, question().bytes());
  const std::string answer = receive(Kind::answer);
  Reader in(answer);
  if (get<std::uint64_t>(in) != Signature::code()) throw BadMessage("the judge means other types");
  auto result = get<typename Signature::Result>(in);
  if constexpr (Signature::kDraws) {
    std::get<sizeof...(Arguments) - 1>(std::tie(arguments...)) = get<pt::Sampler>(in);
  }
  return result;
}

}  // namespace grader::wire

// `names` comes with its parentheses: it is the argument list of the call.
// NOLINTBEGIN(bugprone-macro-parentheses)
#define FIRSTLIGHT_DEFINE(result, function, parameters, names) \
  result function parameters { return grader::wire::ask<&pt::function> names; }
// NOLINTEND(bugprone-macro-parentheses)

namespace pt {

FIRSTLIGHT_CALLS_OF(FIRSTLIGHT_TASK)(FIRSTLIGHT_DEFINE, FIRSTLIGHT_DEFINE)

}  // namespace pt
