// Submissions that attack the judge, in every tier that isolates: they earn nothing, see nothing
// and leave nothing behind. A successful attack prints "BROKE OUT".
#include "grader/service/process/spawn.h"
#include "grader/service/sandbox/users.h"
#include "tests/fixtures/hostile_submission.h"

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <map>
#include <set>

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

namespace grader::tests {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

// The program of a process. In a container, root may read only how another user started it.
std::string program_of(const fs::path& process) {
  std::error_code error;
  std::string program = fs::read_symlink(process / "exe", error);
  if (!error) return program;
  std::string word;
  std::ifstream words(process / "cmdline");
  std::getline(words, word, '\0');
  return word;
}

// Running programs from the work folder: workers.
std::vector<std::string> running(const Submission& submission) {
  std::vector<std::string> programs;
  for (const auto& process : fs::directory_iterator("/proc")) {
    const std::string program = program_of(process.path());
    if (program.starts_with(submission.work().string())) programs.push_back(program);
  }
  return programs;
}

// The processes that still run, and files in places where attacks try to leave some.
std::vector<std::string> left_behind(const Submission& submission) {
  std::vector<std::string> left = running(submission);
  for (const char* folder : {"/", "/tmp", "/var/tmp", "/dev/shm", "/usr/lib", FIRSTLIGHT_ROOT}) {
    for (const char* name : {"left", "firstlight_left", "firstlight_left_folder"}) {
      if (fs::exists(fs::path(folder) / name)) left.push_back(fs::path(folder) / name);
    }
  }
  for (const fs::path& folder : {submission.work(), submission.work() / "cache"}) {
    if (!fs::exists(folder)) continue;  // nothing has been judged
    for (const auto& file : fs::directory_iterator(folder)) {
      const std::set<std::string> ours{".json", ".o",   ".worker",  ".warnings",
                                       ".exr",  ".csv", ".content", ""};
      const bool known = ours.contains(file.path().extension()) && file.path().filename() != "left";
      if (!known) left.push_back(file.path());
    }
  }
  return left;
}

// A killed process needs a moment to disappear.
std::vector<std::string> left_after_a_while(const Submission& submission) {
  std::vector<std::string> left = left_behind(submission);
  for (int i = 0; i < 200 && !left.empty(); ++i) {
    usleep(10000);
    left = left_behind(submission);
  }
  return left;
}

std::map<std::string, std::string> contents(const fs::path& folder) {
  std::map<std::string, std::string> texts;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const bool ours = entry.path().filename() == "results.json";
    if (entry.is_regular_file() && !ours) texts[entry.path()] = text_of(entry.path());
  }
  return texts;
}

// The state in which an attack left its task. tests/grader/service/judging/attack_table.sh requests
// it for the table of docs/decisions/0020.
void note(const std::string& attack, const std::string& tier, const std::string& state) {
  const char* table = std::getenv("FIRSTLIGHT_ATTACKS");
  if (table == nullptr) return;
  std::ofstream(table, std::ios::app) << attack << '\t' << tier << '\t' << state << '\n';
}

class Attack : public testing::TestWithParam<std::string> {
 protected:
  // Grades the batch in this tier, and tests what has to be true of all attacks.
  Outcome attack(const std::string& batch, std::vector<std::string> options = {}) {
    Submission submission(batch + GetParam());
    const std::vector<std::string> slugs = submission.put(batch);
    const auto before = contents(submission / "");
    options.insert(options.end(), {"--isolation", GetParam()});
    options.insert(options.end(), slugs.begin(), slugs.end());
    Outcome outcome = submission.grade_afresh(options);
    EXPECT_EQ(left_after_a_while(submission), std::vector<std::string>{});
    EXPECT_EQ(contents(submission / ""), before);
    EXPECT_EQ(outcome.output.find("BROKE OUT"), std::string::npos) << outcome.output;
    if (outcome.exit_status == 2) {  // no results: this kernel lacks what the tier needs
      for (const std::string& slug : slugs) note(batch + "/" + slug, GetParam(), "not tried");
      return outcome;
    }
    const bool left_alone = !HasFailure();
    for (const std::string& slug : slugs) {
      const json& task = outcome.task(slug);
      const bool held = left_alone && outcome.output.find("BROKE OUT") == std::string::npos &&
                        task.value("points", 0) == 0;
      const bool compiles = task.value("reason", "") != "it does not compile";
      note(batch + "/" + slug, GetParam(),
           !held      ? "GOT THROUGH"
           : compiles ? outcome.state(slug)
                      : "does not compile");
    }
    EXPECT_EQ(outcome.exit_status, 1) << outcome.output;
    for (const std::string& slug : slugs) {
      const json& task = outcome.task(slug);
      const std::string text =
          slug + " " + task.dump(1, ' ', false, json::error_handler_t::replace).substr(0, 3000);
      EXPECT_FALSE(task.is_null()) << slug;
      EXPECT_NE(outcome.state(slug), "pass") << text;
      EXPECT_EQ(task.value("points", -1), 0) << text;
      EXPECT_EQ(task.value("bonus_points", -1), 0) << text;
      EXPECT_EQ(task.dump(-1, ' ', false, json::error_handler_t::replace).find("BROKE OUT"),
                std::string::npos)
          << text;
    }
    return outcome;
  }
};

