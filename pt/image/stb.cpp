// The definitions of stb_image and stb_image_write, compiled here so that the sanitizers see them.
// Formats that nobody needs are left out, so that less code reads unknown bytes.
#include <cstddef>
#include <cstdlib>

namespace {

// A file states its own sizes, and stb_image allocates that much memory before it reads on: 2 GiB for a PNG
// of 200 bytes. More memory than the largest picture needs is refused.
void* bounded_realloc(void* old, std::size_t size) {
  constexpr std::size_t kMax = std::size_t{1} << 30;
  return size > kMax ? nullptr : std::realloc(old, size);
}

}  // namespace

#define STBI_MALLOC(size) bounded_realloc(nullptr, size)
#define STBI_REALLOC(old, size) bounded_realloc(old, size)
#define STBI_FREE(old) std::free(old)
#define STBI_ONLY_PNG
#define STBI_ONLY_JPEG
#define STBI_ONLY_BMP
#define STBI_ONLY_HDR
#define STBI_NO_STDIO
#define STBI_MAX_DIMENSIONS (1 << 16)
#define STB_IMAGE_IMPLEMENTATION
#include <stb/stb_image.h>
#define STBI_WRITE_NO_STDIO
#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb/stb_image_write.h>
