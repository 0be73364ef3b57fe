#include "pt/image/tone_map.h"

namespace pt {

Picture tone_map(const Image& image, double exposure) {
  Picture picture(image.width, image.height);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    const Rgb& c = image.pixels[i];
    picture.pixels[i] = {encode(c.r, exposure), encode(c.g, exposure), encode(c.b, exposure)};
  }
  return picture;
}

}  // namespace pt
