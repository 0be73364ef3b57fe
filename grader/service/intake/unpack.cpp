#include "grader/service/intake/unpack.h"

#include "grader/base/descriptor.h"
#include "grader/door/clone.h"
#include "grader/service/intake/archive_reader.h"
#include "grader/service/intake/entry_path.h"
#include "grader/service/intake/file_name.h"
#include "grader/service/intake/owner.h"
#include "pt/error.h"
#include "pt/file.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <stdexcept>

#include <archive.h>
#include <archive_entry.h>
#include <fcntl.h>
#include <fmt/format.h>

namespace grader::intake {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kMaxPlaceholders = 20;  // of one owner
constexpr std::size_t kMaxPath = 3000;
constexpr const char* kTwoOfThatName =
    "the archive has two of that name, or two names that differ only in how their accents are "
    "written; unpack the archive, and grade the folder";
constexpr const char* kEarlier = "the earlier of two";
constexpr const char* kFaults = ".faults";  // hidden, so no entry can have this name

// The text in place of a link: its task is reported, and does not look as if it were not begun.
constexpr const char* kNotAFile =
    "#error \"in the archive that was handed in, this is a link or a device; hand in the file\"\n";

// The folder, and the text, in place of a file whose path leads out of the archive. Such a path is not followed.
constexpr const char* kOutside = "paths that lead out of the archive";
constexpr const char* kLeadsOut =
    "#error \"in the archive that was handed in, the path of this file leads out of it; pack the "
    "folder again\"\n";

bool is_useful(const std::string& name) {
  return is_source(name) || door::is_read(name) || name == kGradescopeList || is_archive(name);
}

class Unpacking {
 public:
  Unpacking(int file, std::string name, fs::path folder, Extent extent, const Limits& limits,
            const std::vector<NameForm>& table)
      : folder_(std::move(folder)),
        of_all_(extent == Extent::everybody),
        limits_(limits),
        table_(table),
        bounds_(of_all_ ? limits.everybody : limits.one),
        reader_(file, std::move(name), bounds_) {}

  void run() {
    if (of_all_) look_ahead();
    reader_.open();
    while (archive_entry* entry = reader_.next()) {
      const std::string path = path_of(entry);
      const std::vector<std::string> place = parts_of(path);
      if (leads_out(path)) note_outside(path);
      if (place.empty()) {
        make_owner_of_hidden(parts_before_hidden(path));
        continue;
      }
      try {
        take(entry, place);
      } catch (const EntryFault& fault) {
        blame(place, fault.what());
        if (fault.ends_reader) reader_.read_on();
      }
    }
    if (outside_ && used_.empty())
      reader_.fail("its paths are absolute or lead out of it; pack the folder again");
    for (const auto& [owner, used] : used_) {
      if (used.links > 0 && used.links == used.files)
        blame(used.link, "its source files are links; hand in what they point to");
    }
    for (const std::string& name : outside_files_) {
      if (!of_all_ && !sources_.contains(name)) put(kOutside + ('/' + name), kLeadsOut);
    }
    write_faults();
  }

 private:
  struct Used {
    int files = 0, links = 0;
    std::size_t placeholders = 0;
    std::vector<std::string> link;  // the path of a link
    std::uint64_t bytes = 0;
    bool failed = false;
  };

  void note_outside(const std::string& path) {
    outside_ = true;
    const std::vector<std::string> name = parts_of(path.substr(path.find_last_of("/\\") + 1));
    const bool is_named = !name.empty() && is_source(name[0]);
    if (is_named && outside_files_.size() < kMaxPlaceholders) outside_files_.insert(name[0]);
  }

  void look_ahead() {
    std::vector<std::vector<std::string>> paths;
    reader_.open();
    while (archive_entry* entry = reader_.next()) {
      const std::string path = path_of(entry);
      std::vector<std::string> place = parts_before_hidden(path);
      if (place.empty()) continue;
      if (parts_of(path).empty()) {
        place.emplace_back(kHidden);
      } else if (archive_entry_filetype(entry) == AE_IFDIR) {
        place.emplace_back(kFolderItself);
      }
      paths.push_back(std::move(place));
    }
    owners_ = Owners(paths, table_);
    for (const std::vector<std::string>& place : owners_.in_doubt()) blame(place, kTwoOfThatName);
  }

  void take(archive_entry* entry, const std::vector<std::string>& place) {
    Used& used = used_[of_all_ ? owners_.key(place) : ""];
    const auto type = archive_entry_filetype(entry);
    const bool is_folder = type == AE_IFDIR;
    const bool plain = type == AE_IFREG && archive_entry_hardlink(entry) == nullptr;
    const bool on_top = place.size() <= owners_.depth() + 1;
    if (of_all_ && !(plain && on_top)) make_owner(place, is_folder);
    if (is_folder || used.failed) return;
    if (!plain && of_all_ && on_top) throw EntryFault("it is a link; hand in what it points to");
    const std::string path = joined(place, place.size());
    if (path.size() > kMaxPath) throw EntryFault("its paths are too long");
    if (!plain) {
      if (!is_source(place.back())) return;
      count_file(used);
      ++used.links;
      used.link = place;
      put(path, kNotAFile);
      return;
    }
    if (!is_useful(place.back())) {
      if (used.placeholders++ < kMaxPlaceholders) put(path, "");
      return;
    }
    if (archive_entry_is_encrypted(entry) != 0) throw EntryFault("it is encrypted");
    const std::string bytes = content(used);
    count_file(used);
    if (is_other(path, bytes)) {
      if (of_all_) throw EntryFault(kTwoOfThatName);
      if (is_source(place.back())) keep_earlier(path);
    }
    if (is_source(place.back())) sources_.insert(place.back());
    put(path, bytes);
  }

