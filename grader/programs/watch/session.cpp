#include "grader/programs/watch/session.h"

#include "grader/base/files.h"
#include "grader/process/run_command.h"
#include "grader/results/read_json.h"
#include "pt/error.h"

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <utility>

#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

namespace grader::programs {

namespace {

constexpr int kPause = 100;  // milliseconds between looks at the files
constexpr const char* kClearLine = "\r\x1b[K";
constexpr const char* kKeys = "h hint   n next   l list   q quit";

std::string time_of_day() {
  const std::time_t now = std::time(nullptr);
  char text[16] = "";
  std::strftime(text, sizeof text, "%H:%M:%S", std::localtime(&now));
  return text;
}

}  // namespace

WatchSession::WatchSession(const judge::Config& config, WatchOptions options)
    : config_(config),
      options_(std::move(options)),
      results_path_(fmt::format("{}/watch.{}.json", config.work, getpid())),
      files_(options_.submission, config.tasks),
      verdicts_(config.tasks, options_.submission, options_.style) {
  std::filesystem::create_directories(config.work);
}

int WatchSession::run(RawTerminal& terminal) {
  print(fmt::format("Watching {}: save a file to have it checked.\n", options_.submission));
  while (!quit_) {
    take_saves();
    take_verdict();
    start_next();
    wait(terminal);
    take_signals(terminal);
    take_keys();
  }
  running_.reset();
  std::filesystem::remove(results_path_);
  std::fputs(kClearLine, stdout);
  std::fflush(stdout);
  return *quit_;
}

void WatchSession::wait(const RawTerminal& terminal) const {
  pollfd sources[] = {{terminal.signal_descriptor(), POLLIN, 0},
                      {STDIN_FILENO, POLLIN, 0},
                      {running_ ? running_->descriptor() : -1, POLLIN, 0}};
  poll(sources, 3, kPause);
}

void WatchSession::take_signals(RawTerminal& terminal) {
  while (const auto signal = terminal.next_signal()) {
    if (*signal == SIGTSTP) {
      std::fputs(kClearLine, stdout);
      std::fflush(stdout);
      terminal.stop_program();
      show_status();
    } else if (*signal == SIGINT) {
      quit_ = 0;
    } else if (*signal != SIGCHLD) {
      quit_ = 128 + *signal;
    }
  }
}

void WatchSession::take_keys() {
  pollfd keys{STDIN_FILENO, POLLIN, 0};
  while (!quit_ && poll(&keys, 1, 0) > 0) {
    char key = 0;
    if (read(STDIN_FILENO, &key, 1) != 1) {
      quit_ = 128 + SIGHUP;  // the terminal is gone
    } else {
      press(key);
    }
  }
}

// A task that is being judged and was saved again is judged anew; a run over everything makes way.
void WatchSession::take_saves() {
  for (const std::string& slug : files_.saved()) {
    if (running_ && judging_.empty()) waiting_.push_back("");
    if (running_ && (judging_.empty() || judging_ == slug)) running_.reset();
    if (std::count(waiting_.begin(), waiting_.end(), slug) == 0) {
      const auto all = std::find(waiting_.begin(), waiting_.end(), "");
      waiting_.insert(all, slug);
    }
  }
}

void WatchSession::take_verdict() {
  if (!running_) return;
  const auto status = running_->poll();
  if (!status) return;
  const std::string output = running_->output();
  const double seconds = running_->seconds();
  running_.reset();
  show_verdict(output, *status, seconds);
  // Tasks that ask the one that was saved may stand differently now; what did not change is known.
  if (!judging_.empty() && waiting_.empty()) waiting_.push_back("");
}

void WatchSession::start_next() {
  if (running_ || waiting_.empty()) return;
  judging_ = waiting_.front();
  waiting_.pop_front();
  std::vector<std::string> command{options_.programs + "/grade"};
  if (!judging_.empty()) command.push_back(judging_);
  for (const std::string& word :
       {std::string("--submission"), options_.submission, std::string("--json"), results_path_,
        std::string("--config"), options_.config, std::string("--no-pictures")}) {
    command.push_back(word);
  }
  std::filesystem::remove(results_path_);
  running_.emplace(command);
  show_status();
}

void WatchSession::press(char key) {
  switch (key) {
    case 'h':
      return give_hint();
    case 'n':
      return print(verdicts_.next());
    case 'l':
      return print("\n" + verdicts_.list());
    case 'q':
      quit_ = 0;
      return;
    default:
      return;
  }
}

void WatchSession::give_hint() {
  process::Child child{{options_.programs + "/hint", verdicts_.slug()}, {}, {}, "", {}};
  if (!verdicts_.promise().empty()) child.command.push_back(verdicts_.promise());
  child.command.insert(child.command.end(), {"--config", options_.config});
  const process::CommandResult hint =
      process::run_command(std::move(child), std::chrono::seconds(5));
  print("\n" + hint.output);
}

void WatchSession::show_verdict(const std::string& output, int status, double seconds) {
  const std::string what = judging_.empty() ? "all tasks" : judging_;
  const std::string head = fmt::format("\n{}  {}, {:.1f} s\n", time_of_day(), what, seconds);
  try {
    const results::Results results =
        results::results_from_json(base::read_file(results_path_), results_path_);
    if (!results.complete) throw pt::Error("the results are not complete");
    const std::string before = verdicts_.table();
    verdicts_.update(results);
    if (judging_.empty() && judged_ && verdicts_.table() == before) return show_status();
    // All tasks again, after a save came in between: that task is still being looked at.
    const std::string again = judged_ ? "" : verdicts_.show_first();
    const std::string failure = judging_.empty() ? again : verdicts_.show(judging_);
    judged_ = true;
    print(head + verdicts_.table() + failure);
  } catch (const std::exception& error) {
    print(fmt::format("{}grade gave no verdict: {} ({})\n{}", head,
                      process::describe_status(status), error.what(), output));
  }
}

void WatchSession::print(const std::string& text) {
  std::fputs(kClearLine, stdout);
  std::fputs(text.c_str(), stdout);
  std::fputs("\n", stdout);
  show_status();
}

void WatchSession::show_status() const {
  const std::string what = judging_.empty() ? "all tasks" : judging_;
  const std::string now = running_ ? "checking " + what + " ...   " : "";
  fmt::print("{}{}{}", kClearLine, now, kKeys);
  std::fflush(stdout);
}

}  // namespace grader::programs
