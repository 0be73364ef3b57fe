// watch in its own terminal. Programs replace grade and hint: they print their arguments and give
// the answers that the test has prepared.
#include "grader/results/json.h"
#include "pt/file.h"
#include "tests/fixtures/grader_fixture.h"
#include "tests/grader/watch/pseudo_terminal.h"

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

namespace grader::watch {
namespace {

using testing::HasSubstr;
using testing::Not;

// Answers with the file <task>.json or all.json, after running the file `before` if there is one.
constexpr const char* kGrade = R"(#!/bin/sh
here=$(dirname "$0")
task=all
case $1 in --*) ;; *) task=$1 ;; esac
while [ $# -gt 1 ]; do [ "$1" = --json ] && json=$2; shift; done
echo "graded $task" >> "$here/log"
[ -e "$here/before" ] && . "$here/before"
cp "$here/$task.json" "$json"
echo "finished $task" >> "$here/log"
)";
constexpr const char* kHint = "#!/bin/sh\necho \"hint asked for: $1 $2\"\n";

results::TaskResult failing(const std::string& part, const std::string& number,
                            const std::string& slug, const std::vector<std::string>& promises) {
  results::TaskResult task;
  task.part = part;
  task.number = number;
  task.slug = slug;
  task.state = promises.empty() ? results::State::pass : results::State::fail;
  task.max_points = 5;
  for (const std::string& name : promises) {
    results::PromiseResult promise{name, "words of " + name, false, false, 1, 0, {}};
    results::Failure& failure = promise.failures.emplace_back();
    failure.got = "got for " + name;
    task.promises.push_back(promise);
  }
  return task;
}

class WatchTest : public testing::Test {
 protected:
  WatchTest() {
    for (const auto& [name, text] : {std::pair("grade", kGrade), std::pair("hint", kHint)}) {
      pt::write_file(here_ + "/" + name, text);
      std::filesystem::permissions(here_ + "/" + name, std::filesystem::perms::owner_all);
    }
    for (const char* part : {"/student/1_rays", "/student/2_bvh"}) {
      std::filesystem::create_directories(here_ + part);
    }
    save("1_rays/hit_triangle", "// first");
    results::TaskResult unwritten = failing("2_bvh", "2.1", "build_bvh", {});
    unwritten.state = results::State::not_attempted;
    answer("all", {triangle({"one", "two"}), unwritten});
    answer("hit_triangle", {triangle({"three"})});
    answer("hit_sphere", {failing("1_rays", "1.4", "hit_sphere", {})});
  }

  static results::TaskResult triangle(const std::vector<std::string>& promises) {
    return failing("1_rays", "1.3", "hit_triangle", promises);
  }

  // Saves like an editor.
  void save(const std::string& file, const std::string& text) const {
    pt::write_file(here_ + "/student/" + file + ".cpp", text);
  }

  void answer(const std::string& task, std::vector<results::TaskResult> tasks) const {
    results::Results results;
    results.complete = true;
    results.tasks = std::move(tasks);
    results::write_json(results, here_ + "/" + task + ".json");
  }

  // Puts a script in the place of ./run.
  void replace_run(const std::string& script) const {
    std::string config = pt::read_file(folder_.config());
    config.replace(config.find(FIRSTLIGHT_ROOT), std::string(FIRSTLIGHT_ROOT).size(), here_);
    pt::write_file(folder_.config(), config);
    pt::write_file(here_ + "/run", "#!/bin/sh\n" + script);
    std::filesystem::permissions(here_ + "/run", std::filesystem::perms::owner_all);
  }

  std::vector<std::string> command() const {
    return {WATCH_PROGRAM, "--submission", here_ + "/student", "--config", folder_.config()};
  }

  // Waits for the results of the first run over everything.
  static void begin(PseudoTerminal& terminal) {
    terminal.expect("got for one");
    terminal.expect("q quit");
  }

  static void expect_exit(PseudoTerminal& terminal, int code) {
    const int status = terminal.wait();
    EXPECT_TRUE(WIFEXITED(status));
    EXPECT_EQ(WEXITSTATUS(status), code);
    EXPECT_TRUE(terminal.mode() == terminal.mode_before());
  }

  const GraderFolder folder_;
  const std::string here_ = folder_.path();
};

