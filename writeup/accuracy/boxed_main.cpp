// accuracy_boxed cheapest | converge SCENE --submission DIR: the same of a submission, without running a
// line of it here. Exit status 1 says that the submission cannot be measured.
#include "grader/process/spawn.h"
#include "pt/end_of_program.h"
#include "writeup/accuracy/begin.h"
#include "writeup/accuracy/pixels_boxed.h"

#include <csignal>
#include <cstdio>

int main(int argc, char** argv) {
  using namespace writeup::accuracy;
  grader::process::hide_process();
  std::signal(SIGPIPE, SIG_IGN);
  try {
    Call call = parse_call(argc, argv);
    Options& options = call.options;
    const writeup::Boxed boxed = options.built.empty()
                                     ? writeup::build_submission(options.submission)
                                     : writeup::read_boxed(options.built);
    open_boxed(boxed, options.engine);
    options.built = boxed.worker;
    options.threads = 1;  // there is one worker
    if (!options.keep.empty()) say_when_stopped();
    run_call(call);
    pt::flush_standard_output();
  } catch (const writeup::SubmissionFailed& error) {
    std::fprintf(stderr, "the submission cannot be measured: %s\n", pt::sentence_of(error).c_str());
    return 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", pt::sentence_of(error).c_str());
    return 2;
  }
}