  void count_file(Used& used) {
    if (++used.files > limits_.one.files)
      throw EntryFault(fmt::format("it has more than {} files", limits_.one.files));
    if (++files_ > bounds_.files)
      reader_.fail(fmt::format("it has more than {} files", bounds_.files));
  }

  // The library writes all accents in the same way: one of two learners' files would be lost.
  bool is_other(const std::string& path, const std::string& bytes) const {
    const fs::path file = folder_ / path;
    return fs::is_regular_file(file) && pt::read_file(file) != bytes;
  }

  // The last file of a name counts. The one before goes to a folder beside it, so that it is said.
  // As a copy: in its box, this program may not move files from folder to folder.
  void keep_earlier(const fs::path& path) const {
    put(path.parent_path() / kEarlier / path.filename(), pt::read_file(folder_ / path));
  }

  // Makes the owner's folder, or an empty file, so that no owner is overlooked.
  void make_owner(const std::vector<std::string>& place, bool is_folder) {
    const std::string path = joined(place, owners_.depth() + 1);
    if (path.size() > kMaxPath || !made_.insert(path).second) return;
    if (is_folder || place.size() > owners_.depth() + 1) {
      make_folder(folder_ / path);
    } else {
      put(path, "");
    }
  }

  void make_owner_of_hidden(const std::vector<std::string>& folder) {
    if (of_all_ && folder.size() > owners_.depth()) make_owner(folder, true);
  }

  // Returns whether the folder is there now: a file may be in its place.
  static bool make_folder(const fs::path& folder) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (!error) return true;
    const bool in_the_way = error == std::errc::not_a_directory || error == std::errc::file_exists;
    if (in_the_way) return false;
    throw fs::filesystem_error("cannot be made", folder, error);
  }

  void put(const std::string& path, const std::string& bytes) const {
    const fs::path file = folder_ / path;
    if (!make_folder(file.parent_path()) || fs::is_directory(file)) return;
    // No temporary name is needed: nobody reads the folder before it is complete.
    std::ofstream out(file, std::ios::binary);
    out << bytes << std::flush;
    if (!out) throw std::runtime_error(fmt::format("{}: cannot be written", path));
  }

  // Sizes that the archive states may be wrong.
  std::string content(Used& used) {
    std::string bytes;
    std::array<char, 1 << 16> block;
    while (true) {
      const std::size_t more = reader_.read(block.data(), block.size());
      if (more == 0) return bytes;
      used.bytes += more;
      bytes_ += more;
      if (used.bytes > limits_.one.bytes)
        throw EntryFault(fmt::format("its files are larger than {} MiB", limits_.one.bytes >> 20));
      if (bytes_ > bounds_.bytes)
        reader_.fail(fmt::format("its files are larger than {} GiB", bounds_.bytes >> 30));
      bytes.append(block.data(), more);
    }
  }

  void blame(const std::vector<std::string>& place, const std::string& why) {
    if (!of_all_) reader_.fail(why);
    make_owner(place, false);
    used_[owners_.key(place)].failed = true;
    faults_.push_back({joined(place, owners_.depth() + 1),
                       fmt::format("'{}' cannot be unpacked: {}", place.back(), why)});
  }

  void write_faults() const {
    if (faults_.empty()) return;
    std::string text;
    for (const Fault& fault : faults_) text += fault.path + '\0' + fault.reason + '\0';
    pt::write_file(folder_ / kFaults, text);
  }

  fs::path folder_;
  bool of_all_, outside_ = false;
  std::set<std::string> outside_files_, sources_;  // names of source files
  Limits limits_;
  const std::vector<NameForm>& table_;
  Bounds bounds_;  // of this archive
  ArchiveReader reader_;
  Owners owners_;
  int files_ = 0;
  std::uint64_t bytes_ = 0;
  std::map<std::string, Used> used_;
  std::set<std::string> made_;
  std::vector<Fault> faults_;
};

}  // namespace

void unpack(const std::string& archive, const std::string& folder, Extent extent,
            const Limits& limits, const std::vector<NameForm>& table) {
  const std::string name = fs::path(archive).filename();
  const base::Descriptor file(::open(archive.c_str(), O_RDONLY | O_CLOEXEC));
  if (!file.is_open()) throw pt::Error(fmt::format("'{}' cannot be read", name));
  fs::create_directories(folder);
  unpack(file.number(), name, folder, extent, limits, table);
}

void unpack(int archive, const std::string& name, const std::string& folder, Extent extent,
            const Limits& limits, const std::vector<NameForm>& table) {
  Unpacking(archive, name, folder, extent, limits, table).run();
}

std::vector<Fault> read_faults(const std::string& folder) {
  const fs::path file = fs::path(folder) / kFaults;
  if (!fs::exists(file)) return {};
  const std::string text = pt::read_file(file);
  std::vector<std::string> fields;
  for (std::size_t at = 0, end = 0; (end = text.find('\0', at)) != text.npos; at = end + 1) {
    fields.push_back(text.substr(at, end - at));
  }
  std::vector<Fault> faults;
  for (std::size_t i = 0; i + 1 < fields.size(); i += 2)
    faults.push_back({fields[i], fields[i + 1]});
  return faults;
}

}  // namespace grader::intake