TEST_F(WatchTest, judges_everything_once_and_then_what_is_saved) {
  PseudoTerminal terminal(command());
  EXPECT_THAT(terminal.expect("got for one"), HasSubstr("hit_triangle"));
  EXPECT_FALSE(terminal.mode() == terminal.mode_before());
  save("1_rays/hit_triangle", "// second");
  EXPECT_THAT(terminal.expect("got for three"), Not(HasSubstr("got for two")));
  save("1_rays/hit_sphere", "// new");
  const std::string screen = terminal.expect("hit_sphere passes");
  EXPECT_THAT(screen, HasSubstr("[#..] 1 of 3 tasks pass"));
  terminal.type("q");
  expect_exit(terminal, 0);
  EXPECT_THAT(pt::read_file(here_ + "/log"),
              testing::StartsWith(
                  "graded all\nfinished all\ngraded hit_triangle\nfinished hit_triangle\n"));
}

TEST_F(WatchTest, refreshes_the_tasks_that_ask_the_one_that_was_saved) {
  PseudoTerminal terminal(command());
  begin(terminal);
  results::TaskResult corrected = failing("2_bvh", "2.1", "build_bvh", {});
  answer("all", {triangle({"three"}), corrected});
  save("1_rays/hit_triangle", "// second");
  terminal.expect("got for three");
  terminal.expect("[#..] 1 of 3 tasks pass");
  terminal.expect("got for three");
  terminal.type("q");
  expect_exit(terminal, 0);
  EXPECT_THAT(pt::read_file(here_ + "/log"),
              testing::EndsWith("finished hit_triangle\ngraded all\nfinished all\n"));
}

TEST_F(WatchTest, answers_keys) {
  PseudoTerminal terminal(command());
  begin(terminal);
  terminal.type("h");
  terminal.expect("hint asked for: hit_triangle one");
  terminal.type("n");
  EXPECT_THAT(terminal.expect("got for two"), Not(HasSubstr("got for one")));
  terminal.type("xh");
  terminal.expect("hint asked for: hit_triangle two");
  terminal.type("n");
  terminal.expect("1.4 hit_sphere is not judged yet");
  terminal.type("n");
  terminal.expect("2.1 build_bvh is not written yet");
  terminal.type("n");
  terminal.expect("got for one");
  terminal.type("l");
  terminal.expect("1.3  hit_triangle       fail");
  terminal.expect("2.1  build_bvh          not attempted");
  terminal.type("q");
  expect_exit(terminal, 0);
}

TEST_F(WatchTest, keeps_the_failure_that_is_looked_at_until_the_task_passes) {
  PseudoTerminal terminal(command());
  begin(terminal);
  answer("hit_sphere", {failing("1_rays", "1.4", "hit_sphere", {"four"})});
  answer("all", {triangle({"one"}), failing("1_rays", "1.4", "hit_sphere", {"four"})});
  save("1_rays/hit_sphere", "// wrong");
  terminal.expect("got for four");
  terminal.expect("checking all tasks");
  EXPECT_THAT(terminal.expect("q quit"), Not(HasSubstr("got for one")));
  const std::string after = terminal.expect("q quit");  // everything is judged
  EXPECT_THAT(after, HasSubstr("got for four"));
  EXPECT_THAT(after, Not(HasSubstr("got for one")));
  terminal.type("h");
  terminal.expect("hint asked for: hit_sphere four");
  terminal.type("f");
  terminal.expect("got for four");
  answer("hit_sphere", {failing("1_rays", "1.4", "hit_sphere", {})});
  save("1_rays/hit_sphere", "// right now");
  EXPECT_THAT(terminal.expect("hit_sphere passes"), HasSubstr("[#..] 1 of 3 tasks pass"));
  terminal.type("q");
  expect_exit(terminal, 0);
}

TEST_F(WatchTest, draws_the_page_of_pictures_and_opens_it) {
  pt::write_file(here_ + "/xdg-open", "#!/bin/sh\necho \"opened $1\" >> \"$(dirname $0)/log\"\n");
  std::filesystem::permissions(here_ + "/xdg-open", std::filesystem::perms::owner_all);
  const char* const found = std::getenv("PATH");
  const std::string path = found != nullptr ? found : "/usr/bin:/bin";
  setenv("PATH", (here_ + ":" + path).c_str(), 1);
  for (const char* display : {"", ":0"}) {
    unsetenv("WAYLAND_DISPLAY");
    unsetenv("DISPLAY");
    if (*display != '\0') setenv("DISPLAY", display, 1);
    PseudoTerminal terminal(command());
    begin(terminal);
    terminal.type("p");
    terminal.expect("rendering the pictures of hit_triangle");
    const std::string work = here_ + "/work", page = work + "/watch.html";
    terminal.expect("Your pictures next to the right ones: " + page);
    terminal.type("f");
    terminal.expect("got for one");
    terminal.type("q");
    expect_exit(terminal, 0);
    const std::string opened = "opened " + page;
    EXPECT_EQ(pt::read_file(here_ + "/log").find(opened) != std::string::npos, *display != '\0');
  }
  setenv("PATH", path.c_str(), 1);
}

