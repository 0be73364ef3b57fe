// Archives are read as data: a broken, huge or malicious archive is a problem of its owner alone.
#include "pt/error.h"
#include "pt/file.h"
#include "tests/grader/service/intake/intake.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <archive_entry.h>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

namespace grader::intake {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

TEST_F(Intake, archives_in_archives_are_unpacked_to_a_depth) {
  std::string bytes = archive_of({{"hit_box.cpp", "a"}});
  for (int depth = 1; depth <= 6; ++depth) {
    add(std::to_string(depth) + ".zip", bytes);
    bytes = archive_of({{"inner.zip", bytes}});
  }
  auto all = seen();
  for (const char* name : {"1", "2", "3", "4"}) {
    EXPECT_EQ(all[name].files, (Files{{"hit_box.cpp", "a"}})) << name;
  }
  for (const char* name : {"5", "6"}) EXPECT_THAT(all[name].problem, HasSubstr("deep")) << name;
}

TEST_F(Intake, two_archives_and_no_file_cannot_be_chosen_from) {
  add("bob/hit_box.cpp", "b");
  add("ada/first.zip", archive_of({{"hit_box.cpp", "1"}}));
  add("ada/second.zip", archive_of({{"hit_box.cpp", "2"}}));
  EXPECT_THAT(seen()["ada"].problem, HasSubstr("2 archives, 'first.zip' and 'second.zip'"));
  add("ada/hit_box.cpp", "3");
  EXPECT_EQ(seen()["ada"].files, (Files{{"hit_box.cpp", "3"}})) << "files beside archives count";
}

TEST_F(Intake, nothing_lands_outside_and_nothing_is_linked) {
  add("evil.zip", archive_of({{"../../evil.cpp", "x"},
                              {"a/../../../evil.cpp", "x"},
                              {"/tmp/firstlight_evil.cpp", "x"},
                              {"..\\..\\evil.cpp", "x"},
                              {"hit_box.cpp", "", AE_IFLNK, "/etc/passwd"},
                              {"link", "", AE_IFLNK, "/tmp"},
                              {"link/firstlight_evil.cpp", "in a folder of its own"},
                              {"hit_sphere.cpp", "first"},
                              {"hit_sphere.cpp", "second"},
                              {"hit_sphere.cpp/inner.cpp", "a file is not a folder"}}));
  add("ugly.tar.gz",
      archive_of({{"a/../../../evil.cpp", "x"}, {"ok.cpp", "", AE_IFIFO, ""}}, Format::tar_gz));
  fs::create_symlink("/etc", in("linked"));
  auto all = seen();
  EXPECT_EQ(all["ugly"].judged, (Files{}));
  Files& files = all["evil"].files;
  EXPECT_EQ(files.size(), 5U);
  EXPECT_EQ(files["hit_sphere.cpp"], "second");
  EXPECT_EQ(files["the earlier of two/hit_sphere.cpp"], "first");
  EXPECT_EQ(files["link/firstlight_evil.cpp"], "in a folder of its own");
  EXPECT_THAT(files["hit_box.cpp"], testing::StartsWith("#error \"in the archive"));
  EXPECT_THAT(all["linked"].problem, HasSubstr("link"));
  EXPECT_FALSE(fs::exists("/tmp/firstlight_evil.cpp"));
  for (const auto& file : fs::recursive_directory_iterator(folder_.path())) {
    if (file.path().filename() != "evil.cpp") continue;
    EXPECT_THAT(pt::read_file(file.path()), HasSubstr("leads out")) << file.path();
  }
}

TEST_F(Intake, what_is_broken_or_too_large_has_a_reason_and_the_others_are_there) {
  limits_ = kSmall;
  const std::string good = archive_of({{"hit_box.cpp", std::string(5000, 'a')}, {"b.cpp", "b"}});
  add("cut.zip", good.substr(0, good.size() / 3));
  add("empty.zip", "");
  add("text.zip", "this is not an archive");
  std::vector<Entry> bomb;
  for (int i = 0; i < 3; ++i) {
    bomb.push_back({std::to_string(i) + ".cpp", std::string(std::size_t{1} << 20, '\0')});
  }
  add("bomb.zip", archive_of(bomb));
  std::vector<Entry> many;
  for (int i = 0; i < 21; ++i) many.push_back({std::to_string(i) + ".cpp", ""});
  add("many.zip", archive_of(many));
  add("good.zip", good);
  auto all = seen();
  EXPECT_EQ(all["good"].problem, "");
  for (const char* name : {"cut", "empty", "text", "bomb", "many"}) {
    EXPECT_THAT(all[name].problem, HasSubstr("cannot be unpacked")) << name;
  }
  EXPECT_THAT(all["bomb"].problem, HasSubstr("larger than 2 MiB"));
  EXPECT_THAT(all["many"].problem, HasSubstr("more than 20 files"));
}

TEST_F(Intake, every_cut_and_many_damages_end_with_a_reason_or_files) {
  for (const Format format : {Format::zip, Format::tar_gz}) {
    const std::string good =
        archive_of({{"hit_box.cpp", "int main() { return 0; }"}, {"x/b.cpp", "b"}}, format);
    for (std::size_t i = 0; i < good.size(); ++i) {
      for (const std::string& bytes : {good.substr(0, i), [&] {
                                         std::string other = good;
                                         other[i] = static_cast<char>(other[i] ^ 0x55);
                                         return other;
                                       }()}) {
        pt::write_file(folder_.path() + "/a.zip", bytes);
        const std::string out = folder_.path() + "/out";
        try {
          unpack(folder_.path() + "/a.zip", out);
        } catch (const pt::Error& error) {
          EXPECT_THAT(error.what(), HasSubstr("cannot be unpacked"));
        }
        fs::remove_all(out);
      }
    }
  }
}

// A file that no platform exports belongs to nobody, and the other submissions are judged.
TEST_F(Intake, what_is_left_out_is_said) {
  add("absolute.zip", archive_of({{"/home/ada/hit_box.cpp", "a"}}));
  add("parent.zip", archive_of({{"../hit_box.cpp", "a"}, {"a/..\\hit_sphere.cpp", "a"}}));
  add("both.zip", archive_of({{"../hit_box.cpp", "a"}, {"hit_sphere.cpp", "b"}}));
  add("outside.zip", archive_of({{"../hit_box.cpp", "a"}, {"work/hit_box.cpp", "b"}}));
  add("hidden.zip", archive_of({{".a/hit_box.cpp", "a"}}));
  add("link.tar.gz", archive_of({{"hit_box.cpp", "", AE_IFLNK, "/etc/passwd"},
                                 {"hit_sphere.cpp", "s"},
                                 {"notes", "", AE_IFLNK, "/tmp"}},
                                Format::tar_gz));
  add("links.zip", archive_of({{"hit_box.cpp", "", AE_IFLNK, "/etc/passwd"}, {"notes.txt", "n"}}));
  fs::create_directories(in("linked"));
  fs::create_directory_symlink("/etc", in("linked/student"));
  auto all = seen();
  for (const char* name : {"absolute", "parent"}) {
    EXPECT_THAT(all[name].problem, HasSubstr("its paths are absolute or lead out of it"));
  }
  EXPECT_EQ(all["both"].judged["hit_sphere"], "b");
  EXPECT_THAT(all["both"].judged["hit_box"], HasSubstr("the path of this file leads out of it"));
  EXPECT_EQ(all["outside"].judged, (Files{{"hit_box", "b"}})) << "it is there besides";
  EXPECT_THAT(all["hidden"].problem, HasSubstr("it is empty"));
  EXPECT_THAT(all["link"].judged["hit_box"], HasSubstr("this is a link or a device"));
  EXPECT_EQ(all["link"].files.size(), 2U);
  EXPECT_THAT(all["links"].problem, HasSubstr("its source files are links"));
  EXPECT_THAT(all["linked"].problem, testing::EndsWith("only 'student' (a link)"));
}

// A class as Canvas and Moodle pack it: the bounds for one learner do not apply to all together.
TEST_F(Intake, the_archive_of_a_class_has_the_bounds_of_a_class) {
  limits_ = kSmall;
  std::vector<Entry> entries;
  for (int learner = 0; learner < 30; ++learner) {
    for (int file = 0; file < 3; ++file) {
      const std::string name = file == 0 ? "hit_box" : "other_" + std::to_string(file);
      entries.push_back(
          {fmt::format("class/learner_{}_{}_{}.cpp", learner, learner * 3 + file, name),
           std::to_string(learner)});
    }
  }
  pt::write_file(in("class.zip"), archive_of(entries));
  auto all = seen(in("class.zip"));
  EXPECT_EQ(all.size(), 30U);
  EXPECT_EQ(all["learner (17)"].files["hit_box.cpp"], "17");
  limits_.everybody.files = 89;
  EXPECT_THAT([&] { seen(in("class.zip")); },
              testing::ThrowsMessage<pt::Error>(HasSubstr("more than 89 files")));
  limits_.everybody = kBoundsOfEverybody;
  limits_.everybody.entries = 89;
  EXPECT_THAT([&] { seen(in("class.zip")); },
              testing::ThrowsMessage<pt::Error>(HasSubstr("more than 89 entries")));
}

TEST_F(Intake, a_thousand_learners_are_within_the_bounds) {
  const Limits usual;
  EXPECT_GE(usual.everybody.files, 12 * 1000);
  EXPECT_GE(usual.everybody.entries, usual.everybody.files);
  EXPECT_GE(usual.everybody.bytes, 20 * usual.one.bytes);
  EXPECT_EQ(usual.one.files, 5000);
  EXPECT_EQ(usual.one.bytes, std::uint64_t{64} << 20);
}

TEST_F(Intake, each_owner_in_the_archive_of_a_class_has_the_bounds_of_one) {
  limits_ = kSmall;
  std::vector<Entry> entries{{"ada/hit_box.cpp", "a"}};
  for (int i = 0; i < 21; ++i) entries.push_back({fmt::format("bob/{}.cpp", i), ""});
  entries.push_back({"cy/hit_box.cpp", "c"});
  for (int i = 0; i < 3; ++i) {
    entries.push_back({fmt::format("di/{}.cpp", i), std::string(std::size_t{1} << 20, '\0')});
  }
  entries.push_back({"eve/hit_box.cpp", "e"});
  pt::write_file(in("class.zip"), archive_of(entries));
  auto all = seen(in("class.zip"));
  EXPECT_EQ(all.size(), 5U);
  EXPECT_THAT(all["bob"].problem, HasSubstr("more than 20 files"));
  EXPECT_THAT(all["di"].problem, HasSubstr("larger than 2 MiB"));
  for (const char* name : {"ada", "cy", "eve"}) {
    EXPECT_EQ(all[name].problem, "") << name;
    EXPECT_EQ(all[name].files.size(), 1U) << name;
  }
}

TEST_F(Intake, everybody_in_the_archive_of_a_class_has_a_row) {
  pt::write_file(in("class.tar.gz"), archive_of({{"ada/hit_box.cpp", "a"},
                                                 {"bob/work.gz", "?"},
                                                 {"cy/report.pdf", "?"},
                                                 {"di/hit_box.CPP", "d"},
                                                 {"eve/onlinetext.html", "?"},
                                                 {"fay", "", AE_IFDIR},
                                                 {"gus", "", AE_IFLNK, "/etc"},
                                                 {"hal/hit_box.cpp", "", AE_IFLNK, "/etc/passwd"},
                                                 {"ida.gz", "?"},
                                                 {"jo\xc3\xab/.DS_Store", "?"},
                                                 {"jo\xc3\xab/__MACOSX/._hit_box.cpp", "?"},
                                                 {"__MACOSX/ada/._hit_box.cpp", "?"},
                                                 {".DS_Store", "?"}},
                                                Format::tar_gz));
  auto all = seen(in("class.tar.gz"));
  EXPECT_EQ(all.size(), 10U);
  EXPECT_EQ(all["ada"].problem, "");
  EXPECT_THAT(all["bob"].problem, HasSubstr("only 'work.gz'"));
  EXPECT_THAT(all["bob"].problem, HasSubstr("hand in a zip"));
  EXPECT_THAT(all["cy"].problem, HasSubstr("only 'report.pdf'"));
  EXPECT_EQ(all["di"].files, (Files{{"1_rays/hit_box.cpp", "d"}}));
  EXPECT_THAT(all["eve"].problem, HasSubstr("only 'onlinetext.html'"));
  EXPECT_THAT(all["fay"].problem, HasSubstr("it is empty"));
  EXPECT_THAT(all["gus"].problem, HasSubstr("link"));
  EXPECT_THAT(all["hal"].problem, HasSubstr("its source files are links"));
  EXPECT_THAT(all["ida"].problem, HasSubstr("hand in a zip"));
  EXPECT_THAT(all["jo\xc3\xab"].problem, HasSubstr("it is empty")) << "hidden files only";
}

// Returns the bytes of an archive in which the bytes after a text are replaced.
std::string damaged(std::string bytes, const std::string& after, std::size_t from, std::size_t to) {
  const std::size_t at = bytes.find(after) + after.size();
  for (std::size_t i = at + from; i < at + to; ++i) bytes[i] = static_cast<char>(~bytes[i]);
  return bytes;
}

// Text that hardly compresses.
std::string any_text(std::size_t size) {
  std::string text;
  for (unsigned state = 1; text.size() < size; state = state * 1664525U + 1013904223U) {
    text += static_cast<char>(' ' + (state >> 25) % 90);
  }
  return text;
}

std::string bytes_of(const std::string& hex) {
  std::string bytes;
  for (std::size_t i = 0; i + 1 < hex.size(); i += 2) {
    bytes += static_cast<char>(std::stoi(hex.substr(i, 2), nullptr, 16));
  }
  return bytes;
}

TEST_F(Intake, a_bad_entry_in_the_archive_of_a_class_is_its_owners) {
  const std::vector<Entry> entries{{"ada/hit_box.cpp", any_text(3000)},
                                   {"bob/hit_box.cpp", any_text(3000)},
                                   {"cy/hit_box.cpp", "c"}};
  for (const Format format : {Format::zip, Format::zip_stored}) {
    const std::string bytes = archive_of(entries, format);
    // The first of the name's two places is in front of the data.
    pt::write_file(in("class.zip"), damaged(bytes, "bob/hit_box.cpp", 500, 700));
    auto all = seen(in("class.zip"));
    EXPECT_EQ(all.size(), 3U);
    EXPECT_EQ(all["ada"].files.size(), 1U) << all["ada"].problem;
    EXPECT_THAT(all["bob"].problem, HasSubstr("'hit_box.cpp' cannot be unpacked"));
    EXPECT_EQ(all["cy"].files, (Files{{"hit_box.cpp", "c"}}));
    pt::write_file(in("class.zip"), bytes.substr(0, bytes.size() / 2));
    EXPECT_THAT([&] { seen(in("class.zip")); },
                testing::ThrowsMessage<pt::Error>(HasSubstr("cannot be unpacked")))
        << "the archive ends";
  }
}

// An archive with an entry that zlib cannot read to its end; libarchive's reader stops there.
std::string with_ends(std::string bytes, const std::string& name) {
  for (std::size_t at = 0; (at = bytes.find("PK\3\4", at)) != bytes.npos; ++at) {
    const auto size = [&](std::size_t place) {
      return static_cast<unsigned char>(bytes[at + place]) +
             256U * static_cast<unsigned char>(bytes[at + place + 1]);
    };
    if (bytes.compare(at + 30, name.size(), name) != 0) continue;
    bytes[at + 30 + size(26) + size(28)] = 7;  // a block type that does not exist
  }
  return bytes;
}

TEST_F(Intake, an_entry_that_ends_the_reader_is_its_owners_up_to_a_number) {
  std::vector<Entry> entries{{"ada/hit_box.cpp", any_text(300)}};
  for (int i = 0; i < 200; ++i) entries.push_back({fmt::format("bob/{}.cpp", i), any_text(300)});
  entries.push_back({"cy/hit_box.cpp", "c"});
  pt::write_file(in("class.zip"), with_ends(archive_of(entries), "bob/1.cpp"));
  auto all = seen(in("class.zip"));
  EXPECT_THAT(all["bob"].problem, HasSubstr("'1.cpp' cannot be unpacked"));
  EXPECT_EQ(all["ada"].files.size(), 1U);
  EXPECT_EQ(all["cy"].files, (Files{{"hit_box.cpp", "c"}}));
  for (int i = 0; i < 201; ++i) entries.push_back({fmt::format("z{}/a.cpp", i), any_text(300)});
  pt::write_file(in("class.zip"), with_ends(archive_of(entries), "z"));
  EXPECT_THAT([&] { seen(in("class.zip")); },
              testing::ThrowsMessage<pt::Error>(HasSubstr("damaged in many places")));
}

TEST_F(Intake, all_that_is_read_counts_also_what_is_left_out) {
  pt::write_file(in("class.tar.gz"), archive_of({{"ada/hit_box.cpp", any_text(3000)},
                                                 {"ada/film.mov", std::string(100'000, '\0')},
                                                 {"bob/hit_box.cpp", "b"}},
                                                Format::tar_gz));
  EXPECT_EQ(seen(in("class.tar.gz")).size(), 2U);
  limits_.everybody.unpacked = 50'000;
  EXPECT_THAT([&] { seen(in("class.tar.gz")); },
              testing::ThrowsMessage<pt::Error>(HasSubstr("it is larger than")));
  limits_.everybody = kBoundsOfEverybody;
  limits_.everybody.bytes = 3000;
  EXPECT_THAT([&] { seen(in("class.tar.gz")); },
              testing::ThrowsMessage<pt::Error>(HasSubstr("its files are larger than")));
}

TEST_F(Intake, an_encrypted_entry_is_its_owners) {
  std::string bytes = archive_of({{"ada/hit_box.cpp", "a"}, {"bob/hit_box.cpp", "b"}});
  // The encryption bit is 24 bytes before the name at the file, and 38 in the directory at the end.
  const std::size_t first = bytes.find("bob/"), last = bytes.rfind("bob/");
  bytes[first - 24] |= 1;
  bytes[last - 38] |= 1;
  pt::write_file(in("class.zip"), bytes);
  auto all = seen(in("class.zip"));
  EXPECT_EQ(all["ada"].files, (Files{{"hit_box.cpp", "a"}}));
  EXPECT_THAT(all["bob"].problem, HasSubstr("encrypted"));
}

TEST_F(Intake, usual_compressions_are_unpacked) {
  const std::vector<Entry> entries{{"hit_box.cpp", "a"}};
  add("xz.tar.xz", archive_of(entries, Format::tar_xz));
  add("seven.7z", archive_of(entries, Format::seven_zip));
  add("locked.zip", archive_of(entries, Format::zip_encrypted));
  // A RAR 4 archive of hit_box.cpp with the text "int x;\n", not compressed.
  add("rar.rar",
      bytes_of("526172211a0700cf907300000d00000000000000e1437400802b000700000007000000039d6e599b000"
               "0215a14300b00a48100006869745f626f782e637070696e7420783b0ac43d7b00400700"));
  auto all = seen();
  EXPECT_EQ(all["xz"].files, (Files{{"hit_box.cpp", "a"}}));
  EXPECT_EQ(all["seven"].files, (Files{{"hit_box.cpp", "a"}}));
  EXPECT_EQ(all["rar"].files, (Files{{"hit_box.cpp", "int x;\n"}})) << all["rar"].problem;
  EXPECT_THAT(all["locked"].problem, HasSubstr("encrypted"));
}

// Archives as other programs and other systems make them, and archives that were made by mistake.
TEST_F(Intake, what_surrounds_an_archive_does_not_matter) {
  const std::string good = archive_of({{"hit_box.cpp", "a"}});
  add("self_extracting.zip", "MZ" + std::string(5000, 'x') + good);
  add("document.zip", "%PDF-1.4\n" + good + "\n%%EOF");
  add("longer.zip", good + std::string(3000, '\0'));
  add("twice.zip", archive_of({{"hit_box.cpp", "old"}}) + good);
  for (const Format format :
       {Format::tar_gz, Format::tar_zst, Format::tar_bz2, Format::seven_zip}) {
    add("otherwise" + std::to_string(static_cast<int>(format)) + ".zip",
        archive_of({{"hit_box.cpp", "a"}}, format));
  }
  const auto all = seen();
  EXPECT_EQ(all.size(), 8U);
  for (const auto& [name, one] : all) {
    EXPECT_EQ(one.files, (Files{{"hit_box.cpp", "a"}})) << name << one.problem;
  }
}

TEST_F(Intake, names_of_other_systems_are_names) {
  add("mixed.zip",
      archive_of({{"work\\1_rays/hit_box.cpp", "a"}, {"work/2_bvh\\hit_bvh.cpp", "b"}}));
  add("drive.zip", archive_of({{"C:\\mine\\hit_box.cpp", "a"}, {"C:/mine/hit_bvh.cpp", "b"}}));
  add("dots.zip", archive_of({{"./hit_box.cpp", "a"}, {"a//hit_bvh.cpp", "b"}}));
  add("control.zip", archive_of({{"a\x1b[2J\t/hit_box.cpp", "a"}, {"hit_bvh.cpp", "b"}}));
  add("deep.zip", archive_of({{"hit_bvh.cpp", "b"},
                              {[] {
                                 std::string path;
                                 for (int i = 0; i < 200; ++i) path += "a/";
                                 return path + "hit_box.cpp";
                               }(),
                               "a"}}));
  const std::string long_name(5000, 'n');
  add("long.zip", archive_of({{"hit_bvh.cpp", "b"}, {long_name + "/hit_box.cpp", "a"}}));
  const auto all = seen();
  for (const auto& [name, one] : all) {
    EXPECT_EQ(one.judged, (Files{{"hit_box", "a"}, {"hit_bvh", "b"}})) << name << one.problem;
  }
}

// A name that differs in nothing that is seen, or in case, or is written twice.
TEST_F(Intake, files_that_look_alike_are_told_apart) {
  add("unseen.zip", archive_of({{"hit\xe2\x80\x8b_box.cpp", "a"}, {"hit_bvh.cpp", "b"}}));
  add("wide.zip", archive_of({{"hit_box\xc2\xa0.cpp", "a"}, {"hit_bvh.cpp", "b"}}));
  add("case.zip", archive_of({{"hit_box.cpp", "a"}, {"HIT_BOX.CPP", "b"}}));
  add("twice.zip", archive_of({{"w/hit_box.cpp", "old"}, {"w/hit_box.cpp", "new"}}));
  add("thrice.zip", archive_of({{"Hit_Box.cpp", "1"}, {"Hit_Box.cpp", "2"}, {"Hit_Box.cpp", "3"}}));
  add("equal.zip", archive_of({{"hit_box.cpp", "a"}, {"hit_box.cpp", "a"}}));
  auto all = seen();
  EXPECT_THAT(all["unseen"].note, HasSubstr("does not count, as it is not named hit_box.cpp"));
  EXPECT_THAT(all["wide"].note, HasSubstr("does not count, as it is not named hit_box.cpp"));
  EXPECT_EQ(all["case"].note, "'hit_box.cpp' counts, and not 'HIT_BOX.CPP', which differs");
  EXPECT_EQ(all["twice"].judged["hit_box"], "new") << all["twice"].problem;
  EXPECT_EQ(all["twice"].note,
            "'w/hit_box.cpp' counts, and not 'w/the earlier of two/hit_box.cpp', which differs");
  EXPECT_EQ(all["thrice"].judged["hit_box"], "3") << all["thrice"].problem;
  EXPECT_THAT(all["thrice"].note, HasSubstr("the earlier of two"));
  EXPECT_EQ(all["equal"].note, "");
}

TEST_F(Intake, parts_of_an_archive_are_not_an_archive) {
  add("ada/work.zip.001", "?");
  add("ada/work.zip.002", "?");
  add("bob.z01", "?");
  add("cy/cut.tar.gz",
      archive_of({{"hit_box.cpp", any_text(5000)}}, Format::tar_gz).substr(0, 900));
  auto all = seen();
  EXPECT_THAT(all["ada"].problem, HasSubstr("only 'work.zip.001', which cannot be unpacked here"));
  EXPECT_THAT(all["bob"].problem, HasSubstr("cannot be unpacked here; hand in a zip"));
  EXPECT_THAT(all["cy"].problem, HasSubstr("'cut.tar.gz' cannot be unpacked"));
}

TEST_F(Intake, what_cannot_be_read_is_one_problem) {
  if (geteuid() == 0) GTEST_SKIP() << "root reads everything";
  add("ada/hit_box.cpp", "a");
  add("bob/1_rays/hit_box.cpp", "b");
  add("cy_7_8_hit_box.cpp", "c");
  fs::permissions(in("bob/1_rays"), fs::perms::none);
  fs::permissions(in("cy_7_8_hit_box.cpp"), fs::perms::none);
  auto all = seen();
  fs::permissions(in("bob/1_rays"), fs::perms::owner_all);
  EXPECT_EQ(all.size(), 3U);
  EXPECT_EQ(all["ada"].problem, "");
  EXPECT_THAT(all["bob"].problem, HasSubstr("'1_rays' cannot be read"));
  EXPECT_THAT(all["cy"].problem, HasSubstr("cannot be read"));
}

}  // namespace
}  // namespace grader::intake
