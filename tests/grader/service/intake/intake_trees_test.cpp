// The task files of a submission are found wherever they are.
#include "pt/error.h"
#include "tests/grader/service/intake/intake.h"

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

namespace grader::intake {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

TEST_F(Intake, folders_and_archives_of_any_name_are_submissions) {
  add("ada/1_rays/hit_box.cpp", "a");
  add("bob.zip", archive_of({{"tree/student/1_rays/hit_box.cpp", "b"}, {"tree/notes.txt", "n"}}));
  add("Łukasz 北.tar.gz", archive_of({{"hit_box.cpp", "c"}}, Format::tar_gz));
  add("notes.txt", "of the instructor");
  auto all = seen();
  ASSERT_EQ(all.size(), 3U);
  EXPECT_EQ(all["ada"].files, (Files{{"1_rays/hit_box.cpp", "a"}}));
  EXPECT_EQ(all["bob"].files, (Files{{"student/1_rays/hit_box.cpp", "b"}}));
  EXPECT_EQ(all["Łukasz 北"].files, (Files{{"hit_box.cpp", "c"}}));
}

TEST_F(Intake, clones_of_the_course_are_submissions) {
  const char* const kTracer = "src/pathtracer/pathtracer.cpp";
  const std::vector<Entry> clone{{std::string("p1/") + kTracer, "b"},
                                 {"p1/src/pathtracer/pathtracer.h", "Spectrum"}};
  add(std::string("ada/") + kTracer, "a");
  add("ada/src/scene/hit_sphere.cpp", "a file of the clone, whatever its name");
  add("bob.zip", archive_of(clone));
  add("cem/deep/p1.tar.gz", archive_of(clone, Format::tar_gz));
  add("dia/repo/p1/src/pathtracer/pathtracer.cpp", "d");
  add("dia/readme.txt", "my report");
  add(std::string("eve/p1/") + kTracer, "of another course");
  add("eve/hit_triangle.cpp", "e");
  add(std::string("fay/old/") + kTracer, "f");
  add(std::string("fay/new/") + kTracer, "f");
  auto all = seen();
  ASSERT_EQ(all.size(), 6U);
  for (const auto& [name, text] : Files{{"ada", "a"}, {"bob", "b"}, {"cem", "b"}, {"dia", "d"}}) {
    EXPECT_EQ(all[name].judged, (Files{{"hit_box", text}})) << name;
    EXPECT_EQ(door::year_of(*all[name].course), text == "b" ? "2020" : "2022") << name;
  }
  EXPECT_EQ(all["eve"].judged, (Files{{"hit_triangle", "e"}}));
  EXPECT_FALSE(all["eve"].course);
  EXPECT_EQ(all["fay"].problem,
            "it has 2 clones of the course's skeleton, 'new' and 'old' among them; keep one");
}

TEST_F(Intake, the_last_attempt_counts_whether_it_is_a_clone_or_not) {
  const std::vector<Entry> clone{{"p1/src/pathtracer/pathtracer.cpp", "a clone"}};
  const std::string first = "Ada_1_assignsubmission_file_/",
                    second = "Bob_2_assignsubmission_file_/";
  add(first + "p1.zip", archive_of(clone));
  add(second + "hit_box.cpp", "b");
  add(second + "p1.zip", archive_of(clone));
  auto all = seen();
  EXPECT_EQ(all["Ada"].judged, (Files{{"hit_box", "a clone"}}));
  EXPECT_EQ(all["Bob"].judged, (Files{{"hit_box", "b"}}));
  EXPECT_EQ(all["Bob"].note, "the clone in 'p1.zip' beside the files does not count");
}

TEST_F(Intake, a_submission_that_is_hidden_is_named) {
  add("ada/hit_box.cpp", "a");
  add(".bob/1_rays/hit_box.cpp", "b");
  add(".cy.zip", archive_of({{"hit_box.cpp", "c"}}));
  add(".git/HEAD", "?");
  add("__MACOSX/._ada/._hit_box.cpp", "?");
  EXPECT_EQ(seen().size(), 1U);
  EXPECT_THAT(unclaimed_, testing::ElementsAre(".bob", ".cy.zip"));
  EXPECT_TRUE(work_is_unclaimed_);
}

TEST_F(Intake, an_empty_class_is_said_to_be_one) {
  EXPECT_THAT([&] { seen(); },
              testing::ThrowsMessage<pt::Error>(HasSubstr("has no submissions in it")));
}

TEST_F(Intake, pipes_and_devices_are_nobodys) {
  add("ada/hit_box.cpp", "a");
  ASSERT_EQ(mkfifo(in("bob_1_2_hit_box.cpp").c_str(), 0600), 0);
  ASSERT_EQ(mkfifo(in("carol.zip").c_str(), 0600), 0);
  const auto all = seen();
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all.begin()->first, "ada");
  EXPECT_EQ(unclaimed_, (std::vector<std::string>{"bob_1_2_hit_box.cpp", "carol.zip"}));
}

