#include "tests/grader/service/intake/intake.h"

#include "grader/base/files.h"
#include "pt/error.h"
#include "pt/file.h"

#include <clocale>
#include <cstddef>

#include <archive.h>

namespace grader::intake {

namespace fs = std::filesystem;

std::string archive_of(const std::vector<Entry>& entries, Format format) {
  std::string bytes(std::size_t{8} << 20, '\0');
  std::size_t used = 0;
  archive* out = archive_write_new();
  if (format == Format::zip || format == Format::zip_stored || format == Format::zip_encrypted) {
    archive_write_set_format_zip(out);
    if (format == Format::zip_stored) archive_write_set_options(out, "zip:compression=store");
    if (format == Format::zip_encrypted) {
      archive_write_set_options(out, "zip:encryption=traditional");
      archive_write_set_passphrase(out, "secret");
    }
  } else if (format == Format::seven_zip) {
    archive_write_set_format_7zip(out);
  } else {
    archive_write_set_format_pax_restricted(out);
    if (format == Format::tar_gz) archive_write_add_filter_gzip(out);
    if (format == Format::tar_xz) archive_write_add_filter_xz(out);
    if (format == Format::tar_zst) archive_write_add_filter_zstd(out);
  }
  archive_write_open_memory(out, bytes.data(), bytes.size(), &used);
  for (const Entry& each : entries) {
    archive_entry* entry = archive_entry_new();
    archive_entry_set_pathname_utf8(entry, each.path.c_str());
    archive_entry_set_filetype(entry, static_cast<unsigned>(each.type));
    archive_entry_set_perm(entry, 0644);
    if (each.type == AE_IFLNK) archive_entry_set_symlink(entry, each.points_to.c_str());
    archive_entry_set_size(entry, static_cast<la_int64_t>(each.text.size()));
    archive_write_header(out, entry);
    archive_write_data(out, each.text.data(), each.text.size());
    archive_entry_free(entry);
  }
  archive_write_close(out);
  archive_write_free(out);
  bytes.resize(used);
  return bytes;
}

void Intake::SetUp() {
  std::setlocale(LC_ALL, "C.UTF-8");
  fs::create_directories(in());
}

void Intake::add(const std::string& path, const std::string& text) const {
  fs::create_directories(in(path).parent_path());
  pt::write_file(in(path), text);
}

std::map<std::string, Intake::Seen> Intake::seen(const fs::path& input) const {
  const auto unpack_here = [this](const std::string& archive, const std::string& folder,
                                  Extent extent) {
    try {
      unpack(archive, folder, extent, limits_);
      return std::string();
    } catch (const pt::Error& error) {
      return std::string(error.what());
    }
  };
  std::map<std::string, Seen> all;
  const HandedInByAll handed = handed_in(input, folder_.path() + "/work", kTasks, unpack_here);
  unclaimed_ = handed.unclaimed;
  work_is_unclaimed_ = handed.work_is_unclaimed;
  for (const HandedIn& each : handed.everybody) {
    Seen one{each.id, each.problem, each.late, each.platform, each.feedback, each.note};
    if (each.problem.empty() && fs::exists(each.folder)) {
      for (const auto& file : fs::recursive_directory_iterator(each.folder)) {
        const bool is_small = file.is_regular_file() && file.file_size() <= 10000;
        if (file.path().extension() != ".cpp" || file.is_symlink() || !is_small) continue;
        one.files[fs::relative(file.path(), each.folder)] = pt::read_file(file.path(), 10000);
      }
    }
    for (const TaskFile& task : kTasks) {
      if (!each.problem.empty()) break;
      const std::string root = base::submission_root(each.folder);
      const base::Submitted read = base::read_submitted(root, task.part, task.slug);
      if (read.present) one.judged[task.slug] = read.rejected.empty() ? read.text : read.rejected;
    }
    EXPECT_TRUE(all.emplace(each.name, one).second) << each.name << " twice";
  }
  return all;
}

}  // namespace grader::intake
