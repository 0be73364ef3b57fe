#include "tests/grader/service/intake/intake.h"

#include "grader/base/files.h"
#include "grader/service/intake/file_name.h"
#include "grader/service/intake/prepare_submission.h"
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
    if (format == Format::tar_bz2) archive_write_add_filter_bzip2(out);
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

const std::vector<NameForm>& known_forms() {
  static const std::vector<NameForm> forms =
      read_name_forms(FIRSTLIGHT_ROOT "/grader/name_forms.csv");
  return forms;
}

namespace {

// Returns what the judge reads in a submission, by task, or why it rejects it.
Files judged_in(const fs::path& folder) {
  Files judged;
  for (const TaskFile& task : kTasks) {
    const std::string root = base::submission_root(folder);
    const base::Submitted read = base::read_submitted(root, task.part, task.slug);
    if (read.present) judged[task.slug] = read.rejected.empty() ? read.text : read.rejected;
  }
  return judged;
}

}  // namespace

void Intake::SetUp() {
  std::setlocale(LC_ALL, "C.UTF-8");
  fs::create_directories(in());
}

void Intake::add(const std::string& path, const std::string& text) const {
  fs::create_directories(in(path).parent_path());
  pt::write_file(in(path), text);
}

std::map<std::string, Intake::Seen> Intake::seen(const fs::path& input) const {
  const Unpack unpack_here = [this](const std::string& archive, const std::string& folder,
                                    Extent extent) {
    try {
      unpack(archive, folder, extent, limits_, forms_);
      return std::string();
    } catch (const pt::Error& error) {
      return std::string(error.what());
    }
  };
  // A clone becomes one task file, its path tracer.
  const Flatten flatten_here = [](const std::string&, const door::Clone& clone,
                                  const std::string& folder) {
    fs::create_directories(folder + "/1_rays");
    pt::write_file(folder + "/1_rays/hit_box.cpp",
                   clone.find("src/pathtracer/pathtracer.cpp")->text);
    return std::string();
  };
  const Readers readers{unpack_here, flatten_here};
  std::map<std::string, Seen> all;
  const HandedInByAll handed = handed_in(input, folder_.path() + "/work", kTasks, readers, forms_);
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
    if (each.problem.empty()) one.judged = judged_in(each.folder);
    one.course = each.course;
    EXPECT_TRUE(all.emplace(each.name, one).second) << each.name << " twice";
  }
  if (fs::is_directory(input)) expect_the_same_at_the_other_doors(input, all, readers);
  return all;
}

// ./run grade takes a folder or an archive, and the autograder of a platform a folder with it.
void Intake::expect_the_same_at_the_other_doors(const fs::path& input,
                                                const std::map<std::string, Seen>& all,
                                                const Readers& readers) const {
  int folders = 0;
  const auto next = [&] { return fs::path(folder_.path()) / "doors" / std::to_string(++folders); };
  for (const auto& entry : fs::directory_iterator(input)) {
    const fs::path& path = entry.path();
    const auto row = all.find(entry.is_directory() ? path.filename() : path.stem());
    const bool is_work = entry.is_directory() || is_archive(path.filename());
    if (!is_work || entry.is_symlink() || row == all.end() || !row->second.id.empty()) continue;
    // Whose row it is, is not known here.
    const bool is_one_of_two = row->second.problem.starts_with("there is another");
    if (is_one_of_two || all.contains(row->first + " (2)")) continue;
    std::vector<fs::path> doors{path};
    if (!entry.is_directory()) {
      doors.push_back(next());
      fs::create_directories(doors[1]);
      fs::copy_file(path, doors[1] / path.filename());
    }
    for (const fs::path& door : doors) {
      const Prepared taken = prepare_submission("it", door, {kTasks, readers, next});
      EXPECT_EQ(taken.problem, row->second.problem) << door;
      EXPECT_EQ(taken.note, row->second.note) << door;
      EXPECT_EQ(taken.course, row->second.course) << door;
      const Files judged = taken.problem.empty() ? judged_in(taken.folder) : Files();
      EXPECT_EQ(judged, row->second.judged) << door;
    }
  }
  fs::remove_all(fs::path(folder_.path()) / "doors");
}

}  // namespace grader::intake
