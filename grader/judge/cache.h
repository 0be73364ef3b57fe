#pragma once

#include <chrono>
#include <cstdint>
#include <string>

// The folder in which the judge keeps what it has built and found out, so that nothing is done
// twice. Its files are named by hashes: <key>.o, <key>.picture.json ...; those of one key are one
// entry.
namespace grader::judge {

// A cache that is larger than this is trimmed to less than half of it, when a judge starts and none
// has looked for kTrimPause: a look at all of its files takes as long as a small task's promises.
inline constexpr std::uintmax_t kMaxCached = std::uintmax_t{1} << 30;
inline constexpr std::chrono::minutes kTrimPause{10};

// An entry that was used within this time is not removed, because another judge may still need it. It
// is longer than any run.
inline constexpr std::chrono::hours kInUse{1};

// Marks an entry's file as used now. Does nothing if the file is not there.
void mark_used(const std::string& path);

// The SHA-256 of a file's content. Unlike base::stamp(), it stays the same when an object is built again with equal content. It is
// computed once for each version of the file, and kept in `folder`.
std::string content_stamp(const std::string& path, const std::string& folder);

// Removes temporary files and folders of processes that are gone: half-made trees, files of
// compilers, linkers and probes. No clock is asked, as clocks jump: where another process has the
// number by now, they stay for the moment. A file that cannot be removed, or is gone already, is not an error.
void remove_left_overs(const std::string& folder);

// The same of one file, whose folder belongs to somebody else: only what pt::write_file() was about to make that file.
void remove_left_overs_of(const std::string& file);

// If the folder holds more than `most` bytes, removes the entries least recently used, until it
// holds less than half. Nothing that was used within kInUse goes.
void trim_cache(const std::string& folder, std::uintmax_t most = kMaxCached);

// Does the same, unless the cache was looked at within kTrimPause.
void trim_cache_now_and_then(const std::string& folder, std::uintmax_t most = kMaxCached);

}  // namespace grader::judge
