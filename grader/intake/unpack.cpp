#include "grader/intake/unpack.h"

#include "grader/base/descriptor.h"
#include "grader/base/files.h"
#include "pt/error.h"
#include "pt/file.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <memory>
#include <sstream>

#include <archive.h>
#include <archive_entry.h>
#include <fcntl.h>
#include <fmt/format.h>

namespace grader::intake {

namespace fs = std::filesystem;

namespace {

constexpr int kMostEntries = 100000;
constexpr int kMostFiles = 5000;
constexpr std::size_t kMostBytes = std::size_t{64} << 20;
constexpr la_int64_t kMostUnpacked = la_int64_t{2} << 30;

constexpr std::array kArchives{".zip", ".tar",     ".tar.gz", ".tgz", ".tar.xz",
                               ".txz", ".tar.bz2", ".tbz2",   ".7z"};

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

bool is_useful(const std::string& name) {
  return name.ends_with(".cpp") || name == kGradescopeList || is_archive(name);
}

// The path below the folder; empty if the entry is left out. Windows writes \ for /.
fs::path place_of(std::string path) {
  std::replace(path.begin(), path.end(), '\\', '/');
  fs::path place;
  std::istringstream parts(path);
  for (std::string part; std::getline(parts, part, '/');) {
    if (part.empty() || part == ".") continue;
    if (base::is_hidden(part)) return {};
    place /= part;
  }
  return path.starts_with('/') || !is_useful(place.filename()) ? fs::path{} : place;
}

struct Closed {
  void operator()(archive* reader) const { archive_read_free(reader); }
};
using Reader = std::unique_ptr<archive, Closed>;

class Unpacking {
 public:
  Unpacking(int file, std::string name, fs::path folder)
      : name_(std::move(name)), folder_(std::move(folder)), reader_(archive_read_new()) {
    archive_read_support_filter_all(reader_.get());
    archive_read_support_format_zip(reader_.get());
    archive_read_support_format_tar(reader_.get());
    archive_read_support_format_gnutar(reader_.get());
    archive_read_support_format_7zip(reader_.get());
    constexpr std::size_t kBlock = 1 << 16;
    expect(archive_read_open_fd(reader_.get(), file, kBlock));
  }

  void run() {
    archive_entry* entry = nullptr;
    for (int entries = 0;; ++entries) {
      const int got = archive_read_next_header(reader_.get(), &entry);
      if (got == ARCHIVE_EOF) return;
      expect(got);
      if (entries == kMostEntries) fail(fmt::format("it has more than {} entries", kMostEntries));
      take(entry);
      if (archive_filter_bytes(reader_.get(), 0) > kMostUnpacked) fail("it is larger than 2 GiB");
    }
  }

 private:
  void take(archive_entry* entry) {
    const char* text = archive_entry_pathname_utf8(entry);
    if (text == nullptr) text = archive_entry_pathname(entry);
    const bool plain =
        archive_entry_filetype(entry) == AE_IFREG && archive_entry_hardlink(entry) == nullptr;
    const fs::path place = text != nullptr && plain ? place_of(text) : fs::path{};
    if (place.empty()) return;
    if (archive_entry_is_encrypted(entry) != 0) fail("it is encrypted");
    const fs::path file = folder_ / place;
    std::error_code error;
    if (fs::exists(file, error)) return;
    fs::create_directories(file.parent_path(), error);
    if (error) return;  // a file stands where a folder should
    const std::string bytes = content();
    if (++files_ > kMostFiles) fail(fmt::format("it has more than {} files", kMostFiles));
    pt::write_file(file, bytes);
  }

  // Sizes that the archive states may be wrong.
  std::string content() {
    std::string bytes;
    std::array<char, 1 << 16> block;
    while (true) {
      const la_ssize_t got = archive_read_data(reader_.get(), block.data(), block.size());
      if (got == 0) return bytes;
      if (got < 0) fail(reason());
      bytes_ += static_cast<std::size_t>(got);
      if (bytes_ > kMostBytes) fail("its files are larger than 64 MiB");
      bytes.append(block.data(), static_cast<std::size_t>(got));
    }
  }

  std::string reason() const {
    const char* text = archive_error_string(reader_.get());
    return text == nullptr ? "it is damaged" : text;
  }
  void expect(int status) const {
    if (status < ARCHIVE_WARN) fail(reason());
  }
  [[noreturn]] void fail(const std::string& why) const {
    throw pt::Error(fmt::format("'{}' cannot be unpacked: {}", name_, why));
  }

  std::string name_;
  fs::path folder_;
  Reader reader_;
  int files_ = 0;
  std::size_t bytes_ = 0;
};

struct Written {
  void operator()(archive* writer) const { archive_write_free(writer); }
};
using Writer = std::unique_ptr<archive, Written>;

void put(archive* writer, const Packed& packed) {
  const std::string bytes = pt::read_file(packed.file, kMostBytes);
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
    fs::rename(temporary, archive);
  } catch (const std::exception& error) {
    std::error_code ignored;
    fs::remove(temporary, ignored);
    throw pt::Error(fmt::format("'{}' cannot be written: {}", archive, error.what()));
  }
}

bool is_archive(const std::string& name) {
  return std::any_of(kArchives.begin(), kArchives.end(),
                     [&](const char* ending) { return lower(name).ends_with(ending); });
}

void unpack(const std::string& archive, const std::string& folder) {
  const std::string name = fs::path(archive).filename();
  const base::Descriptor file(open(archive.c_str(), O_RDONLY | O_CLOEXEC));
  if (!file.is_open()) throw pt::Error(fmt::format("'{}' cannot be read", name));
  fs::create_directories(folder);
  unpack(file.number(), name, folder);
}

void unpack(int archive, const std::string& name, const std::string& folder) {
  Unpacking(archive, name, folder).run();
}

}  // namespace grader::intake
