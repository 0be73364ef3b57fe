// A task that keeps a variable between its calls is found. A task that may keep it is not blamed.
#include "tests/fixtures/hostile_submission.h"

#include <fstream>
#include <span>

#include <gtest/gtest.h>

namespace grader::tests {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

// A task's own headers, and lines that are inserted at the beginning of one of its functions.
void insert(const Submission& submission, const std::string& slug, const std::string& function,
            const std::string& lines) {
  const fs::path file = submission.file_of(slug);
  std::string text = text_of(file);
  const std::size_t begin = text.find(" " + function + "(");
  ASSERT_NE(begin, std::string::npos) << file;
  text.insert(text.find("{\n", begin) + 1, "\n" + lines);
  std::ofstream(file)
      << "#include <array>\n#include <cerrno>\n#include <cfenv>\n#include <cstdio>\n#include "
         "<cstdlib>\n#include <iostream>\n#include "
         "<map>\n"
         "#include <memory>\n#include <mutex>\n#include <random>\n#include <string>\n"
         "#include <unordered_map>\n#include <vector>\n"
      << text;
}

struct Insertion {
  const char* slug;
  const char* function;
  const char* lines;
  const char* variable;
};

// The verdicts about the tasks that get these lines.
Outcome graded_with(std::span<const Insertion> insertions, const std::string& name) {
  const Submission submission(name);
  std::vector<std::string> words{"--no-pictures"};
  for (const Insertion& each : insertions) {
    insert(submission, each.slug, each.function, each.lines);
    words.emplace_back(each.slug);
  }
  return submission.grade(words);
}

// The renderer calls tasks from several threads at once, so they would share a variable that one
// call leaves for the next. With one call at a time, the answers are right.
TEST(state, that_is_kept_between_calls_is_found_wherever_it_is) {
  const Insertion insertions[] = {
      {"camera_ray", "camera_ray",
       "  static int calls = 0;\n  if (++calls < 0) std::puts(\"many\");\n", "'calls'"},
      {"hit_triangle", "hit_triangle",
       "  static std::unordered_map<double, double> memo;\n  memo[ray.t_max] += 1;\n", "'memo'"},
      {"hit_sphere", "hit_sphere",
       "  static std::mt19937 random(7);\n  if (random() + random() == 1) std::puts(\"one\");\n",
       "'random'"},
      {"build_bvh", "build_bvh",
       "  static std::vector<double> stack(64);\n  stack[3] = boxes.empty() ? 0 : boxes[0].min.x;\n"
       "  if (stack[3] == 0.123) std::puts(\"this\");\n",
       "'stack'"},
      {"hit_box", "hit_box",
       "  static auto* const state = new std::map<int, double>;\n  (*state)[3] += ray.t_min + 1;\n",
       "'state'"},
      {"estimate_pixel", "estimate_pixel",
       "  static auto* const counts = static_cast<int*>(std::calloc(8, sizeof(int)));\n"
       "  ++counts[1];\n  if (counts[1] < 0) std::puts(\"many\");\n",
       "'counts'"},
      {"direct_lights", "direct_lights",
       "  struct alignas(64) Line {\n    double last[8];\n  };\n"
       "  static Line* const line = new Line;\n  line->last[3] += samples;\n"
       "  if (line->last[3] < 0) std::puts(\"many\");\n",
       "'line'"},
      {"diffuse_bsdf", "diffuse_sample",
       "  static Sampler own(1);\n  if (own.next_1d() < 0) std::puts(\"this\");\n", "'own'"},
      {"hit_bvh", "hit_bvh",
       "  static int stack[64];\n  stack[bvh.nodes.size() % 64] = int(bvh.order.size());\n"
       "  if (stack[5] == -1) std::puts(\"this\");\n",
       "'stack'"},
  };
  const Outcome outcome = graded_with(insertions, "kept");
  for (const Insertion& each : insertions) {
    const json& task = outcome.task(each.slug);
    EXPECT_EQ(outcome.state(each.slug), "fail") << each.slug << " " << task.dump().substr(0, 2000);
    const std::string reason = task.at("reason");
    EXPECT_NE(reason.find(std::string("the variable ") + each.variable), std::string::npos)
        << each.slug << ": " << reason;
    EXPECT_EQ(task.at("keeps_state"), true);
    EXPECT_EQ(task.at("points"), task.at("max_points").get<int>() - 3) << each.slug;
  }
}

// Nothing looks into thread-local variables, but the first call of the run has another answer at its end.
TEST(state, of_a_thread_is_found_if_it_changes_an_answer) {
  const Insertion insertions[] = {
      {"camera_ray", "camera_ray", "  thread_local int calls = 0;\n  ++calls;\n", "pass"},
      {"hit_triangle", "hit_triangle",
       "  thread_local int calls = 0;\n  if (++calls > 65536) return {};\n", "fail"},
      {"hit_box", "hit_box",
       "  thread_local unsigned short calls = 0;\n  if (++calls == 0) calls = 60000;\n"
       "  if (calls >= 60000) return {};\n",
       "fail"},
      // A tree of one box, and radiances that are given in advance: the worker makes these calls again without the judge.
      {"build_bvh", "build_bvh",
       "  thread_local unsigned short calls = 0;\n  if (++calls == 0) return {};\n", "fail"},
      {"estimate_pixel", "estimate_pixel",
       "  thread_local unsigned short calls = 0;\n  if (++calls == 0) return {};\n", "fail"},
      {"adaptive_pixel", "adaptive_pixel",
       "  thread_local int calls = 0;\n  if (++calls > 65536) return {};\n", "fail"},
  };
  const Outcome outcome = graded_with(insertions, "thread");
  for (const auto& [slug, function, lines, state] : insertions) {
    const json& task = outcome.task(slug);
    EXPECT_EQ(outcome.state(slug), state) << slug << " " << task.dump().substr(0, 2000);
    EXPECT_EQ(task.at("keeps_state"), std::string(state) == "fail") << slug;
    if (std::string(state) == "pass") continue;
    const std::string reason = task.at("reason");
    EXPECT_EQ(reason.find("one of its first calls has another answer"), 0U) << slug << reason;
  }
}

// The next call, of this task or of another, would be computed in another way.
TEST(state, of_the_processor_is_left_as_it_was) {
  const Insertion insertions[] = {
    {"camera_ray", "camera_ray", "  if (x > 0.3) std::fesetround(FE_UPWARD);\n", "fail"},
    {"hit_triangle", "hit_triangle",
     "  const int mode = std::fegetround();\n  std::fesetround(FE_DOWNWARD);\n"
     "  if (std::fesetround(mode) != 0) std::puts(\"no\");\n",
     "pass"},
#if defined(__SSE__)
    {"hit_sphere", "hit_sphere", "  __builtin_ia32_ldmxcsr(__builtin_ia32_stmxcsr() | 0x8040);\n",
     "fail"},
#endif
    // No call finds what another one left in errno.
    {"hit_box", "hit_box", "  if (errno == 77) return {};\n  errno = 77;\n", "pass"},
  };
  const Outcome outcome = graded_with(insertions, "processor");
  for (const auto& [slug, function, lines, state] : insertions) {
    const json& task = outcome.task(slug);
    EXPECT_EQ(outcome.state(slug), state) << slug << " " << task.dump().substr(0, 2000);
    EXPECT_EQ(task.at("keeps_state"), std::string(state) == "fail") << slug;
    if (std::string(state) == "pass") continue;
    const std::string reason = task.at("reason");
    EXPECT_EQ(reason.find("a call changes how the processor rounds"), 0U) << slug << reason;
  }
}

TEST(state, that_no_thread_can_spoil_is_right) {
  const Insertion insertions[] = {
      {"camera_ray", "camera_ray",
       "  static const std::vector<double> table = [] { return std::vector<double>{1, 2, 3}; }();\n"
       "  if (table[1] < x - 5) std::puts(\"small\");\n",
       ""},
      {"hit_triangle", "hit_triangle",
       "  thread_local std::vector<double> scratch;\n  scratch.assign(3, ray.t_max);\n"
       "  thread_local int calls = 0;\n  if (++calls < 0) std::puts(\"many\");\n",
       ""},
      {"hit_sphere", "hit_sphere",
       "  static std::once_flag once;\n  static double constant;\n"
       "  std::call_once(once, [] { constant = 3; });\n"
       "  static constexpr std::array<double, 3> kTable{1, 2, 3};\n"
       "  if (constant + kTable[1] < 0) std::puts(\"small\");\n",
       ""},
      {"build_bvh", "build_bvh",
       "  static const auto shared = std::make_shared<std::map<int, std::string>>();\n"
       "  const auto copy = shared;\n  static bool said = false;\n"
       "  if (!said) std::cout << copy->size() << std::endl;\n  said = true;\n",
       ""},
      // Two constants in one word, set by different calls.
      {"hit_box", "hit_box",
       "  volatile float zero = 0;\n  if (ray.t_min > 0) {\n    static const float one = zero + "
       "1;\n"
       "    if (one < 0) std::puts(\"small\");\n  } else {\n"
       "    static const float two = zero + 2;\n    if (two < 0) std::puts(\"small\");\n  }\n",
       ""},
  };
  const Outcome outcome = graded_with(insertions, "constant");
  for (const Insertion& each : insertions) {
    EXPECT_EQ(outcome.state(each.slug), "pass")
        << each.slug << " " << outcome.task(each.slug).dump().substr(0, 2000);
  }
}

}  // namespace
}  // namespace grader::tests