#define SKIP_WHERE_THE_TIER_DOES_NOT_WORK(outcome)                                              \
  if ((outcome).exit_status == 2 && (outcome).output.find("isolation does not work here") == 0) \
  GTEST_SKIP() << "NOT TESTED in tier " << GetParam() << ": " << (outcome).output

// Everything that a worker could try to reach.
TEST_P(Attack, gets_nowhere_at_run_time) {
  const Outcome outcome = attack("reach");
  SKIP_WHERE_THE_TIER_DOES_NOT_WORK(outcome);
  for (const json& task : outcome.results.at("tasks")) {
    const std::string slug = task.at("slug");
    const bool answers = slug == "adaptive_pixel" || slug == "estimate_pixel";
    EXPECT_EQ(task.at("state"), answers ? "fail" : "crash") << task.dump(1).substr(0, 2000);
  }
  const std::string isolation = outcome.results.at("isolation");
  EXPECT_EQ(isolation.substr(0, 2), GetParam() + ":");
  if (sandbox::is_root_of_the_machine()) {
    EXPECT_NE(isolation.find("another user"), std::string::npos) << isolation;
  }
}

// Allowed calls with commands and flags that nobody needs.
TEST_P(Attack, gets_nowhere_by_commands_and_flags) {
  const Outcome outcome = attack("commands");
  SKIP_WHERE_THE_TIER_DOES_NOT_WORK(outcome);
  for (const json& task : outcome.results.at("tasks")) {
    EXPECT_EQ(task.at("state"), "crash") << task.dump(1).substr(0, 2000);
    EXPECT_NE(task.dump().find("a system call that no task needs"), std::string::npos)
        << task.dump(1).substr(0, 2000);
  }
}

// Files that preprocessors, assemblers and linkers are told to read or write.
TEST_P(Attack, gets_nowhere_by_directives) {
  const Outcome outcome = attack("links");
  SKIP_WHERE_THE_TIER_DOES_NOT_WORK(outcome);
  const std::map<std::string, std::string> reasons{
      {"hit_triangle", "section '.interp'"},
      {"build_bvh", "section '.preinit_array'"},
      {"hit_box", "section '.deplibs'"},
      {"direct_hemisphere", "section '.gnu.warning.main'"},
      {"trace_path", "section '.gnu.lto_.inline.1'"},
      {"direct_lights", "more than 256 MiB"},
      {"camera_ray", "it does not compile"},
      {"hit_sphere", "it does not compile"},
      {"diffuse_bsdf", "it does not compile"},
      {"hit_bvh", "it does not link"}};
  for (const auto& [slug, word] : reasons) {
    const std::string reason = outcome.task(slug).value("reason", "");
    EXPECT_NE(reason.find(word), std::string::npos) << slug << ": " << reason;
    const std::string text = outcome.task(slug).value("compiler_output", "");
    EXPECT_EQ(text.find("cmake_minimum_required"), std::string::npos) << text;
  }
  EXPECT_EQ(outcome.state("adaptive_pixel"), "crash");
}

// Other people's names, other people's files, and exits that look like success.
TEST_P(Attack, gets_nowhere_by_names_and_files) {
  const Outcome outcome = attack("names");
  SKIP_WHERE_THE_TIER_DOES_NOT_WORK(outcome);
  const std::map<std::string, std::string> rejected{
      {"camera_ray", "memcmp"},           {"hit_triangle", "malloc"},
      {"hit_sphere", "operator new"},     {"build_bvh", "pt::todo_reached"},
      {"hit_box", "grader::wire::serve"}, {"adaptive_pixel", "dlopen"}};
  for (const auto& [slug, word] : rejected) {
    EXPECT_EQ(outcome.state(slug), "rejected");
    const std::string reason = outcome.task(slug).at("reason");
    EXPECT_NE(reason.find(word), std::string::npos) << slug << ": " << reason;
  }
  for (const char* slug : {"estimate_pixel", "hit_bvh", "diffuse_bsdf"}) {
    EXPECT_EQ(outcome.state(slug), "crash") << slug;
  }
  for (const std::string slug : {"direct_hemisphere", "direct_lights", "trace_path"}) {
    EXPECT_EQ(outcome.state(slug), "fail") << slug;
    EXPECT_EQ(outcome.task(slug).at("reason"), "it does not compile") << slug;
    const std::string text = outcome.task(slug).at("compiler_output");
    EXPECT_EQ(text.find("cmake_minimum_required"), std::string::npos) << text;
    EXPECT_NE(text.find(slug == "direct_lights" ? "reference/" : "CMakeLists.txt"), text.npos)
        << text;
    EXPECT_EQ(text.find(FIRSTLIGHT_ROOT), std::string::npos) << text;
  }
}

