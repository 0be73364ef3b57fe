#include "grader/service/judging/so_far.h"

namespace grader::judging {

namespace {

// The state before any verdict: results so far may still change.
results::TaskResult without_verdict(const Judged& judged) {
  results::TaskResult result;
  result.part = judged.result.part;
  result.number = judged.result.number;
  result.slug = judged.result.slug;
  if (judged.right_alone) result.reason = "right by itself; not judged with your other tasks yet";
  result.promises = judged.result.promises;
  for (results::PromiseResult& promise : result.promises) {
    promise.held = false;
    promise.failures.clear();
  }
  result.pictures = judged.result.pictures;
  return result;
}

}  // namespace

results::TaskResult so_far(const Judged& judged) {
  if (!judged.settled) return without_verdict(judged);
  results::TaskResult result = judged.result;
  if (result.state != results::State::pass && result.state != results::State::blocked)
    return result;
  for (const results::State state :
       {results::State::crash, results::State::timeout, results::State::fail,
        results::State::too_noisy, results::State::not_judged}) {
    for (const results::PictureResult& picture : result.pictures) {
      if (picture.state != state) continue;
      result.state = state;
      return result;
    }
  }
  return result;
}

results::TaskResult without_folder(results::TaskResult result, const std::string& folder) {
  const std::string path = folder + '/';
  const auto hide = [&](std::string& text) {
    for (std::size_t at = 0; (at = text.find(path, at)) != text.npos;) text.erase(at, path.size());
  };
  for (std::string* text :
       {&result.reason, &result.printed, &result.compiler_output, &result.warnings})
    hide(*text);
  for (results::PromiseResult& promise : result.promises) {
    for (results::Failure& failure : promise.failures) {
      for (std::string* text : {&failure.what, &failure.got, &failure.expected}) hide(*text);
    }
  }
  for (results::PictureResult& picture : result.pictures) hide(picture.text);
  return result;
}

}  // namespace grader::judging
