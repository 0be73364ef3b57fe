// A task may use the standard library: its object passes the audit, links and runs.
#include "grader/service/audit/audit.h"
#include "pt/file.h"

#include <cstdlib>
#include <filesystem>
#include <tuple>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

namespace grader::tests {
namespace {

namespace fs = std::filesystem;

// A file and an optimisation level. A submission is compiled at the build's level; a function that
// is inline at one level is called at another.
class StandardLibrary : public testing::TestWithParam<std::tuple<std::string, std::string>> {};

void run(const std::string& command) { EXPECT_EQ(std::system(command.c_str()), 0) << command; }

TEST_P(StandardLibrary, is_open_to_a_task) {
  const auto& [name, level] = GetParam();
  const fs::path folder =
      fs::path(testing::TempDir()) / fmt::format("firstlight_library{}{}{}", getpid(), name, level);
  fs::create_directories(folder);
  const std::string object = folder / "task.o", program = folder / "program";
  pt::write_file(folder / "main.cpp",
                 "#include <cmath>\nnamespace pt { double task(); }\n"
                 "int main() { return std::isfinite(pt::task()) ? 0 : 1; }\n");
  run(fmt::format("{} -std=c++20 -{} -ffp-contract=off -fno-math-errno -w -c '{}/{}.cpp' -o '{}'",
                  FIRSTLIGHT_CXX, level, FIRSTLIGHT_LIBRARY, name, object));
  Task made_up;
  made_up.slug = "task";
  EXPECT_EQ(audit::audit(pt::read_file(object), {"_ZN2pt4taskEv"}, made_up), "");
  run(fmt::format("{} -std=c++20 '{}' '{}' -pthread -o '{}'", FIRSTLIGHT_CXX, object,
                  (folder / "main.cpp").string(), program));
  run(fmt::format("'{}' > /dev/null 2>&1", program));
  fs::remove_all(folder);
}

INSTANTIATE_TEST_SUITE_P(
    of, StandardLibrary,
    testing::Combine(testing::Values("memory", "containers", "text", "numbers", "language"),
                     testing::Values("O0", "O2")),
    [](const auto& each) { return std::get<0>(each.param) + "_" + std::get<1>(each.param); });

}  // namespace
}  // namespace grader::tests
