#include "grader/service/build/precompiled.h"

#include "grader/service/build/builder.h"
#include "grader/service/build/headers.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

namespace grader::judging {
namespace {

namespace fs = std::filesystem;

using Words = std::vector<std::string>;

const std::string kBox = "#include \"pt/tasks/hit_box.h\"\n";

const build::TaskConfig& task(const build::Config& config, const std::string& slug) {
  return *std::ranges::find(config.tasks, slug, &build::TaskConfig::slug);
}

// A new folder in which nothing has been compiled yet.
struct Precompiled : testing::Test {
  Precompiled() {
    fs::remove_all(config.work);
    fs::create_directories(config.work);
  }
  ~Precompiled() override {
    std::error_code ignored;
    fs::remove_all(config.work, ignored);
  }

  Words flags_for(const std::string& slug, const std::string& text) const {
    return headers().flags_for(task(config, slug), text);
  }
  build::PrecompiledHeaders headers() const { return {config, build::public_headers(config.root)}; }

  // Compiles a text with these flags; returns the compiler's list of the headers that it reads.
  std::string headers_read(const std::string& text, const Words& flags) const {
    const std::string file = config.work + "/task.cpp", log = config.work + "/log";
    std::ofstream(file) << text;
    const std::string command = fmt::format("{} {} {} -H -I{} -c {} -o {}.o 2> {}", config.compiler,
                                            fmt::join(config.compile_flags, " "),
                                            fmt::join(flags, " "), config.root, file, file, log);
    EXPECT_EQ(std::system(command.c_str()), 0) << command;
    std::ifstream in(log);
    return {std::istreambuf_iterator<char>(in), {}};
  }

  build::Config config = [] {
    build::Config known = build::load_config(FIRSTLIGHT_CHECKS "/grade.json");
    known.work = fs::current_path() / "precompiled_test.work";
    return known;
  }();
};

TEST_F(Precompiled, headers_are_read_by_the_compiler_in_place_of_their_text) {
  const Words flags = flags_for("hit_box", kBox);
  ASSERT_EQ(flags.size(), 2U);
  const std::string with = headers_read(kBox, flags), without = headers_read(kBox, {});
  EXPECT_NE(with.find("! " + flags[1] + ".gch"), std::string::npos) << with;
  EXPECT_NE(without.find("/algorithm\n"), std::string::npos) << without;
  EXPECT_EQ(with.find("/algorithm\n"), std::string::npos) << with;
}

TEST_F(Precompiled, headers_have_nothing_that_the_contract_does_not_include) {
  const build::Headers all = build::public_headers(config.root);
  for (const build::TaskConfig& each : config.tasks) {
    const std::string contract = "pt/tasks/" + each.slug + ".h";
    const Words flags = flags_for(each.slug, "#include \"" + contract + "\"\n");
    ASSERT_EQ(flags.size(), 2U) << each.slug;
    std::ifstream in(flags[1]);
    std::string line;
    std::getline(in, line);
    const std::string included = line.substr(10, line.rfind('"') - 10);
    EXPECT_TRUE(build::reached_from(contract, all).contains(included)) << each.slug << " " << line;
  }
}

TEST_F(Precompiled, headers_are_used_where_only_headers_come_before_the_contract) {
  EXPECT_FALSE(flags_for("hit_box", "// A box.\n\n# include <cmath>\n" + kBox).empty());
  EXPECT_FALSE(flags_for("hit_box", kBox + "#define EPSILON 1e-4\n").empty());
}

// Each header could mean something else there.
TEST_F(Precompiled, headers_are_not_used_where_a_macro_comes_before_the_contract) {
  EXPECT_EQ(flags_for("hit_box", "#define _GLIBCXX_DEBUG\n" + kBox), Words{});
  EXPECT_EQ(flags_for("hit_box", "  #  pragma pack(1)\n" + kBox), Words{});
  EXPECT_EQ(flags_for("hit_box", "#include <cmath>\n#undef NAN\n" + kBox), Words{});
  EXPECT_EQ(flags_for("hit_box", "#include <cmath>\n"), Words{}) << "no contract";
  EXPECT_EQ(flags_for("hit_sphere", kBox), Words{}) << "that of another task";
}

TEST_F(Precompiled, headers_are_done_without_where_they_cannot_be_made) {
  config.work = "/dev/null/work";
  EXPECT_EQ(flags_for("hit_box", kBox), Words{});
}

TEST_F(Precompiled, headers_are_done_without_where_the_compiler_fails) {
  config.compile_flags.emplace_back("-fno-such-flag");
  EXPECT_EQ(flags_for("hit_box", kBox), Words{});
  for (const auto& file : fs::recursive_directory_iterator(config.work)) {
    EXPECT_NE(file.path().extension(), ".gch") << file.path();
    EXPECT_NE(file.path().extension(), ".tmp") << file.path();
  }
}

TEST_F(Precompiled, headers_of_other_flags_are_others) {
  const Words first = flags_for("hit_box", kBox);
  config.compile_flags.emplace_back("-DNDEBUG");
  const Words second = flags_for("hit_box", kBox);
  EXPECT_NE(first, second);
  EXPECT_TRUE(fs::exists(first.at(1))) << "somebody may still use them";
}

TEST_F(Precompiled, headers_that_nobody_uses_any_more_are_removed) {
  const fs::path first = fs::path(flags_for("hit_box", kBox).at(1)).parent_path();
  const fs::path other = first.parent_path() / "of_another_run";
  fs::copy(first, other);
  fs::last_write_time(other, fs::file_time_type::clock::now() - std::chrono::hours(2));
  config.compile_flags.emplace_back("-DNDEBUG");
  EXPECT_FALSE(flags_for("hit_box", kBox).empty());
  EXPECT_FALSE(fs::exists(other));
  EXPECT_TRUE(fs::exists(first)) << "somebody may still use them";
}

TEST_F(Precompiled, headers_of_another_compiler_are_not_made) {
  config.compiler_version = "Clang 14.0.6";
  EXPECT_EQ(flags_for("hit_box", kBox), Words{});
}

// Learners read the compiler's errors.
struct Compiled : Precompiled {
  std::string error_of(const std::string& slug, const std::string& text) const {
    const build::Builder builder(config, sandbox::Tier::limits, 60);
    const build::Built built = builder.compile(task(config, slug), text);
    EXPECT_FALSE(built.ok());
    return built.error;
  }
};

TEST_F(Compiled, errors_name_headers_by_their_places_in_the_project) {
  const std::string error =
      error_of("hit_box", kBox + "pt::Vec3 sum(pt::Vec3 a) { return a + 1; }\n");
  EXPECT_NE(error.find("2_bvh/hit_box.cpp:2:"), error.npos) << error;
  EXPECT_NE(error.find("\npt/math/vec3.h:"), error.npos) << error;
  EXPECT_EQ(error.find(config.work), error.npos) << error;
}

TEST_F(Compiled, a_header_that_is_not_for_a_task_says_so_by_its_name) {
  for (const std::string slug : {"hit_triangle", "hit_sphere"}) {
    const std::string error = error_of(slug, "#include \"pt/scene/tracer.h\"\n");
    EXPECT_NE(error.find(slug + " may not include pt/scene/tracer.h"), error.npos) << error;
  }
}

}  // namespace
}  // namespace grader::judging
