// Measures the cost of a call to a worker: one at a time, repeated in batches, and with a scene
// named by its content. Prints microseconds.
#include "grader/check/language/repeat.h"
#include "grader/service/wire/session.h"
#include "pt/tasks/diffuse_bsdf.h"

#include <chrono>
#include <csignal>
#include <cstdio>

namespace {

template <class Work>
double microseconds(int calls, const Work& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  const std::chrono::duration<double, std::micro> time = std::chrono::steady_clock::now() - start;
  return time.count() / calls;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  std::signal(SIGPIPE, SIG_IGN);
  grader::wire::SessionSettings settings;
  settings.task = "diffuse_bsdf";
  settings.program = argv[1];
  grader::wire::open_session(settings);
  pt::Sampler sampler(1);
  pt::diffuse_sample({}, {0, 0, 1}, sampler);  // starts the worker

  constexpr int kSingle = 20000, kRepeated = 1000000;
  const double single = microseconds(kSingle, [&] {
    for (int i = 0; i < kSingle; ++i) pt::diffuse_sample({}, {0, 0, 1}, sampler);
  });
  const double batched = microseconds(kRepeated, [&] {
    grader::check::repeat<pt::diffuse_sample>(kRepeated, 1, pt::Rgb{}, pt::Vec3{0, 0, 1});
  });
  std::printf("a single call    %6.2f us\na repeated call  %6.2f us\n", single, batched);
}