TEST_F(Intake, files_of_nobody_may_be_work) {
  add("ada/hit_box.cpp", "a");
  add("index.html", "of the platform");
  seen();
  EXPECT_FALSE(work_is_unclaimed_);
  for (const char* name :
       {"hit_box.cpp", "hit_box.cpp.txt", "main.CPP", "hit_box.cc", "HitBox final"}) {
    add(name, "?");
    seen();
    EXPECT_TRUE(work_is_unclaimed_) << name;
    fs::remove(in(name));
  }
}

TEST_F(Intake, folders_around_everything_are_entered) {
  add("export/handed in/ada/hit_box.cpp", "a");
  add("export/handed in/bob/student/1_rays/hit_box.cpp", "b");
  EXPECT_EQ(seen().size(), 2U);
}

TEST_F(Intake, a_folder_around_one_learner_is_not_the_learner) {
  for (const std::string name : {"Ada_7_assignsubmission_file_/hit_box.cpp",
                                 "Ada_7_900_hit_box.cpp", "Ada_7_900_work.zip"}) {
    fs::remove_all(in());
    add("export/" + name,
        name.ends_with(".zip") ? archive_of({{"hit_box.cpp", "a"}}) : std::string("a"));
    auto all = seen();
    ASSERT_EQ(all.size(), 1U) << name;
    EXPECT_EQ(all["Ada"].id, "7") << name;
    EXPECT_EQ(all["Ada"].judged, (Files{{"hit_box", "a"}})) << name;
  }
}

// An example to hand in, or a class that is a repository, does not make everything one submission.
TEST_F(Intake, a_task_file_beside_the_learners_does_not_hide_them) {
  add("export/hit_box.cpp", "?");
  add("export/.git/HEAD", "?");
  add("export/ada/hit_box.cpp", "a");
  add("export/bob.zip", archive_of({{"hit_box.cpp", "b"}}));
  EXPECT_EQ(seen().size(), 2U);
  EXPECT_EQ(unclaimed_, (std::vector<std::string>{"hit_box.cpp"}));
  // A learner's folder may contain one more folder.
  fs::remove_all(in("export"));
  add("ada/hit_box.cpp", "a");
  add("ada/1_rays/hit_sphere.cpp", "a");
  add("ada/2_bvh/hit_bvh.cpp", "a");
  add("ada/old/1_rays/hit_box.cpp", "old");
  EXPECT_EQ(seen().size(), 1U);
}

TEST_F(Intake, the_folder_of_one_learner_is_not_entered) {
  add("ada/1_rays/hit_box.cpp", "a");
  add("ada/notes.txt", "?");
  EXPECT_EQ(seen()["ada"].files, (Files{{"1_rays/hit_box.cpp", "a"}}));
  EXPECT_EQ(seen().size(), 1U);
}

