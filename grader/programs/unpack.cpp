// unpack NAME: for grade_class, in a box of its own (grade_class/unpack_boxed.h): the archive on standard input is
// unpacked in the folder where this program starts. An archive that makes the library crash, or that never ends,
// costs that submission and no other; the box bounds its time, memory and files.
#include "grader/intake/unpack.h"

#include "pt/end_of_program.h"
#include "pt/error.h"

#include <clocale>
#include <cstdio>

#include <unistd.h>

int main(int argc, char** argv) {
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
