#pragma once

#include "grader/service/intake/unpack.h"

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

// Reads the entries of an archive one after the other, with limits on their number and on the bytes
// read. Throws pt::Error, with the archive's name, if the archive is damaged or exceeds a limit.
class ArchiveReader {
 public:
  ArchiveReader(int file, std::string name, const Bounds& bounds);

  // Starts again from the beginning.
  void open();

  // Returns the next entry; nothing at the end.
  archive_entry* next();

  // Returns the entry's next bytes; none at its end. Throws EntryFault.
  std::size_t read(char* bytes, std::size_t most);

  // Continues after an entry that ended the reader.
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

// The path of an entry, as the archive has it.
std::string path_of(archive_entry* entry);

}  // namespace grader::intake
