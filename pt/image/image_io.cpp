#include "pt/image/image_io.h"

#include "pt/error.h"
#include "pt/file.h"
#include "pt/image/exr.h"
#include "pt/image/pfm.h"
#include "pt/image/tone_map.h"

#include <algorithm>
#include <cctype>
#include <memory>

#include <stb/stb_image.h>
#include <stb/stb_image_write.h>

namespace pt {
namespace {

namespace fs = std::filesystem;

std::string extension(const fs::path& path) {
  std::string text = path.extension().string();
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

void expect_known_ending(const fs::path& path) {
  const std::string ending = extension(path);
  if (ending == ".png" || ending == ".exr") return;
  throw Error("cannot write '" + path.string() +
              "': pictures are written as .png or .exr, so the name has to end in one of these");
}

Image decode_stb(const std::string& bytes, const std::string& name) {
  const auto* data = reinterpret_cast<const stbi_uc*>(bytes.data());
  const int size = static_cast<int>(bytes.size());
  const auto fail = [&] {
    const char* reason = stbi_failure_reason();
    throw Error("cannot read '" + name +
                "': it is not a whole EXR, HDR, PFM, PNG, JPEG or BMP picture (" +
                (reason ? reason : "no reason given") + ")");
  };
  int width = 0, height = 0, channels = 0;
  if (!stbi_info_from_memory(data, size, &width, &height, &channels)) fail();
  if (!is_image_size(width, height)) {
    throw Error("cannot read '" + name + "': a picture of " + std::to_string(width) + " x " +
                std::to_string(height) + " pixels is not accepted");
  }
  if (stbi_is_hdr_from_memory(data, size)) {
    const std::unique_ptr<float, void (*)(void*)> linear(
        stbi_loadf_from_memory(data, size, &width, &height, &channels, 3), stbi_image_free);
    if (!linear) fail();
    Image image(width, height);
    const float* value = linear.get();
    for (Rgb& pixel : image.pixels) {
      pixel = {value[0], value[1], value[2]};
      value += 3;
    }
    return image;
  }
  const std::unique_ptr<stbi_uc, void (*)(void*)> values(
      stbi_load_from_memory(data, size, &width, &height, &channels, 3), stbi_image_free);
  if (!values) fail();
  Image image(width, height);
  const stbi_uc* value = values.get();
  for (Rgb& pixel : image.pixels) {
    pixel = {decode(value[0]), decode(value[1]), decode(value[2])};
    value += 3;
  }
  return image;
}

}  // namespace

void check_image_target(const fs::path& path) {
  expect_known_ending(path);
  check_target(path);
}

bool is_exr_name(const fs::path& path) { return extension(path) == ".exr"; }

void write_image(const fs::path& path, const Film& film, double exposure,
                 const std::string& settings) {
  expect_known_ending(path);
  if (is_exr_name(path)) {
    write_file(path, encode_exr(film, settings));
  } else {
    write_png(path, mean(film), exposure);
  }
}

std::string encode_png(const Picture& picture) {
  std::string bytes;
  const auto append = [](void* context, void* data, int size) {
    static_cast<std::string*>(context)->append(static_cast<const char*>(data), size);
  };
  if (!stbi_write_png_to_func(append, &bytes, picture.width, picture.height, 3,
                              picture.pixels.data(), 3 * picture.width)) {
    throw Error("the picture could not be encoded as PNG");
  }
  return bytes;
}

void write_png(const fs::path& path, const Picture& picture) {
  write_file(path, encode_png(picture));
}

void write_png(const fs::path& path, const Image& image, double exposure) {
  write_png(path, tone_map(image, exposure));
}

void write_exr(const fs::path& path, const Film& film) { write_file(path, encode_exr(film)); }

Film read_exr(const fs::path& path) {
  return decode_exr(read_file(path, kMaxPictureBytes), path.string());
}

Image read_image(const fs::path& path) {
  const std::string bytes = read_file(path, kMaxPictureBytes);
  if (starts_as_exr(bytes)) return mean(decode_exr(bytes, path.string()));
  if (starts_as_pfm(bytes)) return decode_pfm(bytes, path.string());
  return decode_stb(bytes, path.string());
}

bool is_exr(const fs::path& path) { return starts_as_exr(read_file(path, kMaxPictureBytes)); }

}  // namespace pt
