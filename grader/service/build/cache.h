#pragma once

#include <chrono>
#include <cstdint>
#include <string>

// The folder in which the judge keeps its builds and results, so that nothing is done twice. Its
// files have hashes as names: <key>.o, <key>.picture.json, ... All files of one key are one entry.
namespace grader::build {

// A cache larger than this is trimmed to less than half of it when a judge starts, at most once per
// kTrimPause: looking at all files takes as long as a small task's promises. A file larger than kLarge ends the pause.
inline constexpr std::uintmax_t kMaxCached = std::uintmax_t{1} << 30,
                                kLarge = std::uintmax_t{4} << 20;
inline constexpr std::chrono::minutes kTrimPause{1};

// An entry that was used since a judge began that still runs is not removed, because that judge may need it, nor one that was used
// within this time: what a judge leaves is read by the program that called it.
inline constexpr std::chrono::minutes kJustUsed{1};

// A folder that was used within this time is not removed. It is longer than any run.
inline constexpr std::chrono::hours kInUse{1};

// As long as it lives, other processes see that a judge uses the folder, and since when.
class Running {
 public:
  explicit Running(const std::string& folder);
  Running(const Running&) = delete;
  Running& operator=(const Running&) = delete;
  ~Running();

 private:
  std::string path_;
};

// Writes a file of the cache.
void keep(const std::string& path, const std::string& bytes);

// Marks an entry's file as used now. Does nothing if the file is not there.
void mark_used(const std::string& path);

// The SHA-256 of a file's content. Unlike base::stamp(), it stays the same when an object is
// rebuilt with equal content. It is computed once per version of the file, and kept in `folder`.
std::string content_stamp(const std::string& path, const std::string& folder);

// Removes the folders next to this one that nobody has used within kInUse. They belong to other
// versions of the project, its compiler or its flags.
void remove_unused_beside(const std::string& folder);

// Removes temporary files and folders of processes that have ended: half-made trees, files of
// compilers, linkers and probes. Files stay for now if another process has the number; clocks jump,
// so their age is not used. A file that cannot be removed, or is gone already, is not an error.
void remove_left_overs(const std::string& folder);

// If the folder holds more than `most` bytes, removes the entries least recently used, until it
// holds less than half. So it holds at most what the judges that run have used, and `most` bytes.
void trim_cache(const std::string& folder, std::uintmax_t most = kMaxCached);

// Calls trim_cache, unless the cache was checked within kTrimPause.
void trim_cache_now_and_then(const std::string& folder, std::uintmax_t most = kMaxCached);

}  // namespace grader::build
