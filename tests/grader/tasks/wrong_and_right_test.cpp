#include "grader/base/files.h"
#include "grader/base/parallel.h"
#include "grader/base/sha256.h"
#include "tests/fixtures/submission.h"
#include "tests/fixtures/task_folder.h"

#include <algorithm>
#include <cstdio>
#include <map>
#include <set>
#include <thread>

#include <fmt/format.h>
#include <gtest/gtest.h>

// Tests the grader, for every task with properties or for the tasks on the command line. With
// --each N, it judges N solutions of a kind for each task, always the same ones.

namespace grader::tests {
namespace {

namespace fs = std::filesystem;

enum class Kind { wrong, right, noisy, stub };

// One submitted file and its results.
struct Submission {
  std::string slug;
  Kind kind{};
  fs::path file;
  std::string label;  // the broken promise, what is right about it, or the recipe that is noisy
  Verdict verdict;
};

struct Task {
  std::string slug;
  std::vector<std::string> promises;  // in the contract
  std::set<std::string> properties;   // in the program
};

const fs::path kRoot = FIRSTLIGHT_ROOT;

std::vector<std::string> chosen;
std::size_t at_most = 0;  // 0: all

bool is_bonus(const std::string& promise) { return promise.ends_with("_bonus"); }

std::set<std::string> properties_of(const std::string& slug) {
  const std::string command =
      fmt::format("'{}/check.{}.reference' --gtest_list_tests", FIRSTLIGHT_CHECKS, slug);
  std::FILE* pipe = popen(command.c_str(), "r");
  std::set<std::string> names;
  for (char line[256]; pipe != nullptr && std::fgets(line, sizeof line, pipe) != nullptr;) {
    const std::string text = line;
    if (text.starts_with("  ")) names.insert(text.substr(2, text.find_last_not_of(" \n") - 1));
  }
  if (pipe != nullptr) pclose(pipe);
  return names;
}

std::vector<Task> find_tasks() {
  std::vector<Task> tasks;
  for (const auto& entry : fs::directory_iterator(kRoot / "grader/tasks")) {
    const std::string slug = entry.path().filename();
    if (!fs::exists(entry.path() / "properties.cpp")) continue;
    if (!chosen.empty() && std::find(chosen.begin(), chosen.end(), slug) == chosen.end()) continue;
    tasks.push_back({slug, promises_in(kRoot / "pt/tasks" / (slug + ".h")), properties_of(slug)});
  }
  return tasks;
}

std::vector<Submission> find_submissions(const std::vector<Task>& tasks) {
  std::vector<Submission> all;
  for (const Task& task : tasks) {
    const auto add = [&](Kind kind, const char* folder, const char* label) {
      for (const KeptSolution& each : kept_solutions(kRoot, task.slug, folder)) {
        all.push_back({task.slug, kind, each.file, first_line(each.file, label), {}});
      }
    };
    add(Kind::wrong, "wrong", "// breaks: ");
    add(Kind::right, "right", "// right: ");
    add(Kind::noisy, "noisy", "// noisy: ");
    for (const auto& part : fs::directory_iterator(kRoot / "student")) {
      const fs::path file = part.path() / (task.slug + ".cpp");
      if (fs::exists(file)) all.push_back({task.slug, Kind::stub, file, "", {}});
    }
  }
  return all;
}

void judge_all(std::vector<Submission>& submissions) {
  const auto threads = static_cast<int>(std::thread::hardware_concurrency());
  base::for_each(submissions.size(), threads, [&](std::size_t i) {
    Submission& s = submissions[i];
    const std::string filter = s.kind == Kind::wrong  ? s.slug + "." + s.label
                               : s.kind == Kind::stub ? "*"
                                                      : "-*_bonus";
    s.verdict = judge(s.slug, s.file, filter, std::to_string(i));
  });
}

const std::vector<Task>& tasks() {
  static const std::vector<Task> all = find_tasks();
  return all;
}

const std::vector<Submission>& kept() {
  static const std::vector<Submission> all = find_submissions(tasks());
  return all;
}

// The solutions that are judged.
const std::vector<Submission>& submissions() {
  static const std::vector<Submission> all = [] {
    std::vector<Submission> found = kept();
    if (at_most > 0) {
      std::ranges::sort(found, {}, [](const Submission& s) {
        return base::sha256(s.file.parent_path().filename().string() + s.file.filename().string());
      });
      std::map<std::pair<std::string, Kind>, std::size_t> seen;
      std::erase_if(found, [&](const Submission& s) { return ++seen[{s.slug, s.kind}] > at_most; });
    }
    judge_all(found);
    return found;
  }();
  return all;
}

TEST(SelfCheck, has_tasks) { EXPECT_FALSE(tasks().empty()); }

TEST(SelfCheck, has_a_property_for_every_promise_and_a_promise_for_every_property) {
  for (const Task& task : tasks()) {
    const std::set<std::string> promises(task.promises.begin(), task.promises.end());
    EXPECT_FALSE(promises.empty()) << task.slug;
    EXPECT_EQ(promises, task.properties) << task.slug;
  }
}

TEST(SelfCheck, has_a_wrong_solution_for_every_promise) {
  for (const Task& task : tasks()) {
    for (const std::string& promise : task.promises) {
      EXPECT_TRUE(std::ranges::any_of(kept(),
                                      [&](const Submission& s) {
                                        return s.kind == Kind::wrong && s.slug == task.slug &&
                                               s.label == promise;
                                      }))
          << task.slug << " has no wrong solution that breaks " << promise;
    }
  }
}

TEST(SelfCheck, has_a_right_variant_of_every_task) {
  for (const Task& task : tasks()) {
    EXPECT_TRUE(std::ranges::any_of(kept(), [&](const Submission& s) {
      return s.kind == Kind::right && s.slug == task.slug && !s.label.empty();
    })) << task.slug;
  }
}

TEST(SelfCheck, compiles_every_solution) {
  for (const Submission& s : submissions()) {
    EXPECT_TRUE(s.verdict.compiled) << s.file << "\n" << s.verdict.output;
  }
}

TEST(SelfCheck, audits_no_solution_away) {
  for (const Submission& s : submissions()) {
    EXPECT_EQ(s.verdict.audit, "") << s.file;
  }
}

TEST(SelfCheck, rejects_every_wrong_solution_for_the_promise_it_names) {
  for (const Submission& s : submissions()) {
    if (s.kind != Kind::wrong) continue;
    const Task& task = *std::ranges::find(tasks(), s.slug, &Task::slug);
    EXPECT_TRUE(task.properties.contains(s.label)) << s.file << " breaks no promise there is";
    EXPECT_FALSE(s.verdict.passed) << s.file << " keeps " << s.label;
  }
}

// A solution that is only too noisy keeps every promise; its pictures fail (noisy_test.cpp).
TEST(SelfCheck, accepts_every_right_solution_and_every_noisy_one) {
  for (const Submission& s : submissions()) {
    if (s.kind != Kind::right && s.kind != Kind::noisy) continue;
    EXPECT_FALSE(s.label.empty()) << s.file << " does not say what is different";
    EXPECT_TRUE(s.verdict.passed) << s.file << "\n" << s.verdict.output;
  }
}

TEST(SelfCheck, sees_that_a_stub_is_not_attempted) {
  for (const Submission& s : submissions()) {
    if (s.kind != Kind::stub) continue;
    EXPECT_FALSE(s.verdict.crashed) << s.file << "\n" << s.verdict.output;
    EXPECT_NE(s.verdict.output.find(s.slug + " is not written yet"), std::string::npos) << s.file;
  }
}

// A promise that nothing keeps is too strict: the reference or a variant keeps each bonus.
TEST(SelfCheck, has_a_solution_that_keeps_every_bonus_promise) {
  for (const Task& task : tasks()) {
    for (const std::string& promise : task.promises) {
      if (!is_bonus(promise)) continue;
      bool kept = false;
      std::vector<fs::path> files = base::sources_in(kRoot / "grader/tasks" / task.slug / "right");
      for (const auto& part : fs::directory_iterator(kRoot / "reference")) {
        const fs::path file = part.path() / (task.slug + ".cpp");
        if (fs::exists(file)) files.push_back(file);
      }
      for (const fs::path& file : files) {
        kept = kept || judge(task.slug, file, task.slug + "." + promise, "bonus").passed;
      }
      EXPECT_TRUE(kept) << task.slug << " " << promise;
    }
  }
}

}  // namespace
}  // namespace grader::tests

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  std::vector<std::string> words(argv + 1, argv + argc);
  if (words.size() >= 2 && words[0] == "--each") {
    grader::tests::at_most = std::stoul(words[1]);
    words.erase(words.begin(), words.begin() + 2);
  }
  grader::tests::chosen = words;
  return RUN_ALL_TESTS();
}
