#include "pt/image/exr.h"

#include "pt/error.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <vector>

#include <tinyexr.h>

namespace pt {
namespace {

// EXR wants the channels sorted by name.
constexpr std::array<const char*, 9> kChannels{
    "B", "G", "R", "Y", "samples", "variance.B", "variance.G", "variance.R", "variance.Y"};
constexpr int kSamples = 4;

// What tinyexr fills in is freed whichever way a function is left.
struct Header : EXRHeader {
  Header() { InitEXRHeader(this); }
  ~Header() { FreeEXRHeader(this); }
  Header(const Header&) = delete;
  Header& operator=(const Header&) = delete;
};
struct Pixels : EXRImage {
  Pixels() { InitEXRImage(this); }
  ~Pixels() { FreeEXRImage(this); }
  Pixels(const Pixels&) = delete;
  Pixels& operator=(const Pixels&) = delete;
};

std::array<float, 9> values(const FilmPixel& p) {
  const auto f = [](double v) { return static_cast<float>(v); };
  return {f(p.mean.b),     f(p.mean.g),     f(p.mean.r),     f(luminance(p.mean)), 0,
          f(p.variance.b), f(p.variance.g), f(p.variance.r), f(p.variance_y)};
}

// Frees tinyexr's message.
std::string take_message(const char* message) {
  std::string text = message ? message : "no reason given";
  FreeEXRErrorMessage(message);
  return text;
}

[[noreturn]] void fail(const std::string& name, const std::string& why) {
  throw Error("cannot read '" + name + "': " + why);
}

}  // namespace

bool starts_as_exr(std::string_view bytes) { return bytes.substr(0, 4) == "\x76\x2f\x31\x01"; }

std::string encode_exr(const Film& film) {
  const std::size_t count = film.pixels.size();
  std::array<std::vector<float>, 9> planes;
  for (std::vector<float>& plane : planes) plane.resize(count);
  std::vector<std::uint32_t> samples(count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::array<float, 9> all = values(film.pixels[i]);
    for (int c = 0; c < 9; ++c) planes[c][i] = all[c];
    samples[i] = static_cast<std::uint32_t>(film.pixels[i].samples);
  }

  std::array<EXRChannelInfo, 9> channels{};
  std::array<int, 9> types{};
  std::array<unsigned char*, 9> data{};
  for (int c = 0; c < 9; ++c) {
    std::strcpy(channels[c].name, kChannels[c]);
    types[c] = c == kSamples ? TINYEXR_PIXELTYPE_UINT : TINYEXR_PIXELTYPE_FLOAT;
    data[c] = c == kSamples ? reinterpret_cast<unsigned char*>(samples.data())
                            : reinterpret_cast<unsigned char*>(planes[c].data());
  }
  // Plain structs here: what they point to is ours, not tinyexr's to free.
  EXRHeader header;
  InitEXRHeader(&header);
  header.num_channels = 9;
  header.channels = channels.data();
  header.pixel_types = types.data();
  header.requested_pixel_types = types.data();
  header.compression_type = TINYEXR_COMPRESSIONTYPE_ZIP;
  EXRImage image;
  InitEXRImage(&image);
  image.num_channels = 9;
  image.images = data.data();
  image.width = film.width;
  image.height = film.height;

  unsigned char* bytes = nullptr;
  const char* message = nullptr;
  const std::size_t size = SaveEXRImageToMemory(&image, &header, &bytes, &message);
  const std::unique_ptr<unsigned char, void (*)(void*)> owner(bytes, std::free);
  if (size == 0) throw Error("the picture cannot be encoded as EXR: " + take_message(message));
  return {reinterpret_cast<const char*>(bytes), size};
}

Film decode_exr(const std::string& bytes, const std::string& name) {
  const auto* data = reinterpret_cast<const unsigned char*>(bytes.data());
  EXRVersion version;
  if (ParseEXRVersionFromMemory(&version, data, bytes.size()) != TINYEXR_SUCCESS) {
    fail(name, "it is not an EXR picture");
  }
  if (version.tiled || version.multipart || version.non_image) {
    fail(
        name,
        "EXR files with tiles, several parts or deep data are not supported; save it as scanlines");
  }
  const char* message = nullptr;
  Header header;
  if (ParseEXRHeaderFromMemory(&header, &version, data, bytes.size(), &message) !=
      TINYEXR_SUCCESS) {
    fail(name, "its EXR header is broken (" + take_message(message) + ")");
  }
  const EXRBox2i& window = header.data_window;
  const long width = 1L + window.max_x - window.min_x, height = 1L + window.max_y - window.min_y;
  if (!is_image_size(width, height)) {
    fail(name, "a picture of " + std::to_string(width) + " x " + std::to_string(height) +
                   " pixels is not accepted");
  }
  std::array<int, 9> where;
  where.fill(-1);
  for (int c = 0; c < header.num_channels; ++c) {
    if (header.channels[c].x_sampling != 1 || header.channels[c].y_sampling != 1) {
      fail(name, "its channel " + std::string(header.channels[c].name) +
                     " is subsampled; save it in full size");
    }
    if (header.pixel_types[c] == TINYEXR_PIXELTYPE_HALF) {
      header.requested_pixel_types[c] = TINYEXR_PIXELTYPE_FLOAT;
    }
    const auto found = std::find_if(kChannels.begin(), kChannels.end(), [&](const char* wanted) {
      return std::strcmp(wanted, header.channels[c].name) == 0;
    });
    if (found == kChannels.end()) continue;
    const int slot = static_cast<int>(found - kChannels.begin());
    if ((header.pixel_types[c] == TINYEXR_PIXELTYPE_UINT) == (slot == kSamples)) where[slot] = c;
  }
  if (where[0] < 0 || where[1] < 0 || where[2] < 0) {
    fail(name, "it has no channels R, G and B of type half or float");
  }
  Pixels image;
  if (LoadEXRImageFromMemory(&image, &header, data, bytes.size(), &message) != TINYEXR_SUCCESS) {
    fail(name, "its EXR data is broken or cut short (" + take_message(message) + ")");
  }
  if (image.width != width || image.height != height || !image.images)
    fail(name, "its EXR data is broken");

  const auto value = [&](int slot, std::size_t i) -> double {
    return reinterpret_cast<const float*>(image.images[where[slot]])[i];
  };
  bool statistics = where[kSamples] >= 0;
  for (int slot = 5; slot < 9; ++slot) statistics = statistics && where[slot] >= 0;
  Film film(image.width, image.height);
  for (std::size_t i = 0; i < film.pixels.size(); ++i) {
    FilmPixel& pixel = film.pixels[i];
    pixel.mean = {value(2, i), value(1, i), value(0, i)};
    if (!statistics) continue;
    pixel.variance = {value(7, i), value(6, i), value(5, i)};
    pixel.variance_y = value(8, i);
    const std::uint32_t samples =
        reinterpret_cast<const std::uint32_t*>(image.images[where[kSamples]])[i];
    if (samples > 0x7fffffff) fail(name, "its channel samples holds a number that is no count");
    pixel.samples = static_cast<int>(samples);
  }
  return film;
}

}  // namespace pt
