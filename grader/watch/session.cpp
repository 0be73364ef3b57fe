#include "grader/watch/session.h"

#include "grader/base/wrap.h"
#include "grader/results/json.h"
#include "grader/service/process/run_command.h"
#include "grader/watch/fit.h"
#include "pt/error.h"
#include "pt/file.h"

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <utility>

#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

namespace grader::watch {

namespace {

constexpr int kPause = 100;  // milliseconds between looks at the files
constexpr const char* kClearScreen = "\x1b[H\x1b[2J";
constexpr const char* kClearLine = "\r\x1b[K";
constexpr const char* kKeys = "h hint  n next  f failure  p pictures  v view  l list  q quit";
constexpr const char* kPage = "*";  // waits like a task
constexpr const char* kView = "+";  // as well

bool is_pictures(const std::string& judged) { return judged == kPage || judged == kView; }

bool is_examples(const std::string& judged) { return judged.ends_with(kExamples); }

std::string task_of_examples(const std::string& judged) {
  return judged.substr(0, judged.rfind(kExamples));
}

// The lines that ./run printed, without the lines that only say that it is at work (scripts/build.sh).
std::string without_progress(const std::string& output) {
  std::string text;
  for (const std::string& line : base::lines_of(output)) {
    const auto begins = [&](const char* words) { return line.starts_with(words); };
    if (begins("building ") || begins("configuring (") || begins("waiting for ")) continue;
    text += line + '\n';
  }
  return text;
}

std::string time_of_day() {
  const std::time_t now = std::time(nullptr);
  char text[16] = "";
  std::strftime(text, sizeof text, "%H:%M:%S", std::localtime(&now));
  return text;
}

// Asks a browser to show the file. Returns whether that worked.
bool open_in_browser(const std::string& path) {
  if (std::getenv("DISPLAY") == nullptr && std::getenv("WAYLAND_DISPLAY") == nullptr) return false;
  process::Child child{{"/bin/sh", "-c", "exec xdg-open \"$1\"", "sh", path},
                       process::own_environment(),
                       {},
                       "",
                       {}};
  return process::run_command(std::move(child), std::chrono::seconds(5)).ok();
}

}  // namespace

WatchSession::WatchSession(const build::Config& config, WatchOptions options)
    : config_(config),
      options_(std::move(options)),
      results_path_(fmt::format("{}/watch.{}.json", config.work, getpid())),
      files_(options_.submission, config),
      verdicts_(config.tasks, options_.submission, options_.style),
      page_path_(config.work + "/watch.html") {
  std::filesystem::create_directories(config.work);
}

int WatchSession::run(RawTerminal& terminal) {
  show(fmt::format("Watching {}: save a file to have it checked.\n", options_.submission));
  while (!quit_) {
    take_saves();
    take_verdict();
    take_view();
    start_next();
    wait(terminal);
    take_signals(terminal);
    take_keys();
  }
  running_.reset();
  view_.reset();
  std::filesystem::remove(results_path_);
  std::fputs(kClearLine, stdout);
  std::fflush(stdout);
  return *quit_;
}

void WatchSession::wait(const RawTerminal& terminal) const {
  pollfd sources[] = {{terminal.signal_descriptor(), POLLIN, 0},
                      {STDIN_FILENO, POLLIN, 0},
                      {running_ ? running_->descriptor() : -1, POLLIN, 0},
                      {view_ ? view_->descriptor() : -1, POLLIN, 0}};
  poll(sources, 4, kPause);
}

void WatchSession::take_signals(RawTerminal& terminal) {
  while (const auto signal = terminal.next_signal()) {
    if (*signal == SIGTSTP) {
      std::fputs(kClearLine, stdout);
      std::fflush(stdout);
      terminal.stop_program();
      draw();
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

// A task that is saved while it is judged is judged again. A run over all tasks is stopped first.
void WatchSession::take_saves() {
  for (const std::string& slug : files_.saved()) {
    if (running_ && judging_.empty()) waiting_.push_back("");
    if (running_ && (judging_.empty() || is_pictures(judging_) || judging_ == slug))
      running_.reset();
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
  // Tasks that call the saved task may have another verdict now; all other verdicts are known.
  const bool is_task = !judging_.empty() && !is_pictures(judging_) && !is_examples(judging_);
  if (is_task && waiting_.empty()) waiting_.push_back("");
}

void WatchSession::start_next() {
  if (running_ || waiting_.empty()) return;
  judging_ = waiting_.front();
  waiting_.pop_front();
  std::vector<std::string> command{options_.programs + "/grade"};
  if (is_examples(judging_)) {
    running_.emplace(std::vector<std::string>{config_.root + "/run", "examples",
                                              task_of_examples(judging_), "--submission",
                                              options_.submission});
    return draw();
  }
  if (is_pictures(judging_)) {
    if (!page_task_.empty()) command.push_back(page_task_);
    command.insert(command.end(), {"--html", page_path_});
  } else {
    if (!judging_.empty()) command.push_back(judging_);
    command.insert(command.end(), {"--no-pictures"});
  }
  command.insert(command.end(), {"--submission", options_.submission, "--json", results_path_,
                                 "--config", options_.config, "--quiet"});
  std::filesystem::remove(results_path_);
  running_.emplace(command);
  draw();
}

void WatchSession::press(char key) {
  switch (key) {
    case 'h':
      return give_hint();
    case 'n':
      return look_at(verdicts_.next());
    case 'f':
      return show(failure_);
    case 'p':
      if (judged_) waiting_.push_back(kPage);
      return;
    case 'v':
      if (judged_) waiting_.push_back(kView);
      return;
    case 'l':
      return show(verdicts_.list());
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
  child.command.insert(child.command.end(), {"--root", config_.root, "--work", config_.work});
  const process::CommandResult hint =
      process::run_command(std::move(child), std::chrono::seconds(5));
  show(hint.output);
}

void WatchSession::show_page() {
  const std::string where = "Your pictures next to the right ones: " + page_path_;
  show(where + (open_in_browser(page_path_) ? " (opened in the browser)" : "") + "\n");
}

// Shows the paths of a pixel at which a picture fails. The view goes on after saves, and ends with watch.
void WatchSession::start_view() {
  const std::string& slug = page_task_.empty() ? task_ : page_task_;
  const std::string command = verdicts_.how_to_look(slug);
  if (command.empty()) {
    return show(fmt::format("{} has no picture; ./run view SCENE shows any scene\n", slug));
  }
  const std::string words = command.substr(command.find(' '));  // without ./run
  view_says_.clear();
  view_.reset();
  view_.emplace(
      std::vector<std::string>{"/bin/sh", "-c", "exec \"$0\"" + words, config_.root + "/run"});
  show(command + "\n");
}

// Its progress, its address, or why it ended.
void WatchSession::take_view() {
  if (!view_) return;
  const bool has_ended = view_->poll().has_value();
  if (view_->output() != view_says_) {
    view_says_ = view_->output();
    const std::size_t address = view_says_.find("http://");
    show(address == std::string::npos ? view_says_ : view_says_.substr(address));
  }
  if (has_ended) view_.reset();
}

// Takes the results of `grade`. The task on the screen stays, unless it was saved or its verdict
// has changed.
void WatchSession::take_results() {
  const results::Results results =
      results::results_from_json(pt::read_file(results_path_), results_path_);
  if (!results.complete) throw pt::Error("the results are not complete");
  const std::string before = verdicts_.state(task_);
  verdicts_.update(results);
  if (judging_ == kPage) return show_page();
  if (judging_ == kView) return start_view();
  const bool first = !judged_;
  judged_ = true;
  if (!judging_.empty()) {
    look_at(verdicts_.show(judging_));
    page_task_ = judging_;
    return;
  }
  if (first) return look_at(verdicts_.show_first());
  if (verdicts_.state(task_) != before) return look_at(verdicts_.show(task_));
  draw();
}

void WatchSession::show_verdict(const std::string& output, int status, double seconds) {
  const std::string what = judging_.empty() ? "all tasks" : judging_;
  if (!is_pictures(judging_)) head_ = fmt::format("{}  {}, {:.1f} s", time_of_day(), what, seconds);
  if (is_examples(judging_)) return show(without_progress(output));
  try {
    take_results();
  } catch (const std::exception& error) {
    show(fmt::format("grade gave no verdict: {} ({})\n{}", process::describe_status(status),
                     error.what(), output));
  }
}

void WatchSession::look_at(const std::string& failure) {
  task_ = verdicts_.slug();
  page_task_ = verdicts_.all_pass() ? "" : task_;
  failure_ = failure;
  show(failure);
}

void WatchSession::show(const std::string& text) {
  text_ = text;
  draw();
}

void WatchSession::draw() const {
  const std::string page_tasks = page_task_.empty() ? "all tasks" : page_task_;
  const std::string what = judging_.empty()        ? "checking all tasks"
                           : is_pictures(judging_) ? "rendering the pictures of " + page_tasks
                           : is_examples(judging_)
                               ? "judging the examples of " + task_of_examples(judging_)
                               : "checking " + judging_;
  ScreenSize room = screen_size();
  room.rows -= 5;
  const std::string now = running_ ? what + " ...  " : "";
  fmt::print("{}{}\n{}\n\n{}\n{}{}", kClearScreen, verdicts_.bar(), head_, fit(text_, room), now,
             kKeys);
  std::fflush(stdout);
}

}  // namespace grader::watch
