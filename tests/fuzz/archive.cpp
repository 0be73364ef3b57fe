// Archives of learners: everything that is unpacked is a plain file and stays in its folder.
#include "grader/service/intake/unpack.h"
#include "pt/error.h"
#include "tests/fixtures/temporary_folder.h"
#include "tests/fuzz/input.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  namespace fs = std::filesystem;
  using grader::intake::Extent;
  static const TemporaryFolder folder;
  const fs::path inside = fs::path(folder.path()) / "a" / "b";
  for (const auto extent : {Extent::one, Extent::everybody}) {
    try {
      grader::intake::unpack(fuzz::as_file(fuzz::as_text(bytes, size)), inside, extent);
    } catch (const pt::Error& error) {
      fuzz::expect_reason(error);
    }
    for (const auto& entry : fs::recursive_directory_iterator(folder.path())) {
      fuzz::expect(!entry.is_symlink() && (entry.is_regular_file() || entry.is_directory()));
      fuzz::expect(entry.path() == inside.parent_path() ||
                   entry.path().string().starts_with(inside.string()));
    }
    fs::remove_all(inside.parent_path());
  }
  return 0;
}
