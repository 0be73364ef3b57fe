#include "grader/report/terminal.h"

#include "grader/base/wrap.h"
#include "grader/results/order.h"
#include "grader/results/readable.h"
#include "grader/results/summary.h"
#include "grader/tasks.h"

#include <algorithm>
#include <cstdlib>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

namespace grader::report {

namespace {

std::string paint(const std::string& text, const char* code, const TerminalStyle& style) {
  return style.color ? fmt::format("\x1b[{}m{}\x1b[0m", code, text) : text;
}

const char* color_of(results::State state) {
  switch (state) {
    case results::State::pass:
      return "32";
    case results::State::fail:
    case results::State::crash:
    case results::State::timeout:
    case results::State::rejected:
      return "31";
    case results::State::blocked:
    case results::State::too_noisy:
      return "33";
    case results::State::not_attempted:
    case results::State::not_judged:
      return "2";
  }
  return "0";
}

// A picture with a fault has a row of its own, with this label.
bool has_row(const results::PictureResult& picture) { return results::is_fault(picture.state); }
std::string label_of(const results::PictureResult& picture) { return "  " + picture.recipe; }

// The width of the longest label, with those of all tasks of the course.
std::size_t label_width(const results::Results& results) {
  std::size_t width = 18;
  for (const results::TaskResult& task : results.tasks) {
    for (const results::PictureResult& picture : task.pictures) {
      if (has_row(picture)) width = std::max(width, label_of(picture).size());
    }
  }
  return width;
}

// A label, a state and points, in columns.
std::string columns(const std::string& label, std::size_t width, results::State state, int points,
                    int max_points, const TerminalStyle& style) {
  return fmt::format("{:<{}} {} {:>6}", label, width,
                     paint(fmt::format("{:<14}", results::words(state)), color_of(state), style),
                     fmt::format("{}/{}", points, max_points));
}

std::string row(const results::TaskResult& task, std::size_t width, const TerminalStyle& style) {
  std::string line =
      fmt::format("  {}  {}", task.number,
                  columns(task.slug, width, task.state, task.points, task.max_points, style));
  if (task.bonus_points > 0) line += fmt::format("  + {} bonus", task.bonus_points);
  if (task.state == results::State::blocked)
    line += fmt::format("  by {}", fmt::join(task.blocked_by, ", "));
  const std::string missed = results::missed_bonus_text(task);
  return missed.empty() ? line + "\n" : fmt::format("{}\n         {}\n", line, missed);
}

// The pictures of a task that are not right, as rows below its own.
std::string picture_rows(const results::TaskResult& task, std::size_t width,
                         const TerminalStyle& style) {
  std::string text;
  for (const results::PictureResult& picture : task.pictures) {
    if (!has_row(picture)) continue;
    text += fmt::format("       {}  picture\n", columns(label_of(picture), width, picture.state,
                                                        picture.points, picture.max_points, style));
  }
  return text;
}

// "  got       1.5"; further lines stand below the value.
std::string labelled(const std::string& label, const std::vector<std::string>& lines) {
  std::string text;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    text += fmt::format("  {:<10}{}\n", i == 0 ? label : "", lines[i]);
  }
  return text;
}

std::string failure_text(const results::Readable& readable, const TerminalStyle& style) {
  const results::Failure& failure = readable.failure;
  std::vector<std::string> input = failure.input;
  if (readable.lines_left_out > 0) input.push_back(results::more_lines(readable.lines_left_out));
  std::string text;
  if (failure.integrated) text += fmt::format("  With all {} tasks yours:\n", tasks().size());
  if (!style.input_last) text += labelled("input", input);
  if (!failure.what.empty()) text += labelled("compared", {failure.what});
  text += labelled("got", {failure.got}) + labelled("expected", {failure.expected});
  if (!failure.off_by.empty()) text += labelled("off by", {failure.off_by});
  if (style.input_last) text += labelled("input", input);
  return text + "\n";
}

// "hit_box, your BBox::intersect,", or the slug alone.
std::string heading_of(const results::TaskResult& task) {
  return task.called.empty() ? task.slug : fmt::format("{}, your {},", task.slug, task.called);
}

std::string promise_text(const results::TaskResult& task, const results::PromiseResult& promise,
                         const TerminalStyle& style) {
  std::string text = "\n";
  for (const std::string& line : base::wrap(heading_of(task) + " " + promise.words, style.width)) {
    text += paint(line, "1", style) + "\n";
  }
  text += "\n";
  if (promise.failures.empty()) return text + "  It failed, and there is no input to show.\n";
  for (const results::Failure& failure : promise.failures) {
    text += failure_text(results::readable(failure), style);
    if (!style.all) break;
  }
  text += labelled("replay", {promise.failures[0].replay}) +
          labelled("hint", {"./run hint " + task.slug});
  const std::string look = results::how_to_look(task);
  return look.empty() ? text : text + labelled("see it", {look});
}

std::string picture_text(const results::TaskResult& task, const results::PictureResult& picture,
                         const TerminalStyle& style) {
  std::string text = "\n";
  const std::string head =
      fmt::format("{}: picture {}{}{} ({}, {} of {} points)", task.slug, picture.recipe,
                  picture.title.empty() ? "" : ", ", picture.title, results::words(picture.state),
                  picture.points, picture.max_points);
  for (const std::string& line : base::wrap(head, style.width)) {
    text += paint(line, "1", style) + "\n";
  }
  text += "\n";
  if (picture.integrated) text += fmt::format("  With all {} tasks yours:\n", tasks().size());
  for (const std::string& line : base::wrap(picture.text, style.width - 2))
    text += "  " + line + "\n";
  text += "\n";
  const std::string page = results::how_to_see(task, picture);
  if (!page.starts_with(picture.replay)) text += labelled("replay", {picture.replay});
  return text + labelled("see it", {results::how_to_look(task.slug, picture)}) +
         labelled("page", {page});
}

std::string reason_text(const results::TaskResult& task, const TerminalStyle& style) {
  std::string text = "\n" + paint(task.slug + ": " + task.reason, "1", style) + "\n";
  if (!task.compiler_output.empty()) text += "\n" + task.compiler_output;
  return text;
}

// The warnings stand beside the first failure, because they often name the line.
std::string warnings_text(const results::TaskResult& task) {
  constexpr int kShown = 3;
  std::string text = "\n  The compiler warns\n";
  int warnings = 0;
  for (const std::string& line : base::lines_of(task.warnings)) {
    if (line.find(" warning: ") != line.npos) ++warnings;
    if (warnings <= kShown) text += "    " + line + "\n";
  }
  if (warnings > kShown) text += fmt::format("    and {} more warnings\n", warnings - kShown);
  return text;
}

// The mistake that explains all failures of the task, before the first of them.
std::string mistake_lines(const results::TaskResult& task, const TerminalStyle& style) {
  if (task.mistake.empty()) return "";
  std::string text = "\n";
  for (const std::string& line :
       base::wrap(task.slug + ": " + results::mistake_text(task), style.width)) {
    text += paint(line, "1", style) + "\n";
  }
  const std::string spared = results::spared_text(task);
  return spared.empty() ? text : text + "  " + spared + "\n";
}

std::string printed_text(const results::TaskResult& task) {
  std::string text = "\n  printed\n";
  for (const std::string& line : base::lines_of(task.printed.substr(0, 400)))
    text += "    " + line + "\n";
  return text;
}

}  // namespace

