// accuracy_boxed cheapest | converge SCENE --submission DIR: the same for a submission, without
// running its code in this process. The exit status is 1 if the submission cannot be measured.
#include "grader/service/process/spawn.h"
#include "measure/scene/begin.h"
#include "measure/scene/pixels_boxed.h"
#include "pt/end_of_program.h"

#include <csignal>
#include <cstdio>

int main(int argc, char** argv) {
  using namespace measure::scene;
  grader::process::hide_process();
  std::signal(SIGPIPE, SIG_IGN);
  return pt::run_program([&] {
    try {
      Call call = parse_call(argc, argv);
      Options& options = call.options;
      open_boxed(options.built.empty() ? measure::build_submission(options.submission)
                                       : measure::read_boxed(options.built),
                 options.engine);
      options.threads = 1;  // there is one worker
      run_call(call);
      return 0;
    } catch (const measure::SubmissionFailed& error) {
      std::fprintf(stderr, "the submission cannot be measured: %s\n",
                   pt::sentence_of(error).c_str());
      return 1;
    }
  });
}
