#include "grader/service/intake/flatten_boxed.h"

#include "grader/base/descriptor.h"
#include "grader/base/printable.h"
#include "grader/service/intake/read_boxed.h"
#include "pt/error.h"
#include "pt/file.h"

#include <filesystem>

#include <fcntl.h>

namespace grader::intake {

namespace fs = std::filesystem;

std::string flatten_boxed(const std::string& name, const door::Clone& clone,
                          const std::string& root, const std::string& programs, sandbox::Tier tier,
                          const std::string& folder) {
  fs::create_directories(folder);
  const std::string packed = folder + ".packed";
  pt::write_file(packed, door::pack(clone));
  const base::Descriptor input(open(packed.c_str(), O_RDONLY | O_CLOEXEC));
  fs::remove(packed);
  if (!input.is_open()) throw pt::Error(packed + " cannot be read");
  const std::string texts = root + "/grader/door";
  return read_boxed({.command = {programs + "/flatten", texts},
                     .visible = {texts},
                     .input = input.number(),
                     .folder = folder,
                     .name = base::printable(name, 300),
                     .done = "read"},
                    tier);
}

}  // namespace grader::intake