TEST_F(WatchTest, opens_the_view_where_a_picture_fails) {
  replace_run("echo $$ > \"$(dirname \"$0\")/view\"; echo \"shows $*\"; exec sleep 1000\n");
  PseudoTerminal terminal(command());
  begin(terminal);
  results::TaskResult task = triangle({"three"});
  for (const char* recipe : {"rays_clip", "rays_facets", "rays_smooth"}) {
    results::PictureResult& picture = task.pictures.emplace_back();
    picture.recipe = recipe;
    picture.height = 72;
    picture.state = results::State::fail;
  }
  task.pictures[0].state = results::State::pass;
  task.pictures[2].cells = {{40, 48, 8, 8, "Y", -0.4, 2}};
  answer("hit_triangle", {task});
  terminal.type("v");
  terminal.expect("rendering the pictures of hit_triangle");
  terminal.expect("shows view rays_smooth --pixel 44 19 --from reference");
  terminal.type("f");
  terminal.expect("got for one");
  const pid_t view = std::stoi(pt::read_file(here_ + "/view"));
  EXPECT_EQ(kill(view, 0), 0);
  terminal.type("q");
  expect_exit(terminal, 0);
  EXPECT_NE(kill(view, 0), 0) << "the view goes on";
}

TEST_F(WatchTest, judges_examples_that_are_saved) {
  replace_run("echo 'building grade_examples (check) ...' >&2\necho \"ran $*\"\n");
  PseudoTerminal terminal(command());
  begin(terminal);
  for (const char* text : {"// first", "// second, which is longer"}) {
    save("1_rays/hit_sphere.examples", text);
    terminal.expect("judging the examples of hit_sphere");
    const std::string screen =
        terminal.expect("ran examples hit_sphere --submission " + here_ + "/student");
    EXPECT_THAT(screen, Not(HasSubstr("building")));
    terminal.type("f");
    terminal.expect("got for one");
  }
  save("1_rays/hit_triangle", "// second");
  terminal.expect("got for three");
  terminal.type("q");
  expect_exit(terminal, 0);
  const std::string log = pt::read_file(here_ + "/log");
  EXPECT_THAT(log, testing::StartsWith("graded all\nfinished all\ngraded hit_triangle\n"));
  EXPECT_THAT(log, Not(HasSubstr("examples")));
}

// The screen already shows the next task, which has no pictures yet.
TEST_F(WatchTest, draws_the_pictures_of_the_task_that_was_saved_last) {
  PseudoTerminal terminal(command());
  begin(terminal);
  answer("hit_sphere", {failing("1_rays", "1.4", "hit_sphere", {})});
  save("1_rays/hit_sphere", "// right");
  terminal.expect("hit_sphere passes");
  terminal.expect("q quit");
  terminal.type("p");
  terminal.expect("rendering the pictures of hit_sphere");
  terminal.expect("Your pictures next to the right ones: ");
  terminal.type("q");
  expect_exit(terminal, 0);
  EXPECT_THAT(pt::read_file(here_ + "/log"),
              testing::EndsWith("graded hit_sphere\nfinished hit_sphere\n"));
}

TEST_F(WatchTest, draws_all_pictures_when_all_tasks_pass) {
  answer("all", {triangle({}), failing("1_rays", "1.4", "hit_sphere", {}),
                 failing("2_bvh", "2.1", "build_bvh", {})});
  PseudoTerminal terminal(command());
  terminal.expect("Nothing is left to do");
  terminal.expect("q quit");
  terminal.type("p");
  terminal.expect("rendering the pictures of all tasks");
  terminal.expect("Your pictures next to the right ones: ");
  terminal.type("q");
  expect_exit(terminal, 0);
}

// The screen has 24 lines if a terminal does not report its size.
TEST_F(WatchTest, shows_no_more_than_there_is_room_for) {
  results::TaskResult task = triangle({"one"});
  for (int i = 0; i < 40; ++i) {
    task.promises[0].failures[0].input.push_back("value " + std::to_string(i));
  }
  answer("all", {task});
  PseudoTerminal terminal(command());
  terminal.expect("value 0");
  const std::string rest = terminal.expect("q quit");
  EXPECT_THAT(rest, HasSubstr("more lines"));
  EXPECT_LE(std::count(rest.begin(), rest.end(), '\n'), 23);
  terminal.type("q");
  expect_exit(terminal, 0);
}

