#include "grader/service/process/process_time.h"

#include <algorithm>
#include <charconv>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <unistd.h>

namespace grader::process {

namespace {

namespace fs = std::filesystem;
using std::chrono::nanoseconds;

struct Stat {
  char state = 0;  // 'R': on a processor or ready for it, 'S' and others: asleep
  pid_t parent = 0;
  long long of_children = 0;  // ticks of children that were waited for
};

// Reads the fields after the name; the name stands in parentheses and may hold anything.
Stat read_stat(pid_t pid) {
  std::ifstream file(fmt::format("/proc/{}/stat", pid));
  std::string text;
  std::getline(file, text, '\0');
  const std::size_t name_end = text.rfind(')');
  if (name_end == text.npos) return {};
  std::istringstream fields(text.substr(name_end + 1));
  Stat stat;
  fields >> stat.state >> stat.parent;
  constexpr int kBetween = 11;  // fields from group to system time
  long long skipped = 0, user = 0, system = 0;
  for (int i = 0; i < kBetween; ++i) fields >> skipped;
  if (fields >> user >> system) stat.of_children = user + system;
  return stat;
}

// Empty if the kernel does not report it.
std::optional<nanoseconds> told_waiting_time(const std::string& process) {
  long long running = 0, waiting = 0;
  std::ifstream file("/proc/" + process + "/schedstat");
  if (!(file >> running >> waiting)) return std::nullopt;
  return nanoseconds(waiting);
}

nanoseconds waiting_time(const std::string& process) {
  return told_waiting_time(process).value_or(nanoseconds(0));
}

using Children = std::multimap<pid_t, pid_t>;

// The children of all processes: not every kernel lists the children of one process.
Children all_children() {
  Children children;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator("/proc", error)) {
    const std::string name = entry.path().filename();
    pid_t pid = 0;
    const auto [end, problem] = std::from_chars(name.data(), name.data() + name.size(), pid);
    if (problem != std::errc() || end != name.data() + name.size()) continue;
    children.emplace(read_stat(pid).parent, pid);
  }
  return children;
}

// The nearest descendants come first.
std::vector<pid_t> with_descendants(pid_t pid) {
  const Children children = all_children();
  std::vector<pid_t> all{pid};
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto [first, last] = children.equal_range(all[i]);
    for (auto each = first; each != last; ++each) all.push_back(each->second);
  }
  return all;
}

}  // namespace

nanoseconds running_time(pid_t pid) {
  clockid_t clock = 0;
  timespec time{};
  if (pid <= 0 || clock_getcpuclockid(pid, &clock) != 0 || clock_gettime(clock, &time) != 0) {
    return nanoseconds(0);
  }
  return std::chrono::seconds(time.tv_sec) + nanoseconds(time.tv_nsec);
}

ProcessTime time_of_process(pid_t pid) {
  if (pid <= 0) return {};
  // The state is read first: a wait that begins later counts in the next reading.
  const char state = read_stat(pid).state;
  const auto waiting = told_waiting_time(std::to_string(pid));
  const bool asleep = waiting && (state == 'S' || state == 'T');
  return {running_time(pid), waiting.value_or(nanoseconds(0)), asleep};
}

ProcessTime time_of_tree(pid_t pid) {
  if (pid <= 0) return {};
  static const nanoseconds tick = nanoseconds(std::chrono::seconds(1)) / sysconf(_SC_CLK_TCK);
  ProcessTime time;
  for (const pid_t each : with_descendants(pid)) {
    time.running += running_time(each) + tick * read_stat(each).of_children;
    time.waiting += waiting_time(std::to_string(each));
  }
  return time;
}

nanoseconds own_waiting_time() { return waiting_time("thread-self"); }

pid_t last_descendant(pid_t pid) { return with_descendants(pid).back(); }

nanoseconds SleepWatch::until_look() const {
  return std::max<nanoseconds>(kPause - waited_, nanoseconds(0));
}

void SleepWatch::look(pid_t pid) {
  doubtful_ += waited_;
  waited_ = nanoseconds(0);
  if (pid <= 0) return;
  const ProcessTime now = time_of_process(pid);
  if (!known_) {
    known_ = now;
    doubtful_ = nanoseconds(0);
    return;
  }
  if (!now.asleep) return;
  const nanoseconds slept =
      doubtful_ - (now.running - known_->running) - (now.waiting - known_->waiting);
  slept_ += std::max(slept, nanoseconds(0));
  known_ = now;
  doubtful_ = nanoseconds(0);
}

}  // namespace grader::process
