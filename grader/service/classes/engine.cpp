#include "grader/service/classes/engine.h"

#include "grader/base/descriptor.h"
#include "grader/base/parallel.h"
#include "grader/base/printable.h"
#include "grader/service/process/spawn.h"
#include "pt/error.h"
#include "pt/file.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <mutex>

#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

namespace grader::classes {

namespace {

namespace fs = std::filesystem;

constexpr int kTries = 3;
constexpr int kBetweenLooks = 1000;  // milliseconds
constexpr std::size_t kMaxSaid = 400;
constexpr const char* kNotSeen = "not looked at yet";
constexpr std::size_t kMaxSlurmChunk = 1000;  // Slurm's default for MaxArraySize is 1001

// Returns the word quoted for a shell.
std::string quoted(const std::string& word) {
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

std::string find_program(const std::string& name) {
  const char* path = std::getenv("PATH");
  std::string folders = path == nullptr ? "/usr/bin:/bin" : path;
  for (std::size_t at = 0; at <= folders.size();) {
    const std::size_t end = std::min(folders.find(':', at), folders.size());
    std::string file = folders.substr(at, end - at) + "/" + name;
    if (access(file.c_str(), X_OK) == 0) return file;
    at = end + 1;
  }
  throw pt::Error(fmt::format("{} is not installed here; install {}, or grade with --engine local",
                              name, name == "sbatch" ? "Slurm (slurm-client)" : "GNU parallel"));
}

// The numbers of the unfinished chunks.
std::vector<std::size_t> not_done(const Judging& judging, const ClassPlan& plan) {
  std::vector<std::size_t> numbers;
  for (std::size_t chunk = 0; chunk < plan.chunks.size(); ++chunk) {
    const bool done = std::ranges::all_of(plan.chunks[chunk], [&](const Equal& equal) {
      return std::ranges::all_of(
          equal, [&](std::size_t i) { return is_done(judging, plan.everybody[i]); });
    });
    if (!done) numbers.push_back(chunk + 1);
  }
  return numbers;
}

// "1,2,5" for Slurm.
std::string list_of(const std::vector<std::size_t>& numbers) {
  return fmt::format("{}", fmt::join(numbers, ","));
}

// Reports the submissions that other processes have judged since the last look.
class Watch {
 public:
  Watch(const Judging& judging, const ClassPlan& plan, const Report& report)
      : judging_(judging), plan_(plan), report_(report) {
    for (const Chunk& chunk : plan.chunks) {
      for (const Equal& equal : chunk) {
        for (const std::size_t i : equal) waiting_[i] = kNotSeen;
      }
    }
  }

  // `first`: outcomes that are there already come from an earlier call.
  void look(bool first) {
    for (auto at = waiting_.begin(); at != waiting_.end();) {
      const std::size_t i = at->first;
      const std::string before = at->second;
      at->second = outcome_so_far(judging_, plan_.everybody[i]);
      if (at->second != before && is_done(judging_, plan_.everybody[i])) {
        Graded graded = graded_before(judging_, plan_.everybody[i]);
        graded.again = first;
        report_(i, graded);
        at = waiting_.erase(at);
      } else {
        ++at;
      }
    }
  }

 private:
  const Judging& judging_;
  const ClassPlan& plan_;
  const Report& report_;
  // For each submission, the outcome at the last look. Reports of an earlier class stay until they
  // are replaced; only reading all files of a submission would show that they are old.
  std::map<std::size_t, std::string> waiting_;
};

// Runs the command with our whole environment: it needs ssh keys and settings of the cluster.
pid_t start(const std::vector<std::string>& command, const std::string& log) {
  const base::Descriptor nothing(open("/dev/null", O_RDONLY | O_CLOEXEC));
  const base::Descriptor file(open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644));
  if (!file.is_open()) throw pt::Error(log + ": cannot be written");
  return process::spawn({command,
                         process::own_environment(),
                         {nothing.number(), file.number(), file.number()},
                         "",
                         {}});
}

void run_elsewhere(const Judging& judging, const ClassPlan& plan, const EngineRequest& request,
                   const Report& report) {
  Watch watch(judging, plan, report);
  watch.look(true);
  const std::string log = judging.out + "/engine.log";
  std::vector<std::size_t> numbers = not_done(judging, plan);
  for (int i = 0; i < kTries && !numbers.empty(); ++i) {
    const pid_t pid = start(engine_command(request, judging.out, numbers), log);
    int status = 0;
    while (waitpid(pid, &status, WNOHANG) == 0) {
      poll(nullptr, 0, kBetweenLooks);
      watch.look(false);
    }
    watch.look(false);
    const std::size_t before = numbers.size();
    numbers = not_done(judging, plan);
    if (status != 0 && numbers.size() == before && i + 1 == kTries) {
      throw pt::Error(fmt::format("no chunk could be run: {} (all of it is in {})",
                                  base::printable(pt::read_file(log), kMaxSaid), log));
    }
  }
}

}  // namespace

void run_chunk(const Judging& judging, const ClassPlan& plan, const Chunk& chunk, int jobs,
               const Report& report) {
  std::mutex mutex;
  base::for_each(chunk.size(), jobs, [&](std::size_t k) {
    std::vector<intake::HandedIn> equal;
    for (const std::size_t i : chunk[k]) equal.push_back(plan.everybody[i]);
    grade_equal(judging, equal, [&](std::size_t i, const Graded& graded) {
      const std::lock_guard lock(mutex);
      report(chunk[k][i], graded);
    });
  });
}

std::vector<std::string> engine_command(const EngineRequest& request, const std::string& out,
                                        const std::vector<std::size_t>& numbers) {
  std::vector<std::string> command;
  const auto add = [&](const std::vector<std::string>& words) {
    command.insert(command.end(), words.begin(), words.end());
  };
  if (request.engine == Engine::parallel) {
    add({find_program("parallel"), "--quote", "--joblog", "+" + out + "/joblog"});
    if (request.jobs > 0) add({"--jobs", std::to_string(request.jobs)});
    add(request.options);
    add(request.program);
    add({out, "{}", ":::"});
    for (const std::size_t number : numbers) command.push_back(std::to_string(number));
    return command;
  }
  if (!numbers.empty() && numbers.back() > kMaxSlurmChunk) {
    throw pt::Error(
        fmt::format("Slurm takes {} chunks at most, and the plan has {}; write a larger "
                    "--chunk-size",
                    kMaxSlurmChunk, numbers.back()));
  }
  std::string line = "exec";
  for (const std::string& word : request.program) line += " " + quoted(word);
  line += " " + quoted(out) + " \"$SLURM_ARRAY_TASK_ID\"";
  const std::string limit = request.jobs > 0 ? "%" + std::to_string(request.jobs) : "";
  fs::create_directories(out + "/slurm");
  add({find_program("sbatch"), "--wait", "--requeue", "--job-name=grade-class",
       "--array=" + list_of(numbers) + limit, "--open-mode=append",
       "--output=" + out + "/slurm/%a.log"});
  add(request.options);
  add({"--wrap=" + line});
  return command;
}

void run_plan(const Judging& judging, const ClassPlan& plan, const EngineRequest& request,
              const Report& report) {
  if (request.engine != Engine::local) return run_elsewhere(judging, plan, request, report);
  Chunk all;
  for (const Chunk& chunk : plan.chunks) all.insert(all.end(), chunk.begin(), chunk.end());
  run_chunk(judging, plan, all, request.jobs, report);
}

}  // namespace grader::classes
