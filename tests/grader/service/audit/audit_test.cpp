// Object files that may be linked, and others: compiled from a few lines, or damaged.
#include "grader/service/audit/audit.h"

#include "grader/service/build/headers.h"
#include "grader/tasks.h"
#include "pt/error.h"
#include "pt/file.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <random>
#include <string_view>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

namespace grader::tests {
namespace {

namespace fs = std::filesystem;

// Returns the object of these lines, from this build's compiler.
std::string compiled(const std::string& text) {
  const fs::path folder =
      fs::path(testing::TempDir()) / fmt::format("firstlight_audit{}", getpid());
  fs::create_directories(folder);
  pt::write_file(folder / "task.cpp", text);
  const std::string command =
      fmt::format("{} -std=c++20 -O1 -w -c '{}' -o '{}'", FIRSTLIGHT_CXX,
                  (folder / "task.cpp").string(), (folder / "task.o").string());
  EXPECT_EQ(std::system(command.c_str()), 0) << text;
  std::string object = pt::read_file(folder / "task.o");
  fs::remove_all(folder);
  return object;
}

const std::string kTask = "namespace pt { int task(int x) { return x; } }\n";

// It may call one other task and one function of the renderer.
Task made_up() {
  Task task;
  task.slug = "task";
  task.calls = {"camera_ray"};
  task.framework = {"pt::Engine::closest"};
  return task;
}

std::string verdict(const std::string& text) {
  static const std::set<std::string> contract = audit::functions_in(compiled(kTask));
  return audit::audit(compiled(text), contract, made_up());
}

TEST(audit, knows_a_contract_by_its_object) {
  EXPECT_EQ(audit::functions_in(compiled(kTask)), std::set<std::string>{"_ZN2pt4taskEi"});
}

// One file with everything that a learner may write.
TEST(audit, accepts_a_task_and_its_helpers) {
  EXPECT_EQ(verdict(R"(
#include <algorithm>
#include <cassert>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <functional>
#include <iostream>
#include <map>
#include <memory>
#include <random>
#include <sstream>
#include <stdexcept>
#include <string>
#include <unordered_map>
#include <variant>
#include <vector>
namespace pt {
int camera_ray(int);
struct Shape { virtual ~Shape() = default; virtual double area() const = 0; };
struct Square : Shape { double a = 2; double area() const override { return a * a; } };
template <class T> T twice(T x) { static T last = 0; return last = x + x; }
inline int counter = 0;
inline thread_local int of_this_thread = 3;
namespace {
int helper(int x) { static std::vector<int> seen; seen.push_back(x); return int(seen.size()); }
std::map<std::string, double> table{{"a", 1.5}};
}
static double sum(const std::vector<double>& all) { double s = 0; for (double x : all) s += x; return s; }
int task(int x) {
  std::unique_ptr<Shape> shape = std::make_unique<Square>();
  std::function<double(double)> f = [=](double y) { return std::sin(y) + std::pow(y, x); };
  std::mt19937 random(1);
  std::vector<double> v{f(1), std::uniform_real_distribution<double>()(random), std::lgamma(x)};
  std::sort(v.begin(), v.end());
  std::unordered_map<int, std::string> names{{1, "one"}};
  std::ostringstream text;
  text << shape->area() << sum(v) << twice(2.5) << ++counter << of_this_thread;
  std::cout << text.str() << std::endl;
  std::printf("%d %s\n", helper(x), names.at(1).c_str());
  assert(x > 0);
  if (x == 17) throw std::runtime_error("17");
  const auto now = std::chrono::steady_clock::now();
  __int128 wide = x; wide = wide * wide / 7;
  return camera_ray(x) + int(wide) + int(now.time_since_epoch().count());
}
})"),
            "");
}

struct Attempt {
  const char* text;     // added to the task
  const char* because;  // a part of the sentence
};

TEST(audit, rejects_what_reaches_beyond_the_task) {
  const Attempt attempts[] = {
      {"namespace pt { int helper(int x) { return x; } }", "pt::helper(int)"},
      {"namespace pt { int table[3]{1, 2, 3}; }", "pt::table"},
      {"asm(\".bss\\n.zero 300000000\\n.text\");", "take more than 256 MiB"},
      {"asm(\".bss\\n.zero 6000000000\\n.text\");", "take more than 256 MiB"},
      {"extern \"C\" int memcmp(const void*, const void*, unsigned long) { return 0; }", "memcmp"},
      {"extern \"C\" __attribute__((weak)) int memcmp(const void*, const void*, unsigned long) "
       "{ return 0; }",
       "memcmp"},
      {"extern \"C\" void* malloc(unsigned long) { return nullptr; }", "malloc"},
      {"void* operator new(unsigned long) { return nullptr; }", "operator new"},
      {"void operator delete(void*) noexcept {}", "operator delete"},
      {"namespace grader::wire { void send(int) {} }", "grader::wire::send"},
      {"namespace grader::wire { __attribute__((weak)) void send(int) {} }", "grader::wire::send"},
      {"namespace grader { inline void send(int) {} void (*use)(int) = send; }", "grader::send"},
      {"namespace grader { void send(int); void use() { send(1); } }", "grader::"},
      {"void* operator new(unsigned long, int) { return nullptr; }", "operator new"},
      {"int main() { return 0; }", "main"},
      {"#include <cstdlib>\nstatic int x = std::rand();", "rand"},
      {"#include <cstdlib>\nstatic long x = random();", "random"},
      {"extern \"C\" int fork(); static int x = fork();", "fork"},
      {"extern \"C\" long syscall(long, ...); static long x = syscall(57);", "syscall"},
      {"extern \"C\" int system(const char*); static int x = system(\"ls\");", "system"},
      {"#include <thread>\nstatic std::thread t([] {});", "_M_start_thread"},
      {"#include <future>\nstatic auto f = std::async([] { return 1; });", "_M_start_thread"},
      {"extern \"C\" void* dlopen(const char*, int); static void* x = dlopen(\"x\", 1);", "dlopen"},
      {"extern \"C\" int socket(int, int, int); static int x = socket(2, 1, 0);", "socket"},
      {"static long (*f)() ; extern \"C\" long ptrace(int); static long x = ptrace(0);", "ptrace"},
      {"int x;", "defines x,"},
      {"int f(int x) __attribute__((weak, alias(\"_ZN2pt4taskEi\")));", "defines f(int)"},
      {"asm(\".comm shared, 8\");", "shared"},
      {"asm(\".globl number\\n.set number, 5\");", "number"},
      {"extern \"C\" { static int (*pick())(int) { return nullptr; } "
       "int chosen(int) __attribute__((ifunc(\"pick\"))); }",
       "chosen"},
      {"asm(\".section .gnu.lto_.x\\n.byte 1\\n.text\");", ".gnu.lto_.x"},
      {"asm(\".section .gnu.warning.x\\n.ascii \\\"x\\\"\\n.text\");", ".gnu.warning.x"},
      {"asm(\".section .interp,\\\"a\\\"\\n.asciz \\\"/x\\\"\\n.text\");", ".interp"},
      {"asm(\".section .preinit_array,\\\"aw\\\"\\n.quad 0\\n.text\");", ".preinit_array"},
      {"asm(\".section .init,\\\"ax\\\"\\nnop\\n.text\");", ".init'"},
      {"asm(\".section .deplibs,\\\"MS\\\",@0x6fff4c04,1\\n.asciz \\\"x\\\"\\n.text\");",
       ".deplibs"},
  };
  for (const Attempt& attempt : attempts) {
    const std::string reason = verdict(kTask + attempt.text + "\n");
    EXPECT_NE(reason.find(attempt.because), std::string::npos) << attempt.text << "\n" << reason;
  }
}

// Any of these names would make the linker look for a definition, however it got into the object.
TEST(audit, rejects_calls_that_the_contract_does_not_allow) {
  const Attempt attempts[] = {
      {"namespace pt { double fast(int); double use() __attribute__((weak)); "
       "static double x = fast(1); }",
       "it calls pt::fast; task may only call camera_ray and pt::Engine::closest"},
      {"namespace pt { struct Engine { int any(int) const; }; static int x = Engine().any(1); }",
       "it calls pt::Engine::any;"},
      {"namespace pt { int other(int); static int (*pointer)(int) = other; "
       "static int x = pointer(2); }",
       "it calls pt::other;"},
      {"int renamed(int) asm(\"_ZN2pt5otherEi\"); static int x = renamed(1);",
       "it calls pt::other;"},
      {"asm(\".data\\n.quad _ZN2pt5otherEi\\n.text\");", "it calls pt::other;"},
      {"namespace pt { extern int table[3]; static volatile int x = table[1]; }",
       "it calls pt::table;"},
      {"namespace pt { extern int weak(int) __attribute__((weak)); static volatile bool x = weak "
       "!= nullptr; }",
       "it calls pt::weak;"},
      {"namespace pt::deep { int down(int); static int x = down(1); }", "it calls pt::deep::down;"},
      {"namespace pt { template <class T> int one(T); extern template int one<int>(int); "
       "static int x = one(1); }",
       "it calls int pt::one<int>;"},
      {"namespace pt { struct Base { virtual ~Base(); virtual int f() const; }; "
       "struct Own : Base {}; static Base* b = new Own; }",
       "pt::Base::"},
      {"namespace grader { struct Judge { static int points; }; static volatile int x = "
       "Judge::points; }",
       "it uses grader::Judge::points"},
      {"#include <vector>\nnamespace grader { struct A {}; } extern template class "
       "std::vector<grader::A>; static std::vector<grader::A> v(3);",
       "grader::A"},
      {"namespace pt { int todo_reached(int); static int x = todo_reached(1); }", "todo_reached"},
  };
  for (const Attempt& attempt : attempts) {
    const std::string reason = verdict(kTask + attempt.text + "\n");
    EXPECT_NE(reason.find(attempt.because), std::string::npos) << attempt.text << "\n" << reason;
  }
}

TEST(audit, accepts_calls_that_the_contract_allows) {
  EXPECT_EQ(verdict(kTask + R"(
namespace pt {
void todo(const char*);
int camera_ray(int), camera_ray(double);
struct Engine { int closest(int) const; };
static int (*pointer)(double) = camera_ray;
static int x = camera_ray(1) + Engine().closest(3) + pointer(1) + (todo("task"), 1);
}
)"),
            "");
}

// Functions that are complete in a header need no linker, so this header is not installed.
TEST(headers, that_trace_are_closed_to_what_is_to_be_traced) {
  const build::Headers all = build::public_headers(FIRSTLIGHT_ROOT);
  for (const auto& entry : fs::directory_iterator(FIRSTLIGHT_ROOT "/pt/tasks")) {
    const std::string slug = entry.path().stem();
    const build::Headers headers = build::headers_for(task_of(slug), all);
    EXPECT_EQ(headers.size(), all.size());
    const auto open = [&](const std::string& path) { return headers.at(path) == all.at(path); };
    EXPECT_TRUE(open("pt/tasks/" + slug + ".h")) << slug;
    EXPECT_TRUE(open("pt/math/frame.h") && open("pt/sampling/directions.h")) << slug;
    EXPECT_TRUE(open("pt/geometry/primitives.h") && open("pt/todo.h")) << slug;
    for (const char* closed :
         {"pt/accel/closest_hit.h", "pt/accel/traverse.h", "pt/render/common_radiance.h",
          "pt/render/render_film.h", "pt/image/image_io.h", "pt/scene/load_collada.h"}) {
      EXPECT_FALSE(open(closed)) << slug << " " << closed;
    }
    const bool traces = slug.starts_with("direct_") || slug == "trace_path";
    const bool pixel = slug.ends_with("_pixel");
    EXPECT_EQ(open("pt/scene/scene.h"), traces || pixel) << slug;
    EXPECT_EQ(open("pt/accel/exact_hit.h"), traces || pixel) << slug;
    EXPECT_EQ(open("pt/render/radiance.h"), pixel) << slug;
  }
}

// Names may contain anything; the report treats them as text.
TEST(audit, shows_names_without_control_characters) {
  const std::string reason =
      verdict(kTask + "asm(\".globl \\\"a\\033[2Jb\\\"\\n\\\"a\\033[2Jb\\\":\");");
  EXPECT_NE(reason.find("it defines a [2Jb"), std::string::npos) << reason;
}

TEST(audit, rejects_what_is_no_object) {
  EXPECT_NE(audit::audit("", {}, {}), "");
  EXPECT_NE(audit::audit("INPUT(/etc/passwd)", {}, {}), "");
  EXPECT_NE(audit::audit("!<arch>\n", {}, {}), "");
  std::string program = compiled(kTask);
  program[16] = 2;  // a program, not an object
  EXPECT_NE(audit::audit(program, {}, {}), "");
}

// Sizes and offsets that point nowhere are noticed, and the sanitisers detect any other read.
TEST(audit, survives_damaged_objects) {
  const std::string object = compiled(kTask);
  const std::set<std::string> contract = audit::functions_in(object);
  std::mt19937 random(20);
  int rejected = 0;
  for (int i = 0; i < 20000; ++i) {
    std::string damaged = object;
    for (int change = 0; change <= i % 4; ++change) {
      damaged[random() % damaged.size()] = static_cast<char>(random());
    }
    if (i % 5 == 0) damaged.resize(random() % damaged.size());
    rejected += audit::audit(damaged, contract, {}).empty() ? 0 : 1;
  }
  EXPECT_GT(rejected, 4000) << "all that were cut";
}

}  // namespace
}  // namespace grader::tests
