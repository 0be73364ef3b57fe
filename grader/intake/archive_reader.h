#pragma once

#include "grader/intake/unpack.h"

#include <cstddef>
#include <memory>
#include <stdexcept>
#include <string>

struct archive;
struct archive_entry;

namespace grader::intake {

// A fault of one entry.
struct EntryFault : std::runtime_error {
  explicit EntryFault(const std::string& why, bool reader_ends = false)
      : std::runtime_error(why), ends_reader(reader_ends) {}
  bool ends_reader;  // nothing more can be read after it
};

// Reads the entries of an archive one after the other, and bounds their number and the bytes that are read. Throws pt::Error,
// with the archive's name, if the archive is damaged or exceeds these bounds.
class ArchiveReader {
 public:
  ArchiveReader(int file, std::string name, const Bounds& bounds);

  // From the beginning.
  void open();

  // The next entry; nothing at the end.
  archive_entry* next();

  // The entry's next bytes; none at its end. Throws EntryFault.
  std::size_t read(char* bytes, std::size_t most);

  // After an entry that ended the reader: goes on behind it.
  void read_on();

  [[noreturn]] void fail(const std::string& why) const;

 private:
  struct Closed {
    void operator()(archive* reader) const;
  };
  using Reader = std::unique_ptr<archive, Closed>;

  static Reader new_reader();
  std::string reason() const;
  void expect(int status) const;

  int file_;
  std::string name_;
  Bounds bounds_;
  Reader reader_;
  int entries_ = 0, reopened_ = 0;
};

// The path of an entry, as it stands there.
std::string path_of(archive_entry* entry);

}  // namespace grader::intake
