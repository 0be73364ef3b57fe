// unpack NAME: for grade_class, in a box of its own (grade_class/unpack_boxed.h): the archive on standard input is
// unpacked in the folder where this program starts. An archive that makes the library crash, or that never ends,
// costs that submission and no other.
#include "grader/intake/unpack.h"

#include "pt/end_of_program.h"
#include "pt/error.h"

#include <clocale>
#include <cstdio>

#include <sys/resource.h>
#include <unistd.h>

namespace {

constexpr rlim_t kMostMemory = rlim_t{2} << 30;
constexpr rlim_t kMostSeconds = 60;
constexpr rlim_t kMostFile = rlim_t{64} << 20;

void bound(__rlimit_resource_t what, rlim_t most) {
  const rlimit limit{most, most};
  setrlimit(what, &limit);
}

}  // namespace

int main(int argc, char** argv) {
  bound(RLIMIT_AS, kMostMemory);
  bound(RLIMIT_CPU, kMostSeconds);
  bound(RLIMIT_FSIZE, kMostFile);
  bound(RLIMIT_CORE, 0);
  std::setlocale(LC_ALL, "C.UTF-8");  // names in any script
  try {
    if (argc != 2) throw pt::Error("unpack NAME <ARCHIVE");
    grader::intake::unpack(STDIN_FILENO, argv[1], ".");
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", pt::sentence_of(error).c_str());
    return 2;
  }
}
