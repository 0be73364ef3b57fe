// Pictures: EXR files of goldens and renders, all other formats of ./run compare, and the counts of
// a sample map.
#include "pt/error.h"
#include "pt/image/image_io.h"
#include "pt/image/sample_map.h"
#include "tests/fuzz/input.h"

namespace {

template <class Read>
void expect_read_or_refused(const Read& read) {
  try {
    const auto [width, height, values] = read();
    fuzz::expect(width > 0 && height > 0 && values == static_cast<std::size_t>(width) * height);
  } catch (const pt::Error& error) {
    fuzz::expect_reason(error);
  }
}

struct Size {
  int width, height;
  std::size_t values;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const std::filesystem::path file = fuzz::as_file(fuzz::as_text(bytes, size));
  expect_read_or_refused([&] {
    const pt::Film film = pt::read_exr(file);
    return Size{film.width, film.height, film.pixels.size()};
  });
  expect_read_or_refused([&] {
    const pt::Image image = pt::read_image(file);
    return Size{image.width, image.height, image.pixels.size()};
  });
  expect_read_or_refused([&] {
    const pt::SampleMap map = pt::read_counts(file);
    return Size{map.width, map.height, map.counts.size()};
  });
  return 0;
}
