// accuracy cheapest | converge SCENE: measures the needs of a scene, or the worth of methods in it,
// with the tasks linked here.
#include "measure/scene/begin.h"
#include "pt/end_of_program.h"
#include "pt/error.h"

#include <filesystem>

int main(int argc, char** argv) {
  using namespace measure::scene;
  return pt::run_program([&] {
    Call call = parse_call(argc, argv);
    if (!call.options.submissions.empty() || !call.options.built.empty()) {
      throw pt::Error("a submission is measured in a box: start ./run, not this program");
    }
    // accuracy.reference, accuracy.reference+hit_bvh-student
    const std::string mixture = std::filesystem::path(call.program).extension();
    if (!mixture.empty()) call.options.whose = mixture.substr(1);
    return run_call(call);
  });
}
