#pragma once

#include "grader/report/terminal.h"
#include "grader/service/build/config.h"
#include "grader/watch/files.h"
#include "grader/watch/raw_terminal.h"
#include "grader/watch/running.h"
#include "grader/watch/verdicts.h"

#include <deque>
#include <optional>
#include <string>

namespace grader::watch {

struct WatchOptions {
  std::string submission;
  std::string programs;  // the folder of the programs grade and hint
  std::string config;    // handed on to them
  report::TerminalStyle style;
};

// One sitting of a learner: judges everything once, then each task whose file, or whose
// examples, are saved, and answers keys meanwhile. A task stays on the screen until it passes, or another task is saved.
class WatchSession {
 public:
  WatchSession(const build::Config& config, WatchOptions options);

  // Returns when the learner quits: 0, or 128 and the signal that asked for it.
  int run(RawTerminal& terminal);

 private:
  void wait(const RawTerminal& terminal) const;
  void take_signals(RawTerminal& terminal);
  void take_keys();
  void take_saves();
  void take_verdict();
  void start_next();

  void press(char key);
  void give_hint();
  void show_verdict(const std::string& output, int status, double seconds);
  void take_results();
  void show_page();
  void start_view();
  void take_view();

  // The screen is a line on how far the learner is, one text, and the line of keys.
  void show(const std::string& text);
  void look_at(const std::string& failure);  // for the current task of verdicts_
  void draw() const;

  const build::Config& config_;
  WatchOptions options_;
  std::string results_path_;
  Files files_;
  Verdicts verdicts_;
  std::string page_path_;
  // Slugs to judge; "hit_sphere.examples": its examples; empty: all tasks; kPage: draw the page; kView: the same, for the view.
  std::deque<std::string> waiting_{""};
  std::string judging_;  // what running_ judges
  std::optional<Running> running_;
  std::optional<Running> view_;  // ./run view, until it ends, or another one starts
  std::string view_says_;
  bool judged_ = false;  // whether anything was judged so far
  std::string task_;     // slug on the screen
  // The task whose pictures the key p draws: that of the failure on the screen or, after a save, the saved task,
  // even if the screen shows another one. Empty if all tasks pass: then the pictures of all tasks.
  std::string page_task_;
  std::string failure_;  // the failure of task_ on the screen, or the function to write
  std::string text_;     // on the screen: the failure, or the answer to a key
  std::string head_;     // the time of its verdict
  std::optional<int> quit_;
};

}  // namespace grader::watch
