// Objects that a submission's compiler has made, as the audit reads them, and programs of such.
#include "grader/judge/audit.h"
#include "grader/judge/object_file.h"
#include "pt/error.h"
#include "tests/fuzz/input.h"

namespace {

template <class Read>
void read_or_refuse(const Read& read) {
  try {
    read();
  } catch (const pt::Error& error) {
    fuzz::expect_reason(error);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace grader::judge;
  const std::string_view object = fuzz::as_text(bytes, size);
  read_or_refuse([&] { read_object(object); });
  read_or_refuse([&] { fuzz::expect(with_state_marked(object).size() >= object.size()); });
  read_or_refuse([&] {
    const std::string why = audit(object, {"_ZN2pt7hit_boxE"}, grader::task_of("hit_box"));
    if (!why.empty()) fuzz::expect_sentence(why);
  });
  for (const std::uint64_t place : {0, 1, 4096}) read_or_refuse([&] { state_at(object, place); });
  return 0;
}
