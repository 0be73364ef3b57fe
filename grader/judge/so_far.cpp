#include "grader/judge/so_far.h"

namespace grader {

namespace {

// As before anything was judged: what is known by now may still turn out otherwise.
TaskResult without_verdict(const Judged& judged) {
  TaskResult result;
  result.part = judged.result.part;
  result.number = judged.result.number;
  result.slug = judged.result.slug;
  if (judged.right_alone) result.reason = "right by itself; not judged with your other tasks yet";
  result.promises = judged.result.promises;
  for (PromiseResult& promise : result.promises) {
    promise.held = false;
    promise.failures.clear();
  }
  result.pictures = judged.result.pictures;
  return result;
}

}  // namespace

TaskResult so_far(const Judged& judged) {
  if (!judged.settled) return without_verdict(judged);
  TaskResult result = judged.result;
  if (result.state != State::pass && result.state != State::blocked) return result;
  for (const State state :
       {State::crash, State::timeout, State::fail, State::too_noisy, State::not_judged}) {
    for (const PictureResult& picture : result.pictures) {
      if (picture.state != state) continue;
      result.state = state;
      return result;
    }
  }
  return result;
}

}  // namespace grader
