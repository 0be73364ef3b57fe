// plan.json of a class, which other machines read: an accepted plan can be graded, and its reports
// stay in their folder.
#include "grader/service/classes/plan.h"

#include "pt/error.h"
#include "pt/file.h"
#include "tests/fixtures/temporary_folder.h"
#include "tests/fuzz/input.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace grader::classes;
  static const TemporaryFolder folder;
  const std::string path = folder.path() + "/plan.json";
  pt::write_file(path, fuzz::as_text(bytes, size));
  try {
    const ClassPlan plan = read_plan(folder.path());
    for (const auto& by : plan.everybody) {
      fuzz::expect(!by.name.empty() && by.name.find('/') == by.name.npos && by.name != "..");
    }
    fuzz::expect(plan.real_names.empty() || plan.real_names.size() == plan.everybody.size());
    for (const Chunk& chunk : plan.chunks) {
      for (const Equal& equal : chunk) {
        fuzz::expect(!equal.empty());
        for (const std::size_t i : equal) fuzz::expect(i < plan.everybody.size());
      }
    }
    write_plan(plan, folder.path());
    const std::string once = pt::read_file(path, std::size_t{1} << 24);
    write_plan(read_plan(folder.path()), folder.path());
    fuzz::expect(pt::read_file(path, std::size_t{1} << 24) == once);
  } catch (const pt::Error& error) {
    fuzz::expect_reason(error);
  }
  return 0;
}