TEST_F(WatchTest, begins_with_what_fails_not_with_what_is_not_written) {
  results::TaskResult unwritten = triangle({});
  unwritten.state = results::State::not_attempted;
  answer("all", {unwritten, failing("1_rays", "1.4", "hit_sphere", {"four"})});
  PseudoTerminal terminal(command());
  EXPECT_THAT(terminal.expect("got for four"), Not(HasSubstr("not written yet")));
  terminal.type("q");
  expect_exit(terminal, 0);
}

TEST_F(WatchTest, shows_the_failure_of_two_files_that_are_saved_at_once) {
  PseudoTerminal terminal(command());
  begin(terminal);
  pt::write_file(here_ + "/before", "until [ -e \"$here/go\" ]; do sleep 0.02; done\n");
  save("1_rays/hit_triangle", "// wrong");
  terminal.expect("checking hit_triangle");
  save("1_rays/hit_sphere", "// right");
  pt::write_file(here_ + "/go", "");
  terminal.expect("got for three");
  terminal.expect("hit_sphere passes");
  EXPECT_THAT(terminal.expect("got for three"), Not(HasSubstr("not written")));
  terminal.type("h");
  terminal.expect("hint asked for: hit_triangle three");
  terminal.type("q");
  expect_exit(terminal, 0);
}

// hit_sphere does not call hit_triangle, but watch believes the results.
TEST_F(WatchTest, shows_what_blocks_a_task_in_its_place) {
  results::TaskResult blocked = failing("1_rays", "1.4", "hit_sphere", {});
  blocked.state = results::State::blocked;
  blocked.blocked_by = {"hit_triangle"};
  blocked.reason = "right by itself";
  answer("all", {blocked, triangle({"one"})});
  answer("hit_sphere", {blocked});
  PseudoTerminal terminal(command());
  begin(terminal);
  save("1_rays/hit_sphere", "// right");
  terminal.expect("hit_sphere is blocked: correct hit_triangle first.");
  terminal.expect("got for one");
  terminal.type("n");
  EXPECT_THAT(terminal.expect("not judged yet"), Not(HasSubstr("right by itself")));
  terminal.type("q");
  expect_exit(terminal, 0);
}

TEST_F(WatchTest, shows_what_came_back_above_a_long_input) {
  results::TaskResult task = triangle({"one"});
  for (int i = 0; i < 40; ++i) {
    task.promises[0].failures[0].input.push_back("value " + std::to_string(i));
  }
  answer("all", {task});
  PseudoTerminal terminal(command());
  EXPECT_THAT(terminal.expect("value 0"), HasSubstr("got for one"));
  terminal.type("q");
  expect_exit(terminal, 0);
}

TEST_F(WatchTest, leaves_the_terminal_as_it_was_however_it_ends) {
  struct Case {
    const char* keys;
    int signal, code;
  };
  for (const Case& each : {Case{"\x03", 0, 0}, Case{"\x1c", 0, 128 + SIGQUIT},
                           Case{"", SIGTERM, 128 + SIGTERM}, Case{"", SIGHUP, 128 + SIGHUP}}) {
    PseudoTerminal terminal(command());
    begin(terminal);
    EXPECT_FALSE(terminal.mode() == terminal.mode_before());
    terminal.type(each.keys);
    if (each.signal != 0) terminal.send_signal(each.signal);
    expect_exit(terminal, each.code);
  }
}

TEST_F(WatchTest, leaves_the_terminal_as_it_was_when_it_crashes) {
  for (const int signal : {SIGSEGV, SIGABRT}) {
    PseudoTerminal terminal(command());
    begin(terminal);
    EXPECT_FALSE(terminal.mode() == terminal.mode_before());
    terminal.send_signal(signal);
    const int status = terminal.wait();
    EXPECT_TRUE(WIFSIGNALED(status));
    EXPECT_EQ(WTERMSIG(status), signal);
    EXPECT_TRUE(terminal.mode() == terminal.mode_before());
  }
}

