// flatten TEXTS: writes the twelve task files of the packed clone on standard input to the folder where this
// program starts. TEXTS is the folder grader/door. grade runs it in a box
// (grader/service/intake/flatten_boxed.h), so a clone that makes it crash, or never end, harms only
// itself. The exit status is 2 if the clone is at fault, 3 if the machine is.
#include "grader/door/flatten.h"
#include "grader/tasks.h"
#include "pt/end_of_program.h"
#include "pt/error.h"
#include "pt/file.h"

#include <cstdio>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <new>
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
  }
}

}  // namespace

int main(int argc, char** argv) {
  try {
    if (argc != 2) throw pt::Error("flatten TEXTS <PACKED_CLONE");
    flatten_all(argv[1]);
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
