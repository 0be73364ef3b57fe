#include "grader/service/process/cause_of_end.h"

#include "grader/service/process/spawn.h"

#include <cstring>
#include <sstream>

#include <fmt/format.h>
#include <sys/wait.h>

namespace grader::process {

namespace {

// A check of the standard library, by a part of its condition, and its meaning in words.
struct LibraryCheck {
  const char* condition;
  const char* words;
};
constexpr LibraryCheck kLibraryChecks[]{
    {"size()'", "an index is not below the size of its std::vector, std::array or std::span"},
    {"_M_is_engaged", "the value of an empty std::optional was read"},
    {"empty()'", "the first or last element of something empty was read or removed"},
};

// The message before abort(), of assert() or of an uncaught exception; empty if `words` has none.
// "PROGRAM: FILE:LINE: FUNCTION: Assertion `x > 0' failed.", with '...' from the standard library.
std::string reason_of_abort(const std::string& words) {
  std::istringstream lines(words);
  std::string reason;
  for (std::string line; std::getline(lines, line);) {
    const std::size_t assertion = line.find("Assertion ");
    if (assertion != line.npos) {
      reason = line.substr(assertion);
      for (const LibraryCheck& check : kLibraryChecks) {
        if (reason.starts_with("Assertion '") && reason.find(check.condition) != reason.npos) {
          return fmt::format("{} (--from student --sanitize names the line)", check.words);
        }
      }
      const std::size_t file = line.find(".cpp:");
      if (file < assertion) {
        const std::size_t number = file + 5;
        reason += fmt::format(" (line {})", line.substr(number, line.find(':', number) - number));
      }
    }
    if (line.rfind("terminate called", 0) == 0) reason = line;
    const std::size_t what = line.find("what():");
    if (what != line.npos && !reason.empty()) reason += "; " + line.substr(what);
  }
  return reason;
}

constexpr const char* kKilled = "the system killed it: perhaps no memory was left";

std::string words(int signal, const std::string& last_words) {
  switch (signal) {
    case kStackOverflow:
      return "endless recursion: the stack overflowed, as a function called itself again and again";
    case SIGILL:
    case SIGTRAP:
      return "a function that has to return a value ended without a return";
    case SIGFPE:
      return "a whole number was divided by zero";
    case SIGSEGV:
    case SIGBUS:
      return "it read or wrote memory that is not its own: an index out of range, or a pointer to "
             "nothing";
    case SIGABRT: {
      const std::string reason = reason_of_abort(last_words);
      return reason.empty() ? "it called abort()" : reason;
    }
    case SIGXCPU:
      return "it used up its processor time";
    case SIGSYS:
      return "it made a system call that no task needs (files, network, processes)";
    case SIGKILL:
      return kKilled;
    default:
      return fmt::format("it was ended by the signal \"{}\"", strsignal(signal));
  }
}

}  // namespace

std::string cause_of_end(int status, const std::string& last_words) {
  if (!WIFSIGNALED(status)) {
    return "the process ended by itself, with " + describe_status(status);
  }
  return words(WTERMSIG(status), last_words);
}

bool was_killed(const std::string& cause) { return cause.find(kKilled) != std::string::npos; }

}  // namespace grader::process
