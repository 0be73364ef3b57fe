#include "grader/self_check/submission.h"

#include "grader/judge/audit.h"
#include "grader/judge/config.h"
#include "grader/judge/precompiled.h"
#include "grader/judge/submission_flags.h"
#include "grader/tasks.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/wait.h>

namespace grader::self_check {

namespace {

namespace fs = std::filesystem;

// Limits of one wrong solution: they end an endless loop. The right ones take well under a second.
constexpr int kCpuSeconds = 5;
constexpr int kWallSeconds = 30;
constexpr long kMemoryBytes = 1L << 30;

std::string quoted(const fs::path& path) { return "'" + path.string() + "'"; }

std::string text_of(const fs::path& file) {
  std::ifstream in(file);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

// Through the shell; both streams go to `log`.
int run(const std::string& command, const fs::path& log) {
  return std::system(fmt::format("{} > {} 2>&1", command, quoted(log)).c_str());
}

const judge::Config& config() {
  static const judge::Config known = judge::load_config(fs::path(FIRSTLIGHT_CHECKS) / "grade.json");
  return known;
}

// The flags with which `grade` compiles a file of the task.
std::string compile_flags(const std::string& slug, const fs::path& file) {
  static const judge::PrecompiledHeaders precompiled(config(),
                                                     judge::public_headers(FIRSTLIGHT_ROOT));
  const auto task = std::ranges::find(config().tasks, slug, &judge::TaskConfig::slug);
  return fmt::format("{} {} {}", fmt::join(config().compile_flags, " "),
                     fmt::join(judge::kSubmissionFlags, " "),
                     fmt::join(precompiled.flags_for(*task, text_of(file)), " "));
}

// Compiles a file as `grade` does; false if it does not compile.
bool compile(const std::string& slug, const fs::path& file, const fs::path& object,
             const fs::path& log) {
  const std::string command =
      fmt::format("{} {} -I{} -c {} -o {}", FIRSTLIGHT_CXX, compile_flags(slug, file),
                  quoted(FIRSTLIGHT_ROOT), quoted(file), quoted(object));
  if (run(command, log) != 0) return false;
  if (text_of(log).find(judge::kNoReturn) == std::string::npos) return true;
  return run(fmt::format("{} {}", command, fmt::join(judge::kTrapFlags, " ")), log) == 0;
}

// The functions that the reference defines.
std::set<std::string> contract_of(const std::string& slug) {
  std::ifstream names(fs::path(FIRSTLIGHT_OBJECTS) / (slug + ".contract"));
  std::set<std::string> functions;
  for (std::string path; std::getline(names, path);)
    functions.merge(judge::functions_in(text_of(path)));
  return functions;
}

}  // namespace

Verdict judge(const std::string& slug, const fs::path& file, const std::string& filter,
              const std::string& scratch) {
  const fs::path folder = fs::path(FIRSTLIGHT_OBJECTS) / "scratch" / scratch;
  fs::create_directories(folder);
  const fs::path object = folder / "task.o", program = folder / "check", log = folder / "log";

  Verdict verdict;
  const std::string link = fmt::format(
      "{} {} {} @{} -pthread -o {}", FIRSTLIGHT_CXX, FIRSTLIGHT_FAST_LINKER, quoted(object),
      quoted(fs::path(FIRSTLIGHT_OBJECTS) / (slug + ".objects")), quoted(program));
  verdict.compiled = compile(slug, file, object, log) && run(link, log) == 0;
  if (verdict.compiled)
    verdict.audit = judge::audit(text_of(object), contract_of(slug), task_of(slug));
  if (verdict.compiled) {
    // A shell of its own, which prints "Segmentation fault" into the log and not on our terminal.
    const std::string properties = fmt::format(
        "timeout --signal=KILL {} prlimit --cpu={} --as={} --core=0 -- {} --gtest_filter={}",
        kWallSeconds, kCpuSeconds, kMemoryBytes, quoted(program), "'" + filter + "'");
    const int status = run(properties, log);
    const int code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    verdict.output = text_of(log);
    verdict.passed = code == 0 && verdict.output.find("[  PASSED  ] 0 tests") == std::string::npos;
    verdict.crashed = code != 0 && code != 1;
  } else {
    verdict.output = text_of(log);
  }
  fs::remove_all(folder);
  return verdict;
}

}  // namespace grader::self_check