TEST_F(Intake, task_files_are_found_however_deep) {
  const std::map<std::string, std::vector<Entry>> packed{
      {"src", {{"README.md", "r"}, {"src/1_rays/hit_box.cpp", "s"}}},
      {"include", {{"src/hit_box.cpp", "s"}, {"include/a.h", "h"}}},
      {"clone",
       {{"README.md", "r"},
        {"firstlight/pt/a.h", "h"},
        {"firstlight/grader/mistakes/hit_box.cpp", "not this"},
        {"firstlight/student/1_rays/hit_box.cpp", "s"}}},
      {"stray", {{"main.cpp", "m"}, {"work.zip", archive_of({{"hit_box.cpp", "s"}})}}},
      {"both", {{"hit_box.cpp", "s"}, {"old/hit_box.cpp", "not this"}}},
      {"two", {{"a/hit_box.cpp", "s"}, {"b/hit_box.cpp", "t"}}}};
  for (const bool as_zip : {true, false}) {
    fs::remove_all(in());
    for (const auto& [name, entries] : packed) {
      if (as_zip) add(name + ".zip", archive_of(entries));
      for (const Entry& each : entries) {
        if (!as_zip) add(name + "/" + each.path, each.text);
      }
    }
    auto all = seen();
    for (const char* name : {"src", "include", "clone", "stray", "both"}) {
      EXPECT_EQ(all[name].judged, (Files{{"hit_box", "s"}})) << name << all[name].problem;
    }
    EXPECT_THAT(all["two"].problem, HasSubstr("'a/hit_box.cpp' and 'b/hit_box.cpp'"));
  }
}

TEST_F(Intake, files_that_are_nearly_named_right_count) {
  add("ada/hit_sphere-1.cpp", "s");
  add("ada/Hit_Box.CPP", "b");
  add("ada/hit_triangle (1).cpp", "t");
  add("ada/2_bvh/hit_bvh.cpp.txt", "v");
  add("bob/hit_box (1).cpp", "1");
  add("bob/hit_box (2).cpp", "2");
  add("cy/hit_box.cpp", "right");
  add("cy/hit_box-1.cpp", "left");
  auto all = seen();
  EXPECT_EQ(all["ada"].files, (Files{{"1_rays/hit_sphere.cpp", "s"},
                                     {"1_rays/hit_box.cpp", "b"},
                                     {"1_rays/hit_triangle.cpp", "t"},
                                     {"2_bvh/hit_bvh.cpp", "v"}}));
  EXPECT_THAT(all["bob"].problem, HasSubstr("'hit_box (1).cpp' and 'hit_box (2).cpp' may both be"));
  EXPECT_EQ(all["cy"].files["hit_box.cpp"], "right");
  EXPECT_EQ(all["cy"].note, "'hit_box.cpp' counts, and not 'hit_box-1.cpp', which differs");
  EXPECT_EQ(all["ada"].note, "");
}

TEST_F(Intake, what_counts_of_several_files_is_said) {
  const std::string packed = archive_of({{"a/hit_box.cpp", "packed"}, {"hit_sphere.cpp", "s"}});
  add("ada/hit_box.cpp", "loose");
  add("ada/rest.zip", packed);
  add("bob/hit_box.cpp", "loose");
  add("bob/old/hit_box.cpp", "old");
  add("bob/same/hit_box.cpp", "loose");
  add("cy/hit_box.cpp", "c");
  add("cy/rest.zip", "broken");
  add("di/hit_box.cpp", "d");
  add("di/1.zip", packed);
  add("di/2.zip", packed);
  add("eve/hit_box.cpp", "e");
  add("eve/report.zip", archive_of({{"report.pdf", "?"}}));
  auto all = seen();
  EXPECT_EQ(all["ada"].judged, (Files{{"hit_box", "loose"}, {"hit_sphere", "s"}}));
  EXPECT_EQ(all["ada"].note,
            "hit_sphere from 'rest.zip' beside the other files counts; hit_box in 'rest.zip' does "
            "not count, as the file beside it does");
  EXPECT_EQ(all["bob"].note, "'hit_box.cpp' counts, and not 'old/hit_box.cpp', which differs");
  EXPECT_EQ(all["cy"].judged, (Files{{"hit_box", "c"}}));
  EXPECT_THAT(all["cy"].note, HasSubstr("'rest.zip' beside the files does not count: "));
  EXPECT_THAT(
      all["di"].note,
      HasSubstr("it holds 2 archives, '1.zip' and '2.zip' among them, of which none is read"));
  EXPECT_EQ(all["eve"].note, "");
}

