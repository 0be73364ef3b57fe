#include "grader/service/intake/archive_reader.h"

#include "pt/error.h"

#include <utility>

#include <archive.h>
#include <archive_entry.h>
#include <fmt/format.h>
#include <unistd.h>

namespace grader::intake {

namespace {

constexpr int kMaxReopened = 200;

}  // namespace

void ArchiveReader::Closed::operator()(archive* reader) const { archive_read_free(reader); }

// Leaves out the filters for which the library starts programs.
ArchiveReader::Reader ArchiveReader::new_reader() {
  Reader reader(archive_read_new());
  archive_read_support_filter_gzip(reader.get());
  archive_read_support_filter_bzip2(reader.get());
  archive_read_support_filter_compress(reader.get());
  archive_read_support_filter_lzma(reader.get());
  archive_read_support_filter_xz(reader.get());
  archive_read_support_filter_zstd(reader.get());
  archive_read_support_format_zip(reader.get());
  archive_read_support_format_tar(reader.get());
  archive_read_support_format_gnutar(reader.get());
  archive_read_support_format_7zip(reader.get());
  archive_read_support_format_rar(reader.get());
  archive_read_support_format_rar5(reader.get());
  return reader;
}

std::string path_of(archive_entry* entry) {
  const char* text = archive_entry_pathname_utf8(entry);
  if (text == nullptr) text = archive_entry_pathname(entry);
  return text == nullptr || *text == '\0' ? "a name that cannot be read" : text;
}

ArchiveReader::ArchiveReader(int file, std::string name, const Bounds& bounds)
    : file_(file), name_(std::move(name)), bounds_(bounds) {}

void ArchiveReader::open() {
  if (lseek(file_, 0, SEEK_SET) != 0) fail("it cannot be read from its beginning");
  reader_ = new_reader();
  entries_ = 0;
  constexpr std::size_t kBlock = 1 << 16;
  expect(archive_read_open_fd(reader_.get(), file_, kBlock));
}

archive_entry* ArchiveReader::next() {
  archive_entry* entry = nullptr;
  const int got = archive_read_next_header(reader_.get(), &entry);
  if (got == ARCHIVE_EOF) return nullptr;
  expect(got);
  if (++entries_ > bounds_.entries)
    fail(fmt::format("it has more than {} entries", bounds_.entries));
  if (archive_filter_bytes(reader_.get(), 0) > bounds_.unpacked)
    fail(fmt::format("it is larger than {} GiB", bounds_.unpacked >> 30));
  return entry;
}

std::size_t ArchiveReader::read(char* bytes, std::size_t most) {
  const la_ssize_t got = archive_read_data(reader_.get(), bytes, most);
  if (got < 0) throw EntryFault(reason(), got == ARCHIVE_FATAL);
  return static_cast<std::size_t>(got);
}

void ArchiveReader::read_on() {
  const int done = entries_;
  if (++reopened_ > kMaxReopened) fail("it is damaged in many places");
  open();
  while (entries_ < done) {
    if (next() == nullptr) fail("it is damaged");
  }
}

std::string ArchiveReader::reason() const {
  const char* text = archive_error_string(reader_.get());
  return text == nullptr ? "it is damaged" : text;
}

void ArchiveReader::expect(int status) const {
  if (status < ARCHIVE_WARN) fail(reason());
}

void ArchiveReader::fail(const std::string& why) const {
  throw pt::Error(fmt::format("'{}' cannot be unpacked: {}", name_, why));
}

}  // namespace grader::intake
