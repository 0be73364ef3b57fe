// Any bytes are a clone of a course's skeleton, or are refused, and its files are flattened.
#include "grader/door/flatten.h"
#include "pt/error.h"
#include "tests/fuzz/input.h"

#include <filesystem>
#include <string>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace grader::door;
  static const Texts texts = read_texts(std::filesystem::path(FIRSTLIGHT_ROOT) / "grader/door");
  try {
    const Clone clone = unpack(std::string(fuzz::as_text(data, size)));
    for (const auto& [slug, adapter] : texts.tasks) {
      flatten(clone, texts, slug);
      functions_of(clone, texts, slug);
    }
  } catch (const pt::Error& error) {
    fuzz::expect_reason(error);
  }
  return 0;
}