// Systems in other languages have other words for a copy, and people for the last version.
TEST_F(Intake, a_name_that_is_nearly_right_is_taken_where_it_is_the_only_one) {
  for (const char* name :
       {"hit_box.cc", "Hit-Box.cxx", "hit_box - Kopie.cpp", "hit_box - Copie (2).cpp",
        "hitbox - copia.cc.txt", "Kopie von hit_box.cpp", "hit_box_final.cpp",
        "hit_box final v2 (1).cpp"}) {
    fs::remove_all(in());
    add(std::string("ada/") + name, "b");
    add("bob/hit_box.cpp", "c");
    const auto all = seen();
    EXPECT_EQ(all.at("ada").judged, (Files{{"hit_box", "b"}})) << name;
    EXPECT_EQ(all.at("ada").problem, "") << name;
    add("ada/hit_box new.cpp", "d");
    EXPECT_THAT(seen().at("ada").problem, HasSubstr("may both be hit_box.cpp")) << name;
  }
}

TEST_F(Intake, a_file_that_does_not_count_is_named) {
  const std::string box = "hit_box.cpp", other = "' does not count, as it is not named hit_";
  const std::vector<std::pair<std::string, std::string>> notes{
      {"hit_box_old.cpp", "'hit_box_old.cpp" + other + "box.cpp"},
      {"hit_box_final.cpp", "'hit_box.cpp' counts, and not 'hit_box_final.cpp', which differs"},
      {"a/Hit_Sphere mine.cpp", "'a/Hit_Sphere mine.cpp" + other + "sphere.cpp"},
      {"hit_sphere.c", "'hit_sphere.c" + other + "sphere.cpp"},
      {"hit_sphere.txt", "'hit_sphere.txt" + other + "sphere.cpp"},
      {"hit_sphere", "'hit_sphere" + other + "sphere.cpp"},
      {"Copy of hit_box.cpp", "'hit_box.cpp' counts, and not 'Copy of hit_box.cpp', which differs"},
      {"rest.lz", "'rest.lz' cannot be unpacked here, and does not count"},
      {"hit_box.png", ""},
      {"main.cpp", ""}};
  for (const auto& [name, note] : notes) {
    fs::remove_all(in());
    for (const std::string ada : {"ada/", "bob/"}) add(ada + box, "b");
    add("ada/" + name, "?");
    add("cy.zip", archive_of({{box, "b"}, {name, "?"}}));
    add("di/work.zip", archive_of({{box, "b"}}));
    add("di/" + name, "?");
    auto all = seen();
    EXPECT_EQ(all["ada"].note, note);
    EXPECT_EQ(all["cy"].note, note);
    // "Copy of" is a file beside an archive.
    EXPECT_EQ(all["di"].note, note.find("and not") != note.npos ? all["di"].note : note);
    for (const char* who : {"ada", "bob", "cy", "di"}) EXPECT_EQ(all[who].problem, "") << name;
  }
}

// The judge sees what is wrong with a file of nearly the right name, as it would in its right place.
TEST_F(Intake, a_file_that_cannot_be_used_is_rejected_for_its_own_reason) {
  for (const char* name : {"large", "link", "pipe", "twice", "other part"})
    add(std::string(name) + "/hit_sphere.cpp", "right");
  add("large/Hit_Box.cpp", std::string((1 << 20) + 1, 'a'));
  fs::create_symlink("/etc/passwd", in("link/Hit_Box.cpp"));
  mkfifo(in("pipe/Hit_Box.cpp").c_str(), 0600);
  add("twice/Hit_Box.cpp", "a");
  fs::create_hard_link(in("twice/Hit_Box.cpp"), folder_.path() + "/second");
  add("other part/2_bvh/hit_box.cpp", std::string((1 << 20) + 1, 'a'));
  auto all = seen();
  const std::map<std::string, std::string> reasons{
      {"large", "the file is larger than 1 MiB"},
      {"link", "the file is a link, or cannot be read"},
      {"pipe", "it is not a regular file"},
      {"twice", "the file has a second name (a hard link); hand in a copy"},
      {"other part", "the file is larger than 1 MiB"}};
  for (const auto& [name, reason] : reasons) {
    EXPECT_EQ(all[name].judged["hit_box"], reason) << name;
    EXPECT_THAT(all[name].note, HasSubstr(reason)) << name;
    EXPECT_EQ(all[name].judged["hit_sphere"], "right") << name;
    EXPECT_EQ(all[name].problem, "") << name;
  }
}

