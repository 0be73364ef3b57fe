// points.json, which instructors write by hand.
#include "grader/results/points.h"

#include "pt/error.h"
#include "tests/fuzz/input.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace grader::results;
  try {
    const Points points = load_points(fuzz::as_file(fuzz::as_text(bytes, size)));
    TaskResult task;
    task.slug = "hit_box";
    task.promises.resize(3);
    task.promises[0].held = true;
    task.pictures.resize(2);
    count_points(points, task);
    fuzz::expect(task.points >= 0 && task.points <= task.max_points);
  } catch (const pt::Error& error) {
    fuzz::expect_reason(error);
  }
  return 0;
}