std::string table(const results::Results& results, const TerminalStyle& style) {
  const std::size_t width = label_width(results);
  std::string text, part;
  for (const results::TaskResult& task : results.tasks) {
    if (task.part != part) {
      text += fmt::format("\nPart {}  {}\n", results::part_number(task.part),
                          results::part_name(task.part));
    }
    part = task.part;
    text += row(task, width, style) + picture_rows(task, width, style);
  }
  return text + "\n" + results::verdict(results) + "\n";
}

// The first lines of a report on work in the skeleton of a course.
std::string dialect_text(const results::Results& results, const TerminalStyle& style) {
  std::string text;
  if (results.dialect.empty()) return text;
  const std::string words =
      fmt::format("Judged by {}; docs/course.md says what that changes.", results.dialect);
  for (const std::string& line : base::wrap(words, style.width)) text += line + "\n";
  return text;
}

std::vector<FailureText> failure_texts(const results::TaskResult& task,
                                       const TerminalStyle& style) {
  std::vector<FailureText> texts;
  const bool quiet = !results::is_fault(task.state);
  // A reason such as "only with your hit_box" belongs to the first failure below it.
  std::string reason = quiet ? "" : mistake_lines(task, style);
  if (!task.reason.empty() && !quiet) reason += reason_text(task, style);
  const bool keeps_the_others = !results::missed_bonus(task).empty();
  for (const results::PromiseResult* each : results::by_importance(task)) {
    const results::PromiseResult& promise = *each;
    const bool failed = !promise.bonus || style.all || keeps_the_others;
    const bool shown = !promise.failures.empty() || (task.reason.empty() && !promise.bonus);
    if (failed && shown && !(quiet && !promise.bonus)) {
      texts.push_back({task.slug, promise.name, reason + promise_text(task, promise, style)});
      reason.clear();
    }
  }
  for (const results::PictureResult& picture : task.pictures) {
    if (!results::is_fault(picture.state)) continue;
    texts.push_back({task.slug, "", reason + picture_text(task, picture, style)});
    reason.clear();
  }
  if (!reason.empty()) texts.push_back({task.slug, "", reason});
  if (!texts.empty() && !task.warnings.empty()) texts.front().text += warnings_text(task);
  if (!texts.empty() && !task.printed.empty()) texts.front().text += printed_text(task);
  return texts;
}

bool terminal_has_color() {
  const char* no_color = std::getenv("NO_COLOR");
  const char* terminal = std::getenv("TERM");
  return isatty(STDOUT_FILENO) == 1 && (no_color == nullptr || *no_color == '\0') &&
         terminal != nullptr && std::string(terminal) != "dumb";
}

std::string to_text(const results::Results& results, const TerminalStyle& style) {
  std::vector<std::string> failures;
  for (const results::TaskResult* task : results::by_importance(results)) {
    for (FailureText& each : failure_texts(*task, style)) failures.push_back(std::move(each.text));
  }
  std::string text = dialect_text(results, style) + table(results, style);
  const std::size_t shown = style.all ? failures.size() : std::min<std::size_t>(1, failures.size());
  for (std::size_t i = 0; i < shown; ++i) text += failures[i];
  if (failures.size() > shown) {
    text += fmt::format("\n{} more; --all shows {}.\n", failures.size() - shown,
                        failures.size() - shown == 1 ? "it" : "them");
  }
  if (!results.complete) text += fmt::format("\n{}\n", results::kStopped);
  const std::string version = results::version(results);
  return text + fmt::format("\n{}, seed {}, {}. Isolation {}.{}\n", results.submission,
                            results.seed, results::times(results), results.isolation,
                            version.empty() ? "" : " " + version + ".");
}

}  // namespace grader::report
