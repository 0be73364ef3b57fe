// unpack NAME one|everybody [PLATFORM PATTERN]...: unpacks the archive on standard input in the folder where this program
// starts; in a class, names of files have one of these forms (grader/service/intake/form_table.h). grade_class runs it in a box (grader/service/intake/boxed_readers.h), which limits its
// time, memory and files. So an archive that crashes the library, or never ends, harms only its own
// submission. The exit status is 2 if the archive is at fault, 3 if the machine is.
#include "grader/service/intake/form_table.h"
#include "grader/service/intake/reader_program.h"
#include "grader/service/intake/unpack.h"
#include "pt/error.h"

#include <clocale>
#include <string>
#include <vector>

#include <unistd.h>

int main(int argc, char** argv) {
  using grader::intake::Extent;
  std::setlocale(LC_ALL, "C.UTF-8");  // names in any script
  return grader::intake::run_reader([&] {
    if (argc < 3 || argc % 2 == 0)
      throw pt::Error("unpack NAME one|everybody [PLATFORM PATTERN]... <ARCHIVE");
    const bool of_all = std::string(argv[2]) == "everybody";
    std::vector<grader::intake::NameForm> table;
    for (int i = 3; i < argc; i += 2)
      table.push_back(grader::intake::name_form(argv[i], argv[i + 1]));
    grader::intake::unpack(STDIN_FILENO, argv[1], ".", of_all ? Extent::everybody : Extent::one, {},
                           table);
  });
}