TEST_F(WatchTest, can_be_stopped_and_go_on) {
  PseudoTerminal terminal(command());
  begin(terminal);
  terminal.type("\x1a");
  EXPECT_TRUE(WIFSTOPPED(terminal.wait()));
  EXPECT_TRUE(terminal.mode() == terminal.mode_before());
  terminal.send_signal(SIGCONT);
  terminal.expect("q quit");
  EXPECT_FALSE(terminal.mode() == terminal.mode_before());
  terminal.type("q");
  expect_exit(terminal, 0);
}

TEST_F(WatchTest, survives_a_grade_that_crashes) {
  PseudoTerminal terminal(command());
  begin(terminal);
  pt::write_file(here_ + "/before", "echo last words; kill -SEGV $$\n");
  save("1_rays/hit_triangle", "// worse");
  EXPECT_THAT(terminal.expect("last words"), HasSubstr("grade gave no verdict: signal 11"));
  std::filesystem::remove(here_ + "/before");
  save("1_rays/hit_triangle", "// better");
  terminal.expect("got for three");
  terminal.type("q");
  expect_exit(terminal, 0);
}

TEST_F(WatchTest, starts_anew_when_the_file_is_saved_again) {
  PseudoTerminal terminal(command());
  begin(terminal);
  pt::write_file(
      here_ + "/before",
      "[ -e \"$here/first\" ] || { echo $$ > \"$here/new\"; mv \"$here/new\" \"$here/first\"; }\n"
      "until [ -e \"$here/go\" ]; do sleep 0.02; done\n");
  save("1_rays/hit_triangle", "// half of it");
  terminal.expect("checking hit_triangle");
  while (!std::filesystem::exists(here_ + "/first")) usleep(1000);
  const pid_t first = std::stoi(pt::read_file(here_ + "/first"));
  EXPECT_EQ(kill(first, 0), 0);
  save("1_rays/hit_triangle", "// all of it, at last");
  terminal.expect("checking hit_triangle");
  EXPECT_NE(kill(first, 0), 0) << "the first run goes on";
  pt::write_file(here_ + "/go", "");
  terminal.expect("got for three");
  terminal.type("q");
  expect_exit(terminal, 0);
  EXPECT_THAT(pt::read_file(here_ + "/log"),
              HasSubstr("graded hit_triangle\ngraded hit_triangle\nfinished hit_triangle\n"));
}

// Of the tasks of a file, those whose functions were changed; of a header, all that include it.
TEST_F(WatchTest, judges_what_is_saved_in_a_clone) {
  const std::string clone = here_ + "/clone",
                    make = FIRSTLIGHT_ROOT "/tests/fixtures/course/make_clone.py";
  ASSERT_EQ(std::system(("python3 " + make + " 2022 " + clone).c_str()), 0);
  const auto replace = [&](const std::string& file, const std::string& old, const std::string& by) {
    std::string text = pt::read_file(clone + file);
    ASSERT_NE(text.find(old), text.npos) << old;
    pt::write_file(clone + file, text.replace(text.find(old), old.size(), by));
  };
  PseudoTerminal terminal({WATCH_PROGRAM, "--submission", clone, "--config", folder_.config()});
  begin(terminal);
  replace("/src/scene/sphere.cpp", "{", "{ /* mine */");
  terminal.expect("hit_sphere passes");
  replace("/src/scene/triangle.cpp", "return test(r, t, u, v);", "return !test(r, t, u, v);");
  terminal.expect("got for three");
  terminal.type("q");
  expect_exit(terminal, 0);
  EXPECT_THAT(pt::read_file(here_ + "/log"),
              AllOf(HasSubstr("graded all\nfinished all\ngraded hit_sphere\nfinished hit_sphere\n"),
                    HasSubstr("graded hit_triangle\nfinished hit_triangle\n"),
                    Not(HasSubstr("graded build_bvh"))));
}

TEST_F(WatchTest, quits_while_a_task_is_judged) {
  pt::write_file(here_ + "/before", "sleep 1000\n");
  PseudoTerminal terminal(command());
  terminal.expect("checking all tasks");
  terminal.type("q");
  expect_exit(terminal, 0);
}

TEST_F(WatchTest, needs_a_terminal) {
  std::string line;
  for (const std::string& word : command()) line += "'" + word + "' ";
  FILE* pipe = popen((line + "2>&1 </dev/null").c_str(), "r");
  char text[256] = "";
  EXPECT_NE(std::fgets(text, sizeof text, pipe), nullptr);
  EXPECT_EQ(WEXITSTATUS(pclose(pipe)), 2);
  EXPECT_STREQ(text,
               "watch needs a terminal for its keys, and this is not one; use grade instead\n");
}

}  // namespace
}  // namespace grader::watch
