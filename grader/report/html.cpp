#include "grader/report/html.h"

#include "grader/report/filled.h"
#include "grader/report/html_picture.h"
#include "grader/report/html_promises.h"
#include "grader/report/page/sources.h"
#include "grader/results/order.h"
#include "grader/results/presentable.h"
#include "grader/results/summary.h"

#include <algorithm>

#include <fmt/format.h>

namespace grader::report {

namespace {

using kainjow::mustache::data;

struct Page {
  const Link& link;
  Places& places;
};

// Where to read about the task.
data help_data(const results::TaskResult& task, const Link& link) {
  data help{data::type::list};
  const auto add = [&](const char* kind, const std::string& text, const std::string& file,
                       const std::string& anchor) {
    const std::string address = link ? link(file) : "";
    data out;
    out.set("kind", kind);
    out.set("file", address.empty() ? file : text);
    out.set("address", address.empty() ? data(false) : data(address + anchor));
    help.push_back(out);
  };
  // As the pages of a handbook on GitHub and in editors name its sections.
  std::string section = task.number + "-" + task.slug;
  std::erase(section, '.');
  add("Handbook", task.number + " " + task.slug, "student/" + task.part + "/README.md",
      "#" + address_of(section));
  add("Contract", task.slug + ".h", "pt/tasks/" + task.slug + ".h", "");
  return help;
}

// "4 more pictures, 3 wrong"
std::string more_pictures(std::size_t number, std::ptrdiff_t wrong) {
  return fmt::format("{} more picture{}", number, number == 1 ? "" : "s") +
         (wrong > 0 ? fmt::format(", {} wrong", wrong) : "");
}

// The first wrong one is in sight, and the others are folded. If all are right, none is.
void set_pictures(data& out, const results::TaskResult& task, Places& places) {
  std::vector<const results::PictureResult*> order;
  for (const results::PictureResult& each : task.pictures) order.push_back(&each);
  const auto is_wrong = [](const results::PictureResult* each) {
    return results::is_fault(each->state);
  };
  const auto wrong = std::ranges::count_if(order, is_wrong);
  const auto first = std::ranges::find_if(order, is_wrong);
  if (wrong > 0) std::rotate(order.begin(), first, std::next(first));
  const std::string told = has_leading_promise(task) ? results::how_to_look(task) : "";
  data pictures{data::type::list};
  for (std::size_t i = 0; i < order.size(); ++i) {
    data picture = picture_data(*order[i], task.slug, places);
    if (told == results::how_to_look(task.slug, *order[i])) set_text(picture, "see_it", "");
    const bool begins = i == 1 && wrong > 0;
    set_text(picture, "picture_fold", begins ? more_pictures(order.size() - 1, wrong - 1) : "");
    picture.set("picture_open", i == 0 && wrong > 0);
    pictures.push_back(picture);
  }
  out.set("pictures", pictures);
  out.set("has_marks", std::ranges::any_of(order, [](const results::PictureResult* each) {
            return each->state != results::State::pass;
          }));
  out.set("has_pictures_folded", wrong > 0 && order.size() > 1);
}

// The members that the line of a task shows, folded or above.
data line_data(const results::TaskResult& task) {
  data out;
  out.set("number", task.number);
  out.set("slug", task.slug);
  out.set("tone", tone(task.state));
  out.set("symbol", results::symbol(task.state));
  out.set("words", results::words(task.state));
  out.set("task_points", std::to_string(task.points));
  out.set("task_max", std::to_string(task.max_points));
  out.set("above", false);
  return out;
}

data task_data(const results::TaskResult& task, const Page& page, bool open) {
  data out = line_data(task);
  out.set("open", open);
  set_text(out, "called", task.called);
  out.set("task_has_bonus", task.bonus_points > 0);
  out.set("task_bonus", std::to_string(task.bonus_points));
  set_text(out, "missed_bonus", results::missed_bonus_text(task));
  set_text(out, "reason", task.reason);
  set_text(out, "mistake", task.mistake.sentence);
  set_text(out, "hint", task.mistake.hint);
  out.set("mistake_kind", results::mistake_kind(task));
  set_text(out, "spared", results::spared_text(task));
  set_texts(out, "blocked_by", "other", task.blocked_by);
  set_texts(out, "blamed", "other", task.blamed);
  out.set("has_help", task.state != results::State::pass);
  out.set("help", help_data(task, page.link));
  set_text(out, "compiler_output", task.compiler_output);
  set_text(out, "warnings", results::is_fault(task.state) ? task.warnings : "");
  set_text(out, "printed", task.printed);
  set_promises(out, task);
  set_pictures(out, task, page.places);
  return out;
}

data section_data(const std::string& title, const std::string& name, const data& tasks) {
  data out;
  out.set("section", title);
  out.set("part_name", name);
  out.set("part_max", false);
  out.set("tasks", tasks);
  return out;
}

// The task to work on, and then the parts.
data sections_data(const results::Results& results, const Page& page) {
  const std::vector<results::TaskResult>& tasks = results.tasks;
  data sections{data::type::list};
  const results::TaskResult* first = results::next_task(results);
  if (first != nullptr) {
    data list{data::type::list};
    list.push_back(task_data(*first, page, true));
    sections.push_back(section_data(
        results::is_fault(first->state) ? "Work on this first" : "Write this next", "", list));
  }
  for (std::size_t i = 0; i < tasks.size();) {
    std::vector<results::TaskResult> of_part;
    data list{data::type::list};
    const std::string& part = tasks[i].part;
    for (; i < tasks.size() && tasks[i].part == part; ++i) {
      of_part.push_back(tasks[i]);
      data task = &tasks[i] == first ? line_data(tasks[i]) : task_data(tasks[i], page, false);
      task.set("above", &tasks[i] == first);
      list.push_back(task);
    }
    const results::Totals sum = results::totals(of_part);
    data out = section_data("Part " + results::part_number(part), results::part_name(part), list);
    out.set("part_points", std::to_string(sum.points));
    out.set("part_max", std::to_string(sum.max_points));
    sections.push_back(out);
  }
  return sections;
}

data page_data(const results::Results& results, const Page& page) {
  const results::Totals all = results::totals(results.tasks);
  data out;
  out.set("style", std::string(page_css));
  out.set("script", std::string(page_js));
  out.set("verdict", results::verdict(results));
  out.set("passed", results::passed(results));
  out.set("points", std::to_string(all.points));
  out.set("max_points", std::to_string(all.max_points));
  out.set("has_bonus", all.bonus_points > 0);
  out.set("bonus_points", std::to_string(all.bonus_points));
  const int percent = all.max_points > 0 ? 100 * all.points / all.max_points : 0;
  out.set("percent", std::to_string(std::clamp(percent, 0, 100)));
  out.set("stopped", results.complete ? data(false) : data(results::kStopped));
  out.set("submission", results.submission);
  set_text(out, "dialect", results.dialect);
  out.set("isolation", results.isolation);
  out.set("seed", std::to_string(results.seed));
  out.set("times", results::times(results));
  set_texts(out, "versions", "version", results.versions);
  set_text(out, "command", results.command);
  out.set("sections", sections_data(results, page));
  return out;
}

}  // namespace

std::string to_html(const results::Results& results, PageSize size, const Link& link) {
  Places places(size);
  return filled(page_html, page_data(results::presentable(results), {link, places}));
}

}  // namespace grader::report
