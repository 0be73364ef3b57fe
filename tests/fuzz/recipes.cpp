// scenes/recipes.json, which instructors write by hand.
#include "grader/pictures/recipes/recipes.h"

#include "pt/error.h"
#include "pt/file.h"
#include "tests/fixtures/temporary_folder.h"
#include "tests/fuzz/input.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  // The scene that the corpus's recipes name has to exist.
  static const TemporaryFolder folder;
  static const std::filesystem::path file = std::filesystem::path(folder.path()) / "recipes.json";
  pt::write_file(std::filesystem::path(folder.path()) / "star.dae", "");
  pt::write_file(file, fuzz::as_text(bytes, size));
  try {
    for (const auto& recipe : grader::pictures::load_recipes(file)) {
      fuzz::expect(recipe.width > 0 && recipe.height > 0 && recipe.seed > 0);
    }
  } catch (const pt::Error& error) {
    fuzz::expect_reason(error);
  }
  return 0;
}
