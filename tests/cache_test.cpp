// The judge's cache: the files that are removed when it is too large, and those that must stay.
#include "grader/judge/cache.h"

#include "grader/judge/headers.h"
#include "grader/judge/kept.h"
#include "grader/judge/tool_folder.h"
#include "pt/file.h"
#include "tests/temporary_folder.h"

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

namespace grader::judge {
namespace {

namespace fs = std::filesystem;
using std::chrono::hours;
using std::chrono::minutes;

class Cache : public testing::Test {
 protected:
  // A file of so many bytes, last used so long ago.
  void add(const std::string& name, std::size_t bytes, minutes ago) const {
    pt::write_file(path(name), std::string(bytes, 'x'));
    age(name, ago);
  }

  void age(const std::string& name, minutes ago) const {
    fs::last_write_time(path(name), fs::file_time_type::clock::now() - ago);
  }

  std::string path(const std::string& name) const { return folder_.path() + "/" + name; }

  std::set<std::string> names() const {
    std::set<std::string> all;
    for (const auto& entry : fs::directory_iterator(folder_.path())) {
      all.insert(entry.path().filename());
    }
    return all;
  }

  const std::string& folder() const { return folder_.path(); }

 private:
  TemporaryFolder folder_;
};

using Names = std::set<std::string>;

TEST_F(Cache, keeps_all_while_it_is_small_enough) {
  add("a.o", 600, hours(100));
  add("b.worker", 400, hours(200));
  trim_cache(folder(), 1000);
  EXPECT_EQ(names(), (Names{"a.o", "b.worker"}));
}

// 1200 bytes; 500 and more are too many. Without the two oldest, 600 are left; without three, 300.
TEST_F(Cache, forgets_what_was_used_longest_ago_until_less_than_half_is_left) {
  add("a.o", 300, hours(3));
  add("b.o", 300, hours(5));
  add("c.o", 300, hours(2));
  add("d.o", 300, hours(4));
  trim_cache(folder(), 1000);
  EXPECT_EQ(names(), (Names{"c.o"}));
}

TEST_F(Cache, an_entry_is_as_old_as_the_youngest_of_its_files_and_goes_as_a_whole) {
  add("a.picture.json", 100, hours(2));
  add("a.picture.exr", 100, hours(9));
  add("a.picture.evidence.exr", 100, hours(9));
  add("b.picture.json", 100, hours(3));
  add("b.picture.exr", 700, hours(4));
  trim_cache(folder(), 1000);
  EXPECT_EQ(names(), (Names{"a.picture.evidence.exr", "a.picture.exr", "a.picture.json"}));
}

// A clock that ran ahead and was set back: a file that was used "tomorrow" goes first, not never.
TEST_F(Cache, a_time_of_the_future_keeps_nothing) {
  add("a.o", 600, hours(-24 * 365));
  add("b.o", 300, hours(2));
  add("c.o", 200, hours(3));
  trim_cache(folder(), 1000);
  EXPECT_EQ(names(), (Names{"b.o"}));
}

TEST_F(Cache, what_is_used_is_not_forgotten) {
  add("a.o", 600, hours(9));
  add("b.o", 400, hours(2));
  add("c.o", 400, hours(3));
  mark_used(path("a.o"));
  trim_cache(folder(), 1000);
  EXPECT_EQ(names(), (Names{"a.o"}));
}

TEST_F(Cache, another_judge_finds_what_it_used_within_the_hour) {
  add("a.o", 900, minutes(59));
  add("b.o", 900, minutes(1));
  add("c.o", 10, minutes(61));
  trim_cache(folder(), 1000);
  EXPECT_EQ(names(), (Names{"a.o", "b.o"}));
}

TEST_F(Cache, is_looked_at_now_and_then) {
  const auto finds_and_trims = [&] {
    add("a.o", 1100, hours(2));
    trim_cache_now_and_then(folder(), 1000);
    return !names().contains("a.o");
  };
  EXPECT_TRUE(finds_and_trims());
  EXPECT_FALSE(finds_and_trims()) << "at once again";
  age("trimmed", kTrimPause - minutes(1));
  EXPECT_FALSE(finds_and_trims());
  age("trimmed", kTrimPause + minutes(1));
  EXPECT_TRUE(finds_and_trims());
  EXPECT_FALSE(finds_and_trims()) << "the pause begins again";
  age("trimmed", hours(-24));
  EXPECT_TRUE(finds_and_trims()) << "the clock was set back";
}

// The number of a process that has ended.
std::string dead_process() {
  const pid_t child = fork();
  if (child == 0) _exit(0);
  waitpid(child, nullptr, 0);
  return std::to_string(child);
}

TEST_F(Cache, what_dead_runs_left_goes_at_once) {
  const std::string dead = dead_process(), here = std::to_string(getpid());
  add("a.o", 10, hours(9));
  add("a.o." + dead + ".1.tmp", 10, minutes(0));
  add("a.picture.json." + dead + ".2.tmp", 10, minutes(0));
  fs::create_directories(path("c.tree." + dead + ".3.tmp/pt/math"));
  pt::write_file(path("c.tree." + dead + ".3.tmp/pt/math/vec3.h"), "");
  fs::create_directories(path("probe." + dead + ".1.tmp"));
  remove_left_overs(folder());
  EXPECT_EQ(names(), (Names{"a.o"}));
  // Files that a running process may need stay, whatever their time.
  const Names used{"a.o", "b.tree." + here + ".2.tmp", "b.o." + here + ".3.tmp"};
  for (const std::string& name : used) add(name, 10, hours(90));
  remove_left_overs(folder());
  trim_cache(folder(), 1000);
  EXPECT_EQ(names(), used);
}

// The file is one that somebody asked for, in a folder that is not the judge's.
TEST_F(Cache, what_dead_runs_left_beside_a_file_goes) {
  const std::string dead = dead_process(), here = std::to_string(getpid());
  const Names stay{"r.json", "a.r.json." + dead + ".1.tmp", "r." + dead + ".1.tmp",
                   "r.json." + here + ".1.tmp"};
  for (const std::string& name : stay) add(name, 10, hours(9));
  add("r.json." + dead + ".1.tmp", 10, minutes(0));
  add("r.json." + dead + ".12.tmp", 10, minutes(0));
  remove_left_overs_of(path("r.json"));
  EXPECT_EQ(names(), stay);
  EXPECT_NO_THROW(remove_left_overs_of(path("none/r.json")));
}

TEST_F(Cache, files_with_numbers_in_their_names_are_not_temporary) {
  const Names all{"a.o",      "a.4711",        "b.4711.o",
                  "4711.3",   "c.x4711.3.tmp", "d.4711.3.tmp.json",
                  "e.4711.3", "f.4711.tmp",    "g.4711.x3.tmp"};
  for (const std::string& name : all) add(name, 10, hours(9));
  remove_left_overs(folder());
  EXPECT_EQ(names(), all);
}

TEST_F(Cache, nothing_there_is_no_error) {
  EXPECT_NO_THROW(mark_used(path("a.o")));
  EXPECT_NO_THROW(trim_cache(path("none"), 0));
  EXPECT_NO_THROW(remove_left_overs(path("none")));
  EXPECT_EQ(names(), Names{});
}

TEST_F(Cache, a_file_that_is_made_again_is_the_same) {
  fs::create_directory(path("cache"));
  const auto stamp = [&] { return content_stamp(path("program"), path("cache")); };
  add("program", 10, minutes(30));
  const std::string before = stamp();
  age("program", minutes(5));
  EXPECT_EQ(stamp(), before);
  pt::write_file(path("program"), "yyyyyyyyyy");
  age("program", minutes(4));
  EXPECT_NE(stamp(), before);
  // Stamps are right again after the files of the cache are damaged, as by a loss of power.
  for (const auto& entry : fs::directory_iterator(path("cache"))) pt::write_file(entry.path(), "");
  add("program", 10, minutes(30));
  EXPECT_EQ(stamp(), before);
}

// As a loss of power leaves files: empty, cut off, or with zeros in them.
std::vector<std::string> damaged(const std::string& text) {
  std::string zeros = text;
  zeros.replace(text.size() / 2, 1, 1, '\0');
  return {"", text.substr(0, text.size() / 2), text.substr(1), zeros, text + '\0'};
}

// Texts on both sides of the pieces in which files are read.
TEST_F(Cache, damaged_files_are_not_whole) {
  for (const std::size_t size : {1u, 31u, 33u, 262143u, 262144u, 262145u, 1000000u}) {
    std::string text(size, 'x');
    for (std::size_t i = 0; i < size; ++i) text[i] = static_cast<char>('a' + i % 23);
    keep_file(path("a.o"), text);
    EXPECT_TRUE(is_whole(path("a.o"))) << size;
    EXPECT_EQ(sum_of(text), sum_of_file(path("a.o"))) << size;
    for (const std::string& other : damaged(text)) {
      if (other == text) continue;
      pt::write_file(path("a.o"), other);
      EXPECT_FALSE(is_whole(path("a.o"))) << size << ' ' << other.size();
    }
    keep_file(path("a.o"), text);
    for (const std::string& other : damaged(sum_of(text))) {
      pt::write_file(path("a.o.sum"), other);
      EXPECT_FALSE(is_whole(path("a.o"))) << size << ' ' << other;
    }
    keep_file(path("a.o"), text);
    EXPECT_TRUE(is_whole(path("a.o")));
  }
  fs::remove(path("a.o"));
  EXPECT_FALSE(is_whole(path("a.o")));
  add("b.o", 10, minutes(0));
  EXPECT_FALSE(is_whole(path("b.o"))) << "without a sum";
}

TEST_F(Cache, of_files_that_belong_together_one_that_is_damaged_or_missing_counts) {
  const std::vector<std::string> files{path("a.json"), path("a.exr"), path("a.csv")};
  const std::string text = "a picture, or what was found in it";
  const auto keep = [&] {
    for (int i = 0; i < 2; ++i) pt::write_file(files[static_cast<std::size_t>(i)], text);
    fs::remove(files[2]);
    note_sums_of(files[0], files);
  };
  for (int i = 0; i < 2; ++i) {
    for (const std::string& other : damaged(text)) {
      keep();
      EXPECT_TRUE(are_whole(files[0], files));
      pt::write_file(files[static_cast<std::size_t>(i)], other);
      EXPECT_FALSE(are_whole(files[0], files)) << i << ' ' << other;
    }
    keep();
    fs::remove(files[static_cast<std::size_t>(i)]);
    EXPECT_FALSE(are_whole(files[0], files)) << i << " is missing";
  }
  keep();
  pt::write_file(files[2], text);
  EXPECT_FALSE(are_whole(files[0], files)) << "one more than there was";
  keep();
  fs::remove(files[0] + ".sum");
  EXPECT_FALSE(are_whole(files[0], files)) << "without sums";
}

TEST_F(Cache, kept_folders_are_mended) {
  const auto kept = [&] {
    return kept_folder(folder(), "key", [](const ToolFolder& place) {
      place.put("a/b.h", "int b();");
      place.put("c.h", "int c();");
    });
  };
  // One look per process tells that a folder is whole, so that each one here is another process.
  const auto is_mended = [&] {
    const pid_t child = fork();
    if (child == 0) _exit(is_whole_folder(kept()) ? 0 : 1);
    int status = -1;
    waitpid(child, &status, 0);
    return status == 0;
  };
  EXPECT_TRUE(is_mended());
  const std::string place = folder() + "/kept/key";
  for (const char* file : {"/a/b.h", "/c.h", "/.sums"}) {
    for (const char* text : {"", "int", "int b(};"}) {
      pt::write_file(place + file, text);
      EXPECT_FALSE(is_whole_folder(place)) << file;
      EXPECT_TRUE(is_mended()) << file;
    }
  }
  fs::remove_all(place + "/a");
  EXPECT_FALSE(is_whole_folder(place));
  EXPECT_TRUE(is_mended());
}

// After a jump of the clock, a folder that a compiler reads right now looks old, or like one of the future.
TEST_F(Cache, folders_in_use_stay_whatever_their_time) {
  const auto age_all = [&](const Names& all, minutes ago) {
    for (const std::string& name : all) {
      fs::create_directories(path(name));
      age(name, ago);
    }
  };
  const Names all{"new", "used", "unused"};
  for (const auto ago : {hours(2), hours(-2)}) {
    age_all(all, ago);
    EXPECT_TRUE(use_folder(path("used")));
    remove_unused_beside(path("new"));
    EXPECT_EQ(names(), (Names{"new", "used"})) << ago.count();
  }
  age_all(all, minutes(59));
  remove_unused_beside(path("new"));
  EXPECT_EQ(names(), all);
  EXPECT_FALSE(use_folder(path("none")));
}

// A process that has ended uses nothing any more.
TEST_F(Cache, folders_of_dead_processes_go) {
  fs::create_directories(path("new"));
  fs::create_directories(path("used"));
  const pid_t child = fork();
  if (child == 0) _exit(use_folder(path("used")) ? 0 : 1);
  int status = -1;
  waitpid(child, &status, 0);
  EXPECT_EQ(status, 0);
  age("used", hours(2));
  remove_unused_beside(path("new"));
  EXPECT_EQ(names(), Names{"new"});
}

// A checkout may be made of links to folders elsewhere.
TEST(public_headers, have_the_names_by_which_they_are_included) {
  const TemporaryFolder here, elsewhere;
  std::filesystem::create_directory(elsewhere.path() + "/math");
  pt::write_file(elsewhere.path() + "/math/a.h", "int a;\n");
  std::filesystem::create_directory_symlink(elsewhere.path(), here.path() + "/pt");
  EXPECT_EQ(public_headers(here.path()), (Headers{{"pt/math/a.h", "int a;\n"}}));
}

TEST(code_of, is_what_a_compiler_sees) {
  EXPECT_EQ(code_of("// words\n\n#pragma once\nint f();  // more\n"), "#pragma once\nint f();  \n");
  EXPECT_EQ(code_of("int /* here */ f();\n/* two\nlines */\n"), "int   f();\n \n");
  const std::string text = "const char* a = \"// \\\" // no comment\"; char b = '\"';\n";
  EXPECT_EQ(code_of(text + "// words\n"), text);
  EXPECT_NE(code_of("int f();"), code_of("int g();"));
  // Code that uses the number of its line is kept as it is.
  EXPECT_EQ(code_of("// words\nassert(x);\n"), "// words\nassert(x);\n");
}

}  // namespace
}  // namespace grader::judge
