// unpack NAME one|everybody: unpacks the archive on standard input in the folder where this program
// starts. grade_class runs it in a box (grader/service/intake/unpack_boxed.h), which limits its
// time, memory and files. So an archive that crashes the library, or never ends, harms only its own
// submission. The exit status is 2 if the archive is at fault, 3 if the machine is.
#include "grader/service/intake/unpack.h"
#include "pt/end_of_program.h"
#include "pt/error.h"

#include <clocale>
#include <csignal>
#include <cstdio>
#include <new>
#include <string>

#include <sys/resource.h>
#include <unistd.h>

namespace {

constexpr rlim_t kSecondsToTell = 2;

// At the limit of processor time the kernel kills the process, as it does if no memory is left. So
// this program reports a slow archive a little earlier.
void tell_before_the_limit() {
  rlimit limit{};
  if (getrlimit(RLIMIT_CPU, &limit) != 0 || limit.rlim_max == RLIM_INFINITY) return;
  std::signal(SIGXCPU, [](int) {
    constexpr char kWords[] = "it takes too long\n";
    (void)!write(STDERR_FILENO, kWords, sizeof kWords - 1);
    _exit(2);
  });
  limit.rlim_cur = limit.rlim_max > kSecondsToTell ? limit.rlim_max - kSecondsToTell : 1;
  setrlimit(RLIMIT_CPU, &limit);
}

}  // namespace

int main(int argc, char** argv) {
  using grader::intake::Extent;
  tell_before_the_limit();
  std::setlocale(LC_ALL, "C.UTF-8");  // names in any script
  try {
    if (argc != 3) throw pt::Error("unpack NAME one|everybody <ARCHIVE");
    const bool of_all = std::string(argv[2]) == "everybody";
    grader::intake::unpack(STDIN_FILENO, argv[1], ".", of_all ? Extent::everybody : Extent::one);
    return 0;
  } catch (const pt::Error& error) {
    std::fprintf(stderr, "%s\n", pt::sentence_of(error).c_str());
    return 2;
  } catch (const std::bad_alloc&) {
    std::fprintf(stderr, "it needs too much memory\n");
    return 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", pt::sentence_of(error).c_str());
    return 3;
  }
}
