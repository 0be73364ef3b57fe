// writeup_boxed: makes a submission's pictures without running its code in this process.
//   writeup_boxed build SUBMISSION OUT.json       compiles it in the box and links a worker
//   writeup_boxed build SUBMISSION OUT.json PARTS.json [TASK ...]   the same with other parts, and only these tasks of it
//   writeup_boxed render WORKER TIER SPEC BAND    renders some rows with that worker
#include "grader/service/process/spawn.h"
#include "measure/renders/band.h"
#include "measure/renders/boxed.h"
#include "pt/end_of_program.h"
#include "pt/error.h"

#include <csignal>

namespace measure {
namespace {

using Words = std::vector<std::string>;

constexpr std::chrono::minutes kCallLimit{5};  // the write-up's own limit is usually shorter

int run(const Words& words) {
  if (words.size() == 3 && words[0] == "build") {
    write_boxed(build_submission(words[1]), words[2]);
    return 0;
  }
  if (words.size() > 3 && words[0] == "build") {
    write_boxed(build_submission(words[1], words[3], {words.begin() + 4, words.end()}), words[2]);
    return 0;
  }
  if (words.size() == 5 && words[0] == "render") {
    open_worker({words[1], words[2], {}, {}}, kCallLimit);
    make_band(words[3], band_of(words[4]));
    return 0;
  }
  throw pt::Error("writeup_boxed build SUBMISSION OUT.json | render WORKER TIER SPEC BAND");
}

}  // namespace
}  // namespace measure

int main(int argc, char** argv) {
  grader::process::hide_process();
  std::signal(SIGPIPE, SIG_IGN);
  return pt::run_program([&] { return measure::run({argv + 1, argv + argc}); });
}
