// A clone is read as data: nothing outside of it is read, whatever is in it.
#include "grader/door/clone.h"
#include "grader/door/code.h"
#include "grader/door/dialect.h"
#include "grader/door/edits.h"
#include "grader/door/flatten.h"
#include "grader/results/points.h"
#include "pt/error.h"
#include "pt/file.h"
#include "tests/fixtures/temporary_folder.h"

#include <algorithm>
#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

namespace grader::door {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

void write(const fs::path& path, const std::string& text) {
  fs::create_directories(path.parent_path());
  pt::write_file(path, text);
}

Texts texts() { return read_texts(fs::path(FIRSTLIGHT_ROOT) / "grader/door"); }

// The text that hit_box is judged as, if bbox.cpp is this.
std::string flat(const std::string& bbox, Clone clone = {}) {
  clone.files["src/scene/bbox.cpp"] = {bbox};
  return flatten(clone, texts(), "hit_box");
}

class CloneOnDisk : public testing::Test {
 protected:
  void SetUp() override {
    write(path("src/pathtracer/pathtracer.cpp"), "");
    write(secret_, "the secret");
  }
  fs::path path(const std::string& name) const { return fs::path(folder_.path()) / "clone" / name; }
  Clone read() const { return read_clone(path("")); }

  TemporaryFolder folder_;
  fs::path secret_ = fs::path(folder_.path()) / "secret.h";
};

TEST_F(CloneOnDisk, is_noticed_by_its_folders) {
  EXPECT_TRUE(is_clone(path("")));
  EXPECT_FALSE(is_clone(folder_.path()));
}

TEST_F(CloneOnDisk, is_read_without_links) {
  fs::create_symlink(secret_, path("src/soft.h"));
  fs::create_directory_symlink(folder_.path(), path("src/folder"));
  fs::create_hard_link(secret_, path("src/hard.h"));
  ASSERT_EQ(mkfifo(path("src/pipe.h").c_str(), 0600), 0);
  write(path("src/name\"\n#include \"x.h"), "");
  const Clone clone = read();
  EXPECT_EQ(clone.files.size(), 4U);
  for (const char* name : {"src/soft.h", "src/hard.h", "src/pipe.h"}) {
    ASSERT_NE(clone.find(name), nullptr) << name;
    EXPECT_NE(clone.find(name)->refused, "") << name;
    EXPECT_EQ(clone.find(name)->text, "") << name;
  }
  for (const auto& [name, file] : clone.files)
    EXPECT_THAT(file.text, Not(HasSubstr("secret"))) << name;
}

TEST_F(CloneOnDisk, has_lines_that_end_in_any_way) {
  write(path("src/ends.h"), "one\rtwo\r\nthree\n\r\rend");
  EXPECT_EQ(read().find("src/ends.h")->text, "one\ntwo\nthree\n\n\nend");
}

TEST_F(CloneOnDisk, has_bounds_for_size_and_depth) {
  write(path("src/large.h"), std::string((std::size_t{1} << 20) + 1, ' '));
  EXPECT_THAT(read().find("src/large.h")->refused, HasSubstr("larger than 1 MiB"));
  write(path("src/1/2/3/4/5/6/7/8/9/deep.h"), "");
  EXPECT_THAT(read().problem, HasSubstr("folders deep"));
}

TEST(Clone, is_the_same_when_it_is_unpacked) {
  Clone clone;
  clone.files["src/a.h"] = {"text\nwith 3\n"};
  clone.files["src/b.h"] = {"", "it is a link"};
  const Clone again = unpack(pack(clone));
  EXPECT_EQ(again.find("src/a.h")->text, "text\nwith 3\n");
  EXPECT_EQ(again.find("src/b.h")->refused, "it is a link");
  for (const char* text : {"7", "99\nx", "x\n", "18446744073709551615\n"})
    EXPECT_THROW(unpack(text), pt::Error) << text;
}

TEST(Flatten, follows_no_include_out_of_the_clone) {
  for (const char* name : {"../../../etc/passwd", "/etc/passwd", "../../outside.h"}) {
    const std::string line = std::string("#include \"") + name + "\"";
    EXPECT_THAT(flat(line), HasSubstr("\n" + line + "\n"))
        << "the compiler says that it is missing";
  }
  Clone clone;
  clone.files["src/scene/link.h"] = {"", "the file is a link"};
  EXPECT_THAT(flat("#include \"link.h\"", clone),
              HasSubstr("#error \"src/scene/link.h: the file is a link\""));
}

TEST(Flatten, ends_where_files_include_each_other) {
  Clone clone;
  clone.files["src/scene/a.h"] = {"#include \"b.h\"\nint a;\n"};
  clone.files["src/scene/b.h"] = {"#include \"a.h\"\nint b;\n"};
  const std::string text = flat("#include \"a.h\"\n", clone);
  EXPECT_THAT(text,
              HasSubstr("#line 2 \"src/scene/b.h\"\nint b;\n#line 2 \"src/scene/a.h\"\nint a;\n"));
  for (int i = 0; i < 200; ++i)
    clone.files["src/scene/c" + std::to_string(i) + ".h"] = {"#include \"c" +
                                                             std::to_string(i + 1) + ".h\"\n"};
  EXPECT_THAT(flat("#include \"c0.h\"\n", clone), HasSubstr("#error \"files include files"));
}

TEST(Flatten, leaves_an_include_in_a_comment_alone) {
  Clone clone;
  clone.files["src/scene/a.h"] = {"int a;\n"};
  EXPECT_THAT(flat("/*\n#include \"a.h\"\n*/\n", clone), Not(HasSubstr("int a;")));
  EXPECT_THAT(flat("  # include  \"a.h\"  // mine\n", clone), HasSubstr("int a;"));
  EXPECT_THAT(flat("#include <bits/stdc++.h>\n"), HasSubstr("__has_include(<bits/stdc++.h>)"));
}

TEST(Flatten, tells_the_tasks_of_a_file_apart) {
  const auto functions = [](const std::string& body, const char* slug) {
    Clone clone;
    clone.files["src/pathtracer/pathtracer.cpp"] = {
        "int n;\nVector3D PathTracer::estimate_direct_lighting_importance(const Ray& r) {" + body +
        "}\nvoid PathTracer::raytrace_pixel(size_t x) { }\n"};
    return functions_of(clone, texts(), slug);
  };
  EXPECT_NE(functions("a();", "direct_lights"), functions("b();", "direct_lights"));
  EXPECT_EQ(functions("a();", "estimate_pixel"), functions("b();", "estimate_pixel"));
  EXPECT_THAT(functions("", "estimate_pixel"), testing::StartsWith("PathTracer::raytrace_pixel"));
  EXPECT_EQ(functions("", "hit_box"), "");
}

TEST(Flatten, sees_what_is_not_written_yet) {
  const auto is_written = [](const std::string& body) {
    return flat("bool BBox::intersect(const Ray& r, double& t0, double& t1) const {" + body + "}")
               .find("#define FL_WRITTEN 1") != std::string::npos;
  };
  EXPECT_FALSE(is_written("return true;"));
  EXPECT_FALSE(is_written("// r is the ray\n return true;"));
  EXPECT_TRUE(is_written("return r.d.x > 0;"));
  EXPECT_TRUE(is_written("return slabs(r, t0, t1);"));
}

Dialect dialect_since(const std::string& year) {
  return load_dialect(fs::path(FIRSTLIGHT_ROOT) / "grader/door", *course_since(year));
}

results::TaskResult judged(const Dialect& dialect, const std::string& slug,
                           const std::string& printed) {
  results::TaskResult task;
  task.slug = slug;
  translate(dialect, task);
  settle_own(dialect, printed, "./run grade", task);
  return task;
}

TEST(Dialect, has_promises_of_its_own_that_the_adapter_says_are_broken) {
  const std::string name = "has_intersection_agrees_with_intersect";
  const Dialect dialect = dialect_since("2019");
  const results::TaskResult kept = judged(dialect, "hit_triangle", "not kept: another: one\n");
  ASSERT_EQ(kept.promises.size(), 1U);
  EXPECT_EQ(kept.promises[0].name, name);
  EXPECT_TRUE(kept.promises[0].held);
  const auto broken =
      judged(dialect, "hit_triangle", "mine\n\nnot kept: " + name + ": yes; Box 1; Ray 2\n");
  EXPECT_FALSE(broken.promises.at(0).held);
  EXPECT_EQ(broken.promises.at(0).failures.at(0).got, "yes");
  EXPECT_THAT(broken.promises.at(0).failures.at(0).input, testing::ElementsAre("Box 1", "Ray 2"));
  EXPECT_EQ(without_notes("mine\nnot kept: a: b\nyours\n"), "mine\nyours\n");
  EXPECT_EQ(without_notes("\nnot kept: a: b\n"), "");
}

TEST(Dialect, asks_for_a_flag_where_the_skeleton_has_it) {
  EXPECT_TRUE(is_own(dialect_since("2023"), "trace_path", "shows_one_bounce_alone"));
  EXPECT_FALSE(is_own(dialect_since("2022"), "trace_path", "shows_one_bounce_alone"));
  for (const char* year : {"2019", "2020", "2022", "2023"})
    EXPECT_EQ(year_of(*course_since(year)), year);
  EXPECT_FALSE(course_since("2021"));
}

// A line that the submission prints gives a mistake a name; a mistake that the judge names costs one promise.
TEST(Dialect, lets_one_cause_cost_one_promise) {
  const Dialect dialect = dialect_since("2022");
  const std::string name = "not kept: jitter_from_a_table: 4\n";
  const auto named =
      judged(dialect, "estimate_pixel", name + "not kept: traces_each_ray_once: 1\n");
  EXPECT_EQ(named.mistake.found_by, results::kNamedOnly);
  EXPECT_TRUE(judged(dialect, "estimate_pixel", name).mistake.empty()) << "nothing is wrong";
  results::TaskResult tree = judged(dialect, "build_bvh", "not kept: no_fallback: forged\n");
  EXPECT_TRUE(tree.mistake.empty());
  results::Failure crash, wrong;
  crash.cause = results::Cause::crash;
  tree.promises = {{"is_one_tree", "", false, false, 1, 0, {crash}}};
  tree.mistake.name = "no_fallback";
  settle_cause(dialect, tree);
  EXPECT_EQ(tree.mistake.found_by, results::kOneCause);
  tree.mistake.found_by = "battery";
  tree.promises.push_back({"separates_along_the_longest_axis", "", false, false, 1, 0, {wrong}});
  settle_cause(dialect, tree);
  EXPECT_EQ(tree.mistake.found_by, "battery") << "another mistake is there, too";
}

TEST(Edits, keep_lines) {
  const std::string text =
      "class PathTracer\n{\n  // private: no\n private:\n  std::vector<int> "
      "sampleCountBuffer;\n};\n";
  const std::string made = edited(text, "src/pathtracer/pathtracer.h", Generation::of_2022);
  EXPECT_EQ(made,
            "FL_SEAMS class PathTracer : public Seams\n{\n  // private: no\n public:\n  FlOne<int> "
            "sampleCountBuffer;\n};\n");
  const std::string old = "int a;\nvoid PathTracer::stop() {\n  if (a) { \"}\"; }\n}\nint b;\n";
  EXPECT_EQ(edited(old, "src/pathtracer.cpp", Generation::of_2019), "int a;\n\n\n\nint b;\n");
}

TEST(Code, is_read_roughly_whatever_it_is) {
  EXPECT_EQ(only_code("a /* b\nc */ \"d\\\"e\" 'f' 1'000 // g\nh"),
            "a     \n     " + std::string(6, ' ') + "     1'000     \nh");
  const auto found = definitions_of(
      "int A::f(std::map<int, int> m, const B &b = B(1, 2)) const { return {}; }", "A::f");
  ASSERT_EQ(found.size(), 1U);
  EXPECT_THAT(found[0].parameters, testing::ElementsAre("m", "b"));
  for (const char* text : {"A::f(", "A::f(a", "A::f() {", "A::f", "A::f){", "\"", "/*", "'\\"}) {
    EXPECT_LE(definitions_of(only_code(text), "A::f").size(), 1U) << text;
    edited(text, "src/pathtracer.cpp", Generation::of_2019);
    flat(text);
  }
}

}  // namespace
}  // namespace grader::door
