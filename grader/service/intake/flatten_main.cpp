// flatten TEXTS: writes the twelve task files of the packed clone on standard input to the folder where this
// program starts. TEXTS is the folder grader/door. grade runs it in a box
// (grader/service/intake/boxed_readers.h), so a clone that makes it crash, or never end, harms only
// itself. The exit status is 2 if the clone is at fault, 3 if the machine is.
#include "grader/door/flatten.h"
#include "grader/service/intake/reader_program.h"
#include "grader/tasks.h"
#include "pt/error.h"
#include "pt/file.h"

#include <filesystem>
#include <iostream>
#include <iterator>
#include <string>

namespace {

void flatten_all(const std::string& folder) {
  namespace door = grader::door;
  const door::Clone clone =
      door::unpack({std::istreambuf_iterator<char>(std::cin), std::istreambuf_iterator<char>()});
  const door::Texts texts = door::read_texts(folder);
  for (const grader::Task& task : grader::tasks()) {
    if (!texts.tasks.contains(task.slug)) continue;
    std::filesystem::create_directories(task.part);
    pt::write_file(task.file(), door::flatten(clone, texts, task.slug));
    pt::write_file(task.file() + door::kFunctions, door::functions_of(clone, texts, task.slug));
  }
}

}  // namespace

int main(int argc, char** argv) {
  return grader::intake::run_reader([&] {
    if (argc != 2) throw pt::Error("flatten TEXTS <PACKED_CLONE");
    flatten_all(argv[1]);
  });
}
