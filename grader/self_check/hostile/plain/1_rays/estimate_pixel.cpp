// Writes garbage, with some valid beginnings in it, to every descriptor there is.
#include "pt/tasks/estimate_pixel.h"

#include <string>

#include <unistd.h>

namespace pt {

Rgb estimate_pixel(const View&, int, int, int, Sampler& sampler) {
  std::string garbage(24, '\1');
  garbage.replace(0, 4, "1FLT");
  for (int i = 0; i < 40; ++i) garbage += static_cast<char>(sampler.next_1d() * 256);
  for (int descriptor = 0; descriptor < 64; ++descriptor) {
    if (write(descriptor, garbage.data(), garbage.size()) < 0) continue;
  }
  return {1, 1, 1};
}

}  // namespace pt
