// accuracy cheapest | converge SCENE: measures the needs of a scene, or the worth of methods in it,
// with the tasks linked here.
#include "measure/scene/begin.h"
#include "pt/end_of_program.h"
#include "pt/error.h"

int main(int argc, char** argv) {
  using namespace measure::scene;
  return pt::run_program([&] {
    const Call call = parse_call(argc, argv);
    if (!call.options.submission.empty() || !call.options.built.empty()) {
      throw pt::Error("a submission is measured in a box: start ./run, not this program");
    }
    return run_call(call);
  });
}
