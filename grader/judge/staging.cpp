#include "grader/judge/staging.h"

#include "grader/process/descriptor.h"
#include "pt/error.h"

#include <filesystem>

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>

namespace grader {

namespace fs = std::filesystem;

namespace {

// Whatever the umask: another user reads it.
void put(const fs::path& path, const std::string& text) {
  const Descriptor file(open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0644));
  const bool whole =
      file.is_open() && fchmod(file.number(), 0644) == 0 &&
      write(file.number(), text.data(), text.size()) == static_cast<ssize_t>(text.size());
  if (!whole) throw pt::Error(path.string() + ": cannot be written");
}

void make_folder(const fs::path& path) {
  if (fs::create_directories(path)) fs::permissions(path, fs::perms(0755));
}

}  // namespace

Headers public_headers(const std::string& root) {
  Headers headers;
  for (const auto& entry : fs::recursive_directory_iterator(root + "/pt")) {
    if (entry.path().extension() != ".h") continue;
    headers[fs::relative(entry.path(), root)] = read_file(entry.path());
  }
  return headers;
}

Stage::Stage(const std::string& folder, const Headers& headers, const std::string& file,
             const std::string& text)
    : folder_(folder) {
  const fs::path place = folder;
  make_folder(place);
  for (const auto& [path, content] : headers) {
    make_folder((place / path).parent_path());
    put(place / path, content);
  }
  make_folder((place / file).parent_path());
  put(place / file, text);
}

// A compiler that was killed may take a moment to be gone.
Stage::~Stage() {
  std::error_code error;
  fs::remove_all(folder_, error);
  for (int i = 0; i < 100 && error; ++i) {
    poll(nullptr, 0, 10);
    fs::remove_all(folder_, error);
  }
}

Submitted Stage::take(const std::string& name, std::size_t most) const {
  const Descriptor place(open(folder_.c_str(), O_PATH | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
  return read_plain_file(place.number(), name, most);
}

}  // namespace grader
