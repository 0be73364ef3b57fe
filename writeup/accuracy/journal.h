#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace writeup::accuracy {

// All measurements so far, in their order: a file from which the same run goes on after it was
// stopped. The next measurement depends only on those before, so that the same questions come again.
class Journal {
 public:
  // Keeps nothing.
  Journal() = default;
  // In the file, which is made with its folder. Another run that has it open keeps it to itself: then
  // this one keeps nothing.
  explicit Journal(const std::filesystem::path& file);
  Journal(Journal&& other) noexcept;
  Journal& operator=(Journal&&) = delete;
  ~Journal();

  // The recorded answer, if the next question in the file is this one. Else the rest of the file is
  // dropped.
  std::optional<std::vector<double>> next(const std::string& question);
  // Adds the answer to a question that was not known.
  void keep(const std::string& question, const std::vector<double>& answer);
  // The run has ended: removes the file.
  void remove();

  bool goes_on() const { return size_ > 0; }  // with what an earlier run kept

 private:
  int file_ = -1;
  std::filesystem::path path_;
  std::uint64_t size_ = 0;  // of the entries that were there
  std::uint64_t at_ = 0;    // of them, read so far
};

}  // namespace writeup::accuracy