TEST_P(Attack, gets_nowhere_by_compiling_for_ever) {
  const Outcome outcome = attack("bombs", {"--compile-limit", "12"});
  SKIP_WHERE_THE_TIER_DOES_NOT_WORK(outcome);
  for (const json& task : outcome.results.at("tasks")) {
    EXPECT_EQ(task.at("state"), "fail");
    EXPECT_EQ(task.at("reason"), "it does not compile") << task.at("slug");
  }
  const auto told = [&](const char* slug, const char* words) {
    const std::string text = outcome.task(slug).at("compiler_output");
    EXPECT_NE(text.find(words), std::string::npos) << slug << ": " << text;
  };
  told("hit_sphere", "its output is too large; is there a huge array");
  // The machine has more, but the submission may not use it.
  told("estimate_pixel", "wanted more than 576 MiB of memory");
  told("hit_bvh", "wanted more than 576 MiB of memory");
}

// The judge is killed without time to clean up, and all its processes end.
TEST_P(Attack, ends_with_the_judge) {
  Submission submission("killed" + GetParam());
  std::ofstream(submission / "2_bvh/hit_box.cpp")
      << "#include \"pt/tasks/hit_box.h\"\nnamespace pt {\n"
         "std::optional<Interval> hit_box(const Box&, const Ray&) {\n"
         "  for (volatile int i = 0;; i = i + 1) {}\n}\n}\n";
  process::Child judge{
      submission.command({"--isolation", GetParam(), "--call-limit", "60000", "hit_box"}),
      environment(),
      {},
      "",
      {}};
  const pid_t pid = process::spawn(judge);
  int status = 0;
  bool ended = false, started = false;
  for (int i = 0; i < 6000 && !ended && !started; ++i) {
    usleep(10000);
    ended = waitpid(pid, &status, WNOHANG) == pid;
    started = !running(submission).empty();
  }
  if (ended && WEXITSTATUS(status) == 2) GTEST_SKIP() << "NOT TESTED in tier " << GetParam();
  EXPECT_TRUE(started);
  if (!ended) {
    kill(pid, SIGKILL);
    waitpid(pid, &status, 0);
  }
  for (int i = 0; i < 200 && !running(submission).empty(); ++i) usleep(10000);
  EXPECT_EQ(running(submission), std::vector<std::string>{});
  note("killed/hit_box", GetParam(), HasFailure() ? "GOT THROUGH" : "ends");
}

INSTANTIATE_TEST_SUITE_P(tier, Attack, testing::Values("A", "B"),
                         [](const auto& tier) { return tier.param; });

// Shows that these attacks can succeed: here only limits stop them.
TEST(attack, gets_somewhere_where_nothing_is_isolated) {
  Submission submission("open");
  submission.put("reach");
  std::ofstream(submission / "1_rays/hit_sphere.cpp")
      << "#include \"" FIRSTLIGHT_ROOT "/CMakeLists.txt\"\n";
  const std::vector<std::string> slugs{"camera_ray", "hit_triangle", "hit_bvh"};
  std::vector<std::string> words{"--isolation", "C", "hit_sphere"};
  words.insert(words.end(), slugs.begin(), slugs.end());
  const Outcome outcome = submission.grade_afresh(words);
  EXPECT_EQ(outcome.results.at("isolation"), "C: rlimits only, not isolated");
  for (const std::string& slug : slugs) {
    const std::string printed = outcome.task(slug).at("printed");
    EXPECT_NE(printed.find("BROKE OUT"), std::string::npos) << slug << ": " << printed;
  }
  const std::string shown = outcome.task("hit_sphere").at("compiler_output");
  EXPECT_NE(shown.find("invalid preprocessing directive"), std::string::npos) << shown;
}

TEST(attack, is_not_even_tried_where_isolation_is_required_and_there_is_none) {
  const Submission submission("required");
  const Outcome outcome =
      submission.grade({"--require-isolation", "--isolation", "C", "camera_ray"});
  EXPECT_EQ(outcome.exit_status, 2);
  EXPECT_TRUE(outcome.results.is_null());
  EXPECT_EQ(std::count(outcome.output.begin(), outcome.output.end(), '\n'), 1) << outcome.output;
  EXPECT_NE(outcome.output.find("--require-isolation"), std::string::npos) << outcome.output;
}

}  // namespace
}  // namespace grader::tests