TEST_F(Intake, progress_counts_submissions) {
  using Told = std::vector<std::pair<std::size_t, std::size_t>>;
  const auto told = [&](const fs::path& input) {
    Told all;
    handed_in(input, folder_.path() + "/work", kTasks,
              {[](const std::string&, const std::string&, Extent) { return "not now"; }}, forms_,
              [&](std::size_t done, std::size_t of) { all.emplace_back(done, of); });
    return all;
  };
  // Two files of one learner are one submission.
  add("ada_1_11_hit_box.cpp", "a");
  add("ada_1_12_hit_sphere.cpp", "a");
  add("bob_2_13_work.zip", "b");
  add("eve/hit_box.cpp", "e");
  EXPECT_EQ(told(in()), (Told{{0, 3}, {1, 3}, {2, 3}, {3, 3}}));
  fs::remove_all(in());
  add("submission_metadata.yml", "submission_1:\n  :submitters:\n  - :name: Ada\n");
  add("submission_1/hit_box.cpp", "a");
  add("submission_2/hit_box.cpp", "b");
  EXPECT_EQ(told(in()), (Told{{0, 2}, {1, 2}, {2, 2}}));
}

// Nobody's verdict depends on a full disk.
TEST_F(Intake, faults_of_the_machine_are_nobodys) {
  add("ada.zip", archive_of({{"hit_box.cpp", "a"}}));
  const auto full = [](const std::string&, const std::string&, Extent) -> std::string {
    throw pt::Error("the disk is full");
  };
  EXPECT_THAT([&] { handed_in(in(), folder_.path() + "/work", kTasks, {full}, forms_); },
              testing::ThrowsMessage<pt::Error>("the disk is full"));
}

// Written work counts, wherever the stub lies, and equal files are no question.
TEST_F(Intake, an_unwritten_task_never_beats_written_work) {
  const std::string stub = "int f() {\n  todo(\"hit_box\");\n}\n",
                    work = "int f() { return 1; }  // todo(it)\n";
  const std::vector<std::string> names{"beside", "numbered", "deeper", "in_archive", "equal"};
  add("beside/hit_box.cpp", stub);
  add("beside/old/hit_box.cpp", work);
  add("numbered/hit_box.cpp", stub);
  add("numbered/hit_box (1).cpp", work);
  add("deeper/1_rays/hit_box.cpp", stub);
  add("deeper/student/1_rays/hit_box.cpp", work);
  add("in_archive/hit_box.cpp", stub);
  add("in_archive/work.zip", archive_of({{"hit_box.cpp", work}}));
  add("equal/a/hit_box.cpp", work);
  add("equal/b/hit_box.cpp", work);
  auto all = seen();
  for (const std::string& name : names) {
    EXPECT_EQ(all[name].problem, "") << name;
    EXPECT_EQ(all[name].judged["hit_box"], work) << name;
  }
}

// In a copy of the project only `student` is the learner's.
TEST_F(Intake, the_judge_reads_the_files_that_count) {
  add("ada/pt/pt.h", "");
  add("ada/1_rays/hit_box.cpp", "not this one");
  add("ada/1_rays/hit_sphere.cpp", "nor this one");
  add("ada/student/1_rays/hit_box.cpp", "a");
  auto all = seen();
  EXPECT_EQ(all["ada"].judged["hit_box"], "a");
  EXPECT_FALSE(all["ada"].judged.contains("hit_sphere")) << all["ada"].judged["hit_sphere"];
}

}  // namespace
}  // namespace grader::intake
