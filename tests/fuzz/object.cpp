// Object files of a submission as the audit reads them, and programs made of such files.
#include "grader/service/audit/audit.h"
#include "grader/service/audit/object_file.h"
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
  using namespace grader;
  const std::string_view object = fuzz::as_text(bytes, size);
  read_or_refuse([&] { audit::read_object(object); });
  read_or_refuse([&] { fuzz::expect(audit::with_state_marked(object).size() >= object.size()); });
  read_or_refuse([&] {
    const std::string why = audit::audit(object, {"_ZN2pt7hit_boxE"}, grader::task_of("hit_box"));
    if (!why.empty()) fuzz::expect_sentence(why);
  });
  for (const std::uint64_t place : {0, 1, 4096})
    read_or_refuse([&] { audit::state_at(object, place); });
  return 0;
}
