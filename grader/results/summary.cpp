#include "grader/results/summary.h"

#include <algorithm>

#include <fmt/format.h>

namespace grader::results {

std::string words(State state) {
  std::string text = name(state);
  for (char& c : text) c = c == '_' ? ' ' : c;
  return text;
}

const char* symbol(State state) {
  switch (state) {
    case State::pass:
      return "\u2713";  // check mark
    case State::fail:
      return "\u2717";  // ballot cross
    case State::crash:
      return "!";
    case State::timeout:
      return "\u2026";  // ellipsis
    case State::not_attempted:
      return "\u25cb";  // empty circle
    case State::blocked:
      return "\u2016";  // two bars
    case State::too_noisy:
      return "\u2248";  // about equal
    case State::rejected:
      return "\u00d7";  // times
    case State::not_judged:
      return "?";
  }
  return "";
}

bool is_fault(State state) {
  return state != State::pass && state != State::not_attempted && state != State::blocked &&
         state != State::not_judged;
}

Totals totals(const std::vector<TaskResult>& tasks) {
  Totals all;
  for (const TaskResult& task : tasks) {
    all.points += task.points;
    all.max_points += task.max_points;
    all.bonus_points += task.bonus_points;
    all.passed += task.state == State::pass ? 1 : 0;
    all.not_judged += task.state == State::not_judged ? 1 : 0;
  }
  return all;
}

bool is_judged(const TaskResult& task, const PromiseResult& promise) {
  return task.state != State::not_judged || promise.held || !promise.failures.empty();
}

Counts verdicts(const Results& results) {
  Counts counts;
  for (const TaskResult& task : results.tasks) {
    counts.all += task.promises.size() + task.pictures.size();
    for (const PromiseResult& each : task.promises) counts.judged += is_judged(task, each) ? 1 : 0;
    for (const PictureResult& each : task.pictures) {
      counts.judged += each.state != State::not_judged ? 1 : 0;
    }
  }
  return counts;
}

std::string passed(const Results& results) {
  const Totals all = totals(results.tasks);
  std::string text = fmt::format("{} of {} tasks pass", all.passed, results.tasks.size());
  if (all.not_judged > 0) text += fmt::format(", {} not judged yet", all.not_judged);
  return text;
}

std::string verdict(const Results& results) {
  const Totals all = totals(results.tasks);
  std::string text = passed(results) + fmt::format(". {} of {} points", all.points, all.max_points);
  if (all.bonus_points > 0) text += fmt::format(" and {} bonus", all.bonus_points);
  return text + ".";
}

std::string version(const Results& results) {
  const bool known = !results.versions.empty() && results.versions[0].starts_with("Firstlight ");
  return known ? results.versions[0] : "";
}

std::string times(const Results& results) {
  std::string text;
  for (const Phase& phase : results.phases) {
    text += fmt::format("{}{} {:.1f} s", text.empty() ? "" : ", ", phase.name, phase.seconds);
  }
  const std::string all = fmt::format("{:.1f} s", results.seconds);
  return text.empty() ? all : all + " (" + text + ")";
}

double seconds(const TaskResult& task) {
  double sum = 0;
  for (const PromiseResult& promise : task.promises) sum += promise.seconds;
  for (const PictureResult& picture : task.pictures) sum += picture.seconds;
  return sum;
}

std::string part_number(const std::string& part) { return part.substr(0, part.find('_')); }

std::string part_name(const std::string& part) {
  std::string name = part.substr(part.find('_') + 1);
  for (char& c : name) c = c == '_' ? ' ' : c;
  return name;
}

std::string mistake_kind(const TaskResult& task) {
  if (task.mistake.empty()) return "";
  const bool several = task.mistake.name.find(", ") != std::string::npos;
  return several ? "This is one of these known mistakes" : "This is a known mistake";
}

std::string mistake_text(const TaskResult& task) {
  if (task.mistake.empty()) return "";
  return fmt::format("{}: {}{}", mistake_kind(task), task.mistake.sentence,
                     task.mistake.hint.empty() ? "" : " Hint: " + task.mistake.hint);
}

std::string spared_text(const TaskResult& task) {
  if (task.spared == 0) return "";
  int broken = 0, taken = -task.spared;
  for (const PromiseResult& promise : task.promises) {
    if (promise.bonus || promise.held) continue;
    ++broken;
    taken += promise.points;
  }
  return fmt::format("{}: {} promises fail, {} {} taken.",
                     task.mistake.empty() ? "One reason counts once" : "One cause", broken, taken,
                     taken == 1 ? "point is" : "points are");
}

std::vector<const PromiseResult*> missed_bonus(const TaskResult& task) {
  std::vector<const PromiseResult*> missed;
  for (const PromiseResult& promise : task.promises) {
    if (promise.held) continue;
    if (!promise.bonus) return {};
    if (!promise.failures.empty()) missed.push_back(&promise);
  }
  return missed;
}

std::string missed_bonus_text(const TaskResult& task) {
  std::string text;
  for (const PromiseResult* promise : missed_bonus(task)) {
    text += text.empty() ? "without the bonus: " : ", ";
    text += promise->words.substr(0, promise->words.find(" (bonus)"));
  }
  return text;
}

std::string how_to_see(const TaskResult& task, const PictureResult& picture) {
  const bool grades = picture.replay.starts_with("./run grade");
  return (grades ? picture.replay : "./run grade " + task.slug) + " --html report.html";
}

std::string how_to_look(const std::string& slug, const PictureResult& picture) {
  std::string command = "./run view " + picture.recipe;
  if (!picture.cells.empty()) {
    const FailingCell& cell = picture.cells[0];
    // The view counts from the bottom left, as tasks do.
    command += fmt::format(" --pixel {} {}", cell.x + cell.width / 2,
                           picture.height - 1 - (cell.y + cell.height / 2));
  }
  command += picture.integrated ? " --from student"
                                : fmt::format(" --from reference --from {}=student", slug);
  const std::size_t folder = picture.replay.find(" --submission ");
  return folder == std::string::npos ? command : command + picture.replay.substr(folder);
}

std::string how_to_look(const TaskResult& task) {
  const auto found = std::ranges::find_if(task.pictures, [](const PictureResult& picture) {
    return is_fault(picture.state) && !picture.cells.empty();
  });
  return found == task.pictures.end() ? "" : how_to_look(task.slug, *found);
}

}  // namespace grader::results
