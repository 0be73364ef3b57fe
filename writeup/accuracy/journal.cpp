#include "writeup/accuracy/journal.h"

#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

namespace writeup::accuracy {

namespace {

// The head of an entry.
struct Head {
  std::uint64_t question = 0;  // bytes
  std::uint64_t answer = 0;    // numbers
};

bool read_all(int file, void* into, std::size_t bytes, std::uint64_t at) {
  return pread(file, into, bytes, static_cast<off_t>(at)) == static_cast<ssize_t>(bytes);
}

std::uint64_t length(const Head& head) {
  return sizeof head + head.question + head.answer * sizeof(double);
}

}  // namespace

Journal::Journal(const std::filesystem::path& file) : path_(file) {
  std::filesystem::create_directories(file.parent_path());
  file_ = open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
  if (file_ < 0) return;
  if (flock(file_, LOCK_EX | LOCK_NB) != 0) {
    close(std::exchange(file_, -1));
    return;
  }
  size_ = static_cast<std::uint64_t>(lseek(file_, 0, SEEK_END));
}

Journal::Journal(Journal&& other) noexcept
    : file_(std::exchange(other.file_, -1)),
      path_(std::move(other.path_)),
      size_(other.size_),
      at_(other.at_) {}

Journal::~Journal() {
  if (file_ >= 0) close(file_);
}

std::optional<std::vector<double>> Journal::next(const std::string& question) {
  if (file_ < 0 || at_ >= size_) return std::nullopt;
  Head head;
  const bool fits = read_all(file_, &head, sizeof head, at_) && head.question == question.size() &&
                    head.answer <= size_ && at_ + length(head) <= size_;
  std::string asked(question.size(), '\0');
  if (fits && read_all(file_, asked.data(), asked.size(), at_ + sizeof head) && asked == question) {
    std::vector<double> answer(head.answer);
    if (read_all(file_, answer.data(), answer.size() * sizeof(double),
                 at_ + sizeof head + head.question)) {
      at_ += length(head);
      return answer;
    }
  }
  size_ = at_;
  return std::nullopt;
}

void Journal::keep(const std::string& question, const std::vector<double>& answer) {
  if (file_ < 0) return;
  const Head head{question.size(), answer.size()};
  std::string bytes(reinterpret_cast<const char*>(&head), sizeof head);
  bytes += question;
  bytes.append(reinterpret_cast<const char*>(answer.data()), answer.size() * sizeof(double));
  // A part of an entry that a stopped run left lies behind the end, and is written over.
  const bool cut = ftruncate(file_, static_cast<off_t>(at_)) == 0;
  const auto wanted = static_cast<ssize_t>(bytes.size());
  if (cut && pwrite(file_, bytes.data(), bytes.size(), static_cast<off_t>(at_)) == wanted) {
    at_ += bytes.size();
    size_ = at_;
  } else {
    remove();  // as on a full disk: the run goes on without
  }
}

void Journal::remove() {
  if (file_ < 0) return;
  unlink(path_.c_str());
  close(std::exchange(file_, -1));
}

}  // namespace writeup::accuracy
