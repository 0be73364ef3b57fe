// The judge's cache: which files are removed when it is too large, and which must stay.
#include "grader/service/build/cache.h"

#include "grader/service/build/headers.h"
#include "pt/file.h"
#include "tests/fixtures/temporary_folder.h"

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

namespace grader::judging {
namespace {

namespace fs = std::filesystem;
using std::chrono::hours;
using std::chrono::minutes;

class Cache : public testing::Test {
 protected:
  // Writes a file of this size that was last used this long ago.
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
  build::trim_cache(folder(), 1000);
  EXPECT_EQ(names(), (Names{"a.o", "b.worker"}));
}

// 1200 bytes; 500 or more are too many. Without the two oldest 600 are left, without three 300.
TEST_F(Cache, forgets_what_was_used_longest_ago_until_less_than_half_is_left) {
  add("a.o", 300, hours(3));
  add("b.o", 300, hours(5));
  add("c.o", 300, hours(2));
  add("d.o", 300, hours(4));
  build::trim_cache(folder(), 1000);
  EXPECT_EQ(names(), (Names{"c.o"}));
}

TEST_F(Cache, an_entry_is_as_old_as_the_youngest_of_its_files_and_goes_as_a_whole) {
  add("a.picture.json", 100, hours(2));
  add("a.picture.exr", 100, hours(9));
  add("a.picture.evidence.exr", 100, hours(9));
  add("b.picture.json", 100, hours(3));
  add("b.picture.exr", 700, hours(4));
  build::trim_cache(folder(), 1000);
  EXPECT_EQ(names(), (Names{"a.picture.evidence.exr", "a.picture.exr", "a.picture.json"}));
}

TEST_F(Cache, what_is_used_is_not_forgotten) {
  add("a.o", 600, hours(9));
  add("b.o", 400, hours(2));
  add("c.o", 400, hours(3));
  build::mark_used(path("a.o"));
  build::trim_cache(folder(), 1000);
  EXPECT_EQ(names(), (Names{"a.o"}));
}

std::string running(pid_t process) { return "running.judge." + std::to_string(process) + ".1.tmp"; }

// The number of a process that has ended.
std::string dead_process() {
  const pid_t child = fork();
  if (child == 0) _exit(0);
  waitpid(child, nullptr, 0);
  return std::to_string(child);
}

TEST_F(Cache, another_judge_finds_what_it_used_since_it_began) {
  add("a.o", 900, minutes(20));
  add("b.o", 900, minutes(9));
  add("c.o", 10, minutes(31));
  add(running(getpid()), 0, minutes(25));
  add(running(std::stoi(dead_process())), 0, minutes(40));
  build::trim_cache(folder(), 1000);
  EXPECT_FALSE(names().contains("c.o"));
  EXPECT_TRUE(names().contains("a.o") && names().contains("b.o"));
  age(running(getpid()), minutes(10));
  build::trim_cache(folder(), 1000);
  EXPECT_FALSE(names().contains("a.o"));
  EXPECT_TRUE(names().contains("b.o"));
}

// A class that fills it within the hour has no more than this.
TEST_F(Cache, what_judges_that_have_ended_used_is_bounded_at_once) {
  for (int i = 0; i < 40; ++i) {
    const build::Running judge(folder());
    add(std::to_string(i) + ".o", 400, build::kJustUsed + minutes(41 - i));
    build::trim_cache(folder(), 1000);
    EXPECT_LE(names().size(), 3U);
  }
}

TEST_F(Cache, is_looked_at_again_after_a_large_file) {
  build::trim_cache_now_and_then(folder(), 1000);
  build::keep(path("a.o"), std::string(1000, 'x'));
  EXPECT_TRUE(names().contains("trimmed"));
  build::keep(path("b.o"), std::string(build::kLarge + 1, 'x'));
  EXPECT_FALSE(names().contains("trimmed"));
}

TEST_F(Cache, is_looked_at_now_and_then) {
  const auto finds_and_trims = [&] {
    add("a.o", 1100, hours(2));
    build::trim_cache_now_and_then(folder(), 1000);
    return !names().contains("a.o");
  };
  EXPECT_TRUE(finds_and_trims());
  EXPECT_FALSE(finds_and_trims()) << "at once again";
  age("trimmed", build::kTrimPause - minutes(1));
  EXPECT_FALSE(finds_and_trims());
  age("trimmed", build::kTrimPause + minutes(1));
  EXPECT_TRUE(finds_and_trims());
  EXPECT_FALSE(finds_and_trims()) << "the pause begins again";
}

TEST_F(Cache, what_dead_runs_left_goes_at_once) {
  const std::string dead = dead_process(), here = std::to_string(getpid());
  add("a.o", 10, hours(9));
  add("a.o." + dead + ".1.tmp", 10, minutes(0));
  add("a.picture.json." + dead + ".2.tmp", 10, minutes(0));
  fs::create_directories(path("c.tree." + dead + ".3.tmp/pt/math"));
  pt::write_file(path("c.tree." + dead + ".3.tmp/pt/math/vec3.h"), "");
  fs::create_directories(path("probe." + dead + ".1.tmp"));
  build::remove_left_overs(folder());
  EXPECT_EQ(names(), (Names{"a.o"}));
  // Files that a running process may need stay, however old they are.
  const Names used{"a.o", "b.tree." + here + ".2.tmp", "b.o." + here + ".3.tmp"};
  for (const std::string& name : used) add(name, 10, hours(90));
  build::remove_left_overs(folder());
  build::trim_cache(folder(), 1000);
  EXPECT_EQ(names(), used);
}

TEST_F(Cache, files_with_numbers_in_their_names_are_not_temporary) {
  const Names all{"a.o",      "a.4711",        "b.4711.o",
                  "4711.3",   "c.x4711.3.tmp", "d.4711.3.tmp.json",
                  "e.4711.3", "f.4711.tmp",    "g.4711.x3.tmp"};
  for (const std::string& name : all) add(name, 10, hours(9));
  build::remove_left_overs(folder());
  EXPECT_EQ(names(), all);
}

TEST_F(Cache, nothing_there_is_no_error) {
  EXPECT_NO_THROW(build::mark_used(path("a.o")));
  EXPECT_NO_THROW(build::trim_cache(path("none"), 0));
  EXPECT_NO_THROW(build::remove_left_overs(path("none")));
  EXPECT_EQ(names(), Names{});
}

TEST_F(Cache, a_file_that_is_made_again_is_the_same) {
  fs::create_directory(path("cache"));
  const auto stamp = [&] { return build::content_stamp(path("program"), path("cache")); };
  add("program", 10, minutes(30));
  const std::string before = stamp();
  age("program", minutes(5));
  EXPECT_EQ(stamp(), before);
  pt::write_file(path("program"), "yyyyyyyyyy");
  age("program", minutes(4));
  EXPECT_NE(stamp(), before);
}

TEST_F(Cache, folders_that_nobody_has_used_for_an_hour_go) {
  for (const char* name : {"new", "used", "unused"}) {
    fs::create_directories(path(name) + "/pt");
    age(name, hours(2));
  }
  age("used", minutes(59));
  build::remove_unused_beside(path("new"));
  EXPECT_EQ(names(), (Names{"new", "used"}));
}

// A checkout may consist of links to folders elsewhere.
TEST(public_headers, have_the_names_by_which_they_are_included) {
  const TemporaryFolder here, elsewhere;
  std::filesystem::create_directory(elsewhere.path() + "/math");
  pt::write_file(elsewhere.path() + "/math/a.h", "int a;\n");
  std::filesystem::create_directory_symlink(elsewhere.path(), here.path() + "/pt");
  EXPECT_EQ(build::public_headers(here.path()), (build::Headers{{"pt/math/a.h", "int a;\n"}}));
}

TEST(code_of, is_what_a_compiler_sees) {
  EXPECT_EQ(build::code_of("// words\n\n#pragma once\nint f();  // more\n"),
            "#pragma once\nint f();  \n");
  EXPECT_EQ(build::code_of("int /* here */ f();\n/* two\nlines */\n"), "int   f();\n \n");
  const std::string text = "const char* a = \"// \\\" // no comment\"; char b = '\"';\n";
  EXPECT_EQ(build::code_of(text + "// words\n"), text);
  EXPECT_NE(build::code_of("int f();"), build::code_of("int g();"));
  // Code that uses the number of its line is kept as it is.
  EXPECT_EQ(build::code_of("// words\nassert(x);\n"), "// words\nassert(x);\n");
}

}  // namespace
}  // namespace grader::judging
