#include "pt/image/exr.h"

#include "pt/error.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <memory>
#include <vector>

#include <tinyexr.h>

namespace pt {
namespace {

// EXR wants the channels sorted by name.
enum Channel {
  kB,
  kG,
  kR,
  kY,
  kSamples,
  kVarianceB,
  kVarianceG,
  kVarianceR,
  kVarianceY,
  kChannels
};
constexpr std::array<const char*, kChannels> kNames{
    "B", "G", "R", "Y", "samples", "variance.B", "variance.G", "variance.R", "variance.Y"};

constexpr const char* kSettings = "firstlight";  // the attribute

// The place of each of our channels in the file, or -1.
using ChannelPlaces = std::array<int, kChannels>;

// These free the memory of tinyexr however a function ends.
class ReadHeader : public EXRHeader {
 public:
  ReadHeader(const std::string& bytes, const std::string& file);
  ~ReadHeader() { FreeEXRHeader(this); }
  ReadHeader(const ReadHeader&) = delete;
  ReadHeader& operator=(const ReadHeader&) = delete;

 private:
  ReadHeader() { InitEXRHeader(this); }
};
struct ReadPixels : EXRImage {
  ReadPixels() { InitEXRImage(this); }
  ~ReadPixels() { FreeEXRImage(this); }
  ReadPixels(const ReadPixels&) = delete;
  ReadPixels& operator=(const ReadPixels&) = delete;
};

const unsigned char* data(const std::string& bytes) {
  return reinterpret_cast<const unsigned char*>(bytes.data());
}

// Frees tinyexr's message, and removes the newline at the end of some messages.
std::string take_message(const char* message) {
  std::string text = message ? message : "no reason given";
  text.erase(std::min(text.find('\n'), text.size()));
  FreeEXRErrorMessage(message);
  return text;
}

[[noreturn]] void fail(const std::string& name, const std::string& why) {
  throw Error("cannot read '" + name + "': " + why);
}

std::array<std::vector<float>, kChannels> planes(const Film& film) {
  std::array<std::vector<float>, kChannels> out;
  for (const FilmPixel& p : film.pixels) {
    const std::array<double, kChannels> values{
        p.mean.b,     p.mean.g,     p.mean.r,     luminance(p.mean), 0,
        p.variance.b, p.variance.g, p.variance.r, p.variance_y};
    // The variance of samples that fit a float may be above it.
    constexpr double kMax = std::numeric_limits<float>::max();
    for (int c = 0; c < kChannels; ++c) {
      out[c].push_back(static_cast<float>(c < kVarianceB ? values[c] : std::min(values[c], kMax)));
    }
  }
  return out;
}

// The destructor runs even if this throws: the other constructor has made the object.
ReadHeader::ReadHeader(const std::string& bytes, const std::string& file) : ReadHeader() {
  EXRVersion version;
  if (ParseEXRVersionFromMemory(&version, data(bytes), bytes.size()) != TINYEXR_SUCCESS) {
    fail(file, "it is not an EXR picture");
  }
  if (version.tiled || version.multipart || version.non_image) {
    fail(file, "EXR files with tiles, several parts or deep data are not read; save scanlines");
  }
  const char* message = nullptr;
  if (ParseEXRHeaderFromMemory(this, &version, data(bytes), bytes.size(), &message) !=
      TINYEXR_SUCCESS) {
    fail(file, "its EXR header is broken (" + take_message(message) + ")");
  }
  const long width = 1L + data_window.max_x - data_window.min_x;
  const long height = 1L + data_window.max_y - data_window.min_y;
  if (!is_image_size(width, height)) {
    fail(file, "a picture of " + std::to_string(width) + " x " + std::to_string(height) +
                   " pixels is not accepted");
  }
  // Channels of type half are converted to float, too.
  for (int i = 0; i < num_channels; ++i) {
    if (channels[i].pixel_type == TINYEXR_PIXELTYPE_HALF) {
      requested_pixel_types[i] = TINYEXR_PIXELTYPE_FLOAT;
    }
  }
}

ChannelPlaces find_channels(const ReadHeader& header, const std::string& name) {
  ChannelPlaces places;
  places.fill(-1);
  for (int i = 0; i < header.num_channels; ++i) {
    const EXRChannelInfo& channel = header.channels[i];
    if (channel.x_sampling != 1 || channel.y_sampling != 1) {
      fail(name, std::string("its channel ") + channel.name + " is subsampled; save it in full");
    }
    const bool whole = channel.pixel_type == TINYEXR_PIXELTYPE_UINT;
    for (int c = 0; c < kChannels; ++c) {
      if (std::strcmp(kNames[c], channel.name) == 0 && whole == (c == kSamples)) places[c] = i;
    }
  }
  if (places[kR] < 0 || places[kG] < 0 || places[kB] < 0) {
    fail(name, "it has no channels R, G and B of type half or float");
  }
  return places;
}

template <class T>
T little_endian(const std::string& bytes, std::size_t at) {
  T value = 0;
  for (std::size_t i = 0; i < sizeof(T); ++i) {
    value |= static_cast<T>(static_cast<T>(data(bytes)[at + i]) << (8 * i));
  }
  return value;
}

// Every block of lines has to be present, in its place in the table: if a block is missing, tinyexr
// leaves whatever was in the memory of its lines.
void check_blocks(const ReadHeader& header, const std::string& bytes, const std::string& name) {
  const int lines = header.compression_type == TINYEXR_COMPRESSIONTYPE_ZIP   ? 16
                    : header.compression_type == TINYEXR_COMPRESSIONTYPE_PIZ ? 32
                                                                             : 1;
  const EXRBox2i& window = header.data_window;
  const std::size_t blocks = (window.max_y - window.min_y) / lines + 1;
  const std::size_t table = 8 + std::size_t{header.header_len};
  const std::size_t size = bytes.size();
  if (table > size || blocks > (size - table) / 8) fail(name, "its EXR data is cut short");
  if (header.chunk_count != 0 && static_cast<std::size_t>(header.chunk_count) != blocks) {
    fail(name, "its EXR header contradicts itself about the number of blocks");
  }
  for (std::size_t b = 0; b < blocks; ++b) {
    const auto offset = little_endian<std::uint64_t>(bytes, table + 8 * b);
    if (size < 8 || offset > size - 8) fail(name, "its EXR data is cut short");
    const auto line = static_cast<std::int32_t>(little_endian<std::uint32_t>(bytes, offset));
    if (line != window.min_y + static_cast<long>(b) * lines) {
      fail(name, "its EXR data is broken: a block of lines is missing");
    }
  }
}

Film to_film(const ReadPixels& image, const ChannelPlaces& places, const std::string& name) {
  const auto value = [&](Channel c, std::size_t i) -> double {
    return reinterpret_cast<const float*>(image.images[places[c]])[i];
  };
  const bool statistics = std::find(places.begin() + kSamples, places.end(), -1) == places.end();
  Film film(image.width, image.height);
  for (std::size_t i = 0; i < film.pixels.size(); ++i) {
    FilmPixel& pixel = film.pixels[i];
    pixel.mean = {value(kR, i), value(kG, i), value(kB, i)};
    if (!statistics) continue;
    pixel.variance = {value(kVarianceR, i), value(kVarianceG, i), value(kVarianceB, i)};
    pixel.variance_y = value(kVarianceY, i);
    pixel.samples = reinterpret_cast<const std::int32_t*>(image.images[places[kSamples]])[i];
    if (pixel.samples < 0) fail(name, "its channel samples holds a number that is not a count");
  }
  return film;
}

}  // namespace

bool starts_as_exr(std::string_view bytes) { return bytes.substr(0, 4) == "\x76\x2f\x31\x01"; }

std::string encode_exr(const Film& film, const std::string& settings) {
  std::array<std::vector<float>, kChannels> floats = planes(film);
  std::vector<std::uint32_t> samples;
  for (const FilmPixel& p : film.pixels) samples.push_back(static_cast<std::uint32_t>(p.samples));

  std::array<EXRChannelInfo, kChannels> channels{};
  std::array<int, kChannels> types;
  std::array<unsigned char*, kChannels> images;
  for (int c = 0; c < kChannels; ++c) {
    std::snprintf(channels[c].name, sizeof channels[c].name, "%s", kNames[c]);
    types[c] = TINYEXR_PIXELTYPE_FLOAT;
    images[c] = reinterpret_cast<unsigned char*>(floats[c].data());
  }
  types[kSamples] = TINYEXR_PIXELTYPE_UINT;
  images[kSamples] = reinterpret_cast<unsigned char*>(samples.data());

  EXRHeader header;
  InitEXRHeader(&header);
  header.num_channels = kChannels;
  header.channels = channels.data();
  header.pixel_types = types.data();
  header.requested_pixel_types = types.data();
  header.compression_type = TINYEXR_COMPRESSIONTYPE_ZIP;
  std::string text = settings;  // tinyexr takes bytes that are not const
  EXRAttribute attribute{};
  std::snprintf(attribute.name, sizeof attribute.name, "%s", kSettings);
  std::snprintf(attribute.type, sizeof attribute.type, "string");
  attribute.value = reinterpret_cast<unsigned char*>(text.data());
  attribute.size = static_cast<int>(text.size());
  header.custom_attributes = &attribute;
  header.num_custom_attributes = text.empty() ? 0 : 1;
  EXRImage image;
  InitEXRImage(&image);
  image.num_channels = kChannels;
  image.images = images.data();
  image.width = film.width;
  image.height = film.height;

  unsigned char* bytes = nullptr;
  const char* message = nullptr;
  const std::size_t size = SaveEXRImageToMemory(&image, &header, &bytes, &message);
  const std::unique_ptr<unsigned char, void (*)(void*)> owner(bytes, std::free);
  if (size == 0) throw Error("the picture cannot be written as EXR: " + take_message(message));
  return {reinterpret_cast<const char*>(bytes), size};
}

std::string exr_settings(const std::string& bytes, const std::string& name) {
  const ReadHeader header(bytes, name);
  for (int i = 0; i < header.num_custom_attributes; ++i) {
    const EXRAttribute& attribute = header.custom_attributes[i];
    if (std::strcmp(attribute.name, kSettings) != 0) continue;
    return {reinterpret_cast<const char*>(attribute.value),
            static_cast<std::size_t>(attribute.size)};
  }
  return "";
}

Film decode_exr(const std::string& bytes, const std::string& name) {
  const ReadHeader header(bytes, name);
  const ChannelPlaces places = find_channels(header, name);
  check_blocks(header, bytes, name);
  ReadPixels image;
  image.num_channels = header.num_channels;  // else tinyexr loses the planes when it fails
  const char* message = nullptr;
  if (LoadEXRImageFromMemory(&image, &header, data(bytes), bytes.size(), &message) !=
      TINYEXR_SUCCESS) {
    InitEXRImage(&image);  // tinyexr freed them, but left the pointers
    fail(name, "its EXR data is broken or cut short (" + take_message(message) + ")");
  }
  return to_film(image, places, name);
}

}  // namespace pt
