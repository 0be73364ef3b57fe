// accuracy cheapest | converge SCENE: the needs of a scene, and the worth of methods in it, measured with
// the tasks linked here.
#include "pt/end_of_program.h"
#include "pt/error.h"
#include "writeup/accuracy/begin.h"

#include <cstdio>

int main(int argc, char** argv) {
  using namespace writeup::accuracy;
  try {
    const Call call = parse_call(argc, argv);
    if (!call.options.submission.empty() || !call.options.built.empty()) {
      throw pt::Error("a submission is measured in a box: start ./run, not this program");
    }
    if (!call.options.keep.empty()) say_when_stopped();
    run_call(call);
    pt::flush_standard_output();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", pt::sentence_of(error).c_str());
    return 2;
  }
}
