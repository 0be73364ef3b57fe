// accuracy_boxed cheapest | converge SCENE --submission DIR: the same for a submission, without
// running its code in this process. The exit status is 1 if the submission cannot be measured.
#include "grader/service/process/spawn.h"
#include "measure/renders/boxed.h"
#include "measure/renders/spec.h"
#include "measure/scene/begin.h"
#include "measure/scene/pixels.h"
#include "pt/end_of_program.h"
#include "pt/scene/tracer.h"

#include <chrono>
#include <csignal>
#include <cstdio>

namespace measure::scene {

namespace {

constexpr std::chrono::seconds kCallLimit{20};  // of processor time; a call takes about kQuick

// From now on this submission renders the pixels. Throws SubmissionFailed if a task that all pixels
// need does not compile.
void open_boxed(const Boxed& boxed, pt::Engine engine) {
  Spec needed;
  needed.engine = engine;
  needed.path.to = 1;
  for (const std::string& task : tasks_used(needed)) {
    const auto found = boxed.unusable.find(task);
    if (found != boxed.unusable.end()) throw SubmissionFailed(task + " " + found->second);
  }
  open_worker(boxed, kCallLimit);
}

}  // namespace

}  // namespace measure::scene

int main(int argc, char** argv) {
  using namespace measure::scene;
  grader::process::hide_process();
  std::signal(SIGPIPE, SIG_IGN);
  return pt::run_program([&] {
    const auto is_not_measured = [](const pt::Error& error) {
      std::fprintf(stderr, "the submission cannot be measured: %s\n",
                   pt::sentence_of(error).c_str());
      return 1;
    };
    try {
      Call call = parse_call(argc, argv);
      Options& options = call.options;
      open_boxed(options.built.empty() ? measure::build_submission(options.submission)
                                       : measure::read_boxed(options.built),
                 options.engine);
      options.threads = 1;  // there is one worker
      return run_call(call);
    } catch (const measure::SubmissionFailed& error) {
      return is_not_measured(error);
    } catch (const NotApart& error) {
      return is_not_measured(error);
    }
  });
}
