#include "grader/service/intake/unpack.h"
#include "pt/error.h"
#include "pt/file.h"

#include <filesystem>
#include <memory>

#include <archive.h>
#include <archive_entry.h>
#include <fmt/format.h>

namespace grader::intake {

namespace {

constexpr std::size_t kMaxPacked = std::size_t{64} << 20;

struct Written {
  void operator()(archive* writer) const { archive_write_free(writer); }
};
using Writer = std::unique_ptr<archive, Written>;

void put(archive* writer, const Packed& packed) {
  const std::string bytes = pt::read_file(packed.file, kMaxPacked);
  archive_entry* entry = archive_entry_new();
  archive_entry_set_pathname_utf8(entry, packed.path.c_str());
  archive_entry_set_filetype(entry, AE_IFREG);
  archive_entry_set_perm(entry, 0644);
  archive_entry_set_size(entry, static_cast<la_int64_t>(bytes.size()));
  const int status = archive_write_header(writer, entry);
  archive_entry_free(entry);
  if (status < ARCHIVE_WARN || archive_write_data(writer, bytes.data(), bytes.size()) < 0) {
    throw pt::Error(
        fmt::format("'{}' cannot be packed: {}", packed.path, archive_error_string(writer)));
  }
}

}  // namespace

void pack(const std::string& archive, const std::vector<Packed>& files) {
  const std::string temporary = pt::temporary_name(archive);
  try {
    const Writer writer(archive_write_new());
    archive_write_set_format_zip(writer.get());
    archive_write_set_options(writer.get(), "hdrcharset=UTF-8");
    if (archive_write_open_filename(writer.get(), temporary.c_str()) != ARCHIVE_OK) {
      throw pt::Error(archive_error_string(writer.get()));
    }
    for (const Packed& each : files) put(writer.get(), each);
    if (archive_write_close(writer.get()) != ARCHIVE_OK) {
      throw pt::Error(archive_error_string(writer.get()));
    }
    std::filesystem::rename(temporary, archive);
  } catch (const std::exception& error) {
    std::error_code ignored;
    std::filesystem::remove(temporary, ignored);
    throw pt::Error(fmt::format("'{}' cannot be written: {}", archive, error.what()));
  }
}

}  // namespace grader::intake
