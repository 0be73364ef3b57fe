// One limit for the memory of a child and all its descendants, if control groups allow it.
#include "grader/service/process/memory_group.h"

#include "grader/service/process/run_command.h"
#include "tests/fixtures/temporary_folder.h"

#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

namespace grader::process {
namespace {

namespace fs = std::filesystem;

// A tree of control groups. `files` are the groups and the controllers that they pass on.
void make_groups(const std::string& top, const std::map<std::string, std::string>& files) {
  for (const auto& [group, controllers] : files) {
    fs::create_directories(top + group);
    std::ofstream(top + group + "/cgroup.subtree_control") << controllers << "\n";
    std::ofstream(top + group + "/cgroup.procs");
  }
}

TEST(memory, is_bounded_beside_the_own_group_or_below_the_first_of_all) {
  const TemporaryFolder folder;
  const std::string& top = folder.path();
  const std::string mounts = "22 1 0:20 / / rw - ext4 disk rw\n30 22 0:26 / " + top +
                             " rw,nosuid shared:4 - cgroup2 cgroup2 rw\n";
  make_groups(top, {{"", "cpu memory pids"},
                    {"/user", "cpu memory"},
                    {"/user/shell", ""},
                    {"/user/shell/inner", ""},
                    {"/other", "memory_recursiveprot"}});
  EXPECT_EQ(place_for_groups(mounts, "0::/\n"), top);
  EXPECT_EQ(place_for_groups(mounts, "4:memory:/x\n0::/user/shell\n"), top + "/user");
  EXPECT_EQ(place_for_groups(mounts, "0::/other\n"), top);
  EXPECT_EQ(place_for_groups(mounts, "0::/user/shell/inner\n"), "");
  EXPECT_EQ(place_for_groups(mounts, "0::/../elsewhere\n"), "");
  EXPECT_EQ(place_for_groups(mounts, "4:memory:/x\n"), "");
  EXPECT_EQ(place_for_groups("", "0::/\n"), "");
}

std::string text_of(const char* path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

// Four programs of 8 MiB each, all far from a limit of their own.
TEST(memory, of_a_tree_is_bounded_where_control_groups_allow_it) {
  const std::string place =
      place_for_groups(text_of("/proc/self/mountinfo"), text_of("/proc/self/cgroup"));
  if (place.empty())
    GTEST_SKIP() << "NOT TESTED: no control group with a bound on memory can be made";
  const auto runs_with = [](std::uint64_t bytes) {
    Child child{{"/bin/sh", "-c",
                 "for i in 1 2 3 4; do head -c 8M /dev/zero | tail -c 8M | sleep 2 & done; wait"},
                {"PATH=/usr/bin:/bin"},
                {},
                "",
                {}};
    child.tree_memory = bytes;
    return run_command(child, std::chrono::seconds(60));
  };
  EXPECT_TRUE(runs_with(std::uint64_t{128} << 20).ok());
  const CommandResult bounded = runs_with(std::uint64_t{20} << 20);
  EXPECT_TRUE(WIFSIGNALED(bounded.status)) << describe_status(bounded.status);
  EXPECT_EQ(WTERMSIG(bounded.status), SIGKILL);
  // The groups of ended children are removed with the next group.
  runs_with(std::uint64_t{128} << 20);
  int groups = 0;
  for (const auto& entry : fs::directory_iterator(place)) {
    groups +=
        entry.path().filename().string().starts_with("firstlight." + std::to_string(getpid()));
  }
  EXPECT_LE(groups, 1);
}

}  // namespace
}  // namespace grader::process
