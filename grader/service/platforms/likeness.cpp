#include "grader/service/platforms/likeness.h"

#include "grader/base/sha256.h"
#include "grader/report/filled.h"
#include "grader/report/page/sources.h"
#include "grader/results/order.h"
#include "grader/results/presentable.h"
#include "grader/service/platforms/page/sources.h"
#include "grader/service/platforms/shape.h"

#include <algorithm>
#include <set>
#include <tuple>

#include <fmt/format.h>

namespace grader::platforms {

namespace {

using kainjow::mustache::data;

constexpr std::size_t kMaxGroups = 100, kMaxNames = 12;

// All wrong answers of a task, or an empty text. Everybody in a class has the same inputs.
std::string faults_of(const results::TaskResult& task) {
  std::string all;
  for (const results::PromiseResult& promise : task.promises) {
    for (const results::Failure& failure : promise.failures) {
      if (failure.integrated) continue;  // another file may be the reason
      all += promise.name + '\n' + failure.what + '\n' + failure.got + '\n';
      for (const std::string& line : failure.input) all += line + '\n';
    }
  }
  return all;
}

// The mistake that is named, or the first promise that is broken.
std::string what_is_wrong(const results::TaskResult& task) {
  if (!task.mistake.empty()) return task.mistake.sentence;
  const auto broken = results::by_importance(task);
  return broken.empty() ? "" : broken[0]->words.empty() ? broken[0]->name : broken[0]->words;
}

data group_data(const Likeness::Group& group) {
  data out, names{data::type::list};
  for (std::size_t i = 0; i < std::min(group.names.size(), kMaxNames); ++i) {
    data name;
    name.set("name", results::one_line(group.names[i]));
    name.set("address", report::address_of(group.names[i] + ".html"));
    name.set("comma", i > 0);
    names.push_back(name);
  }
  const std::size_t more = group.names.size() - std::min(group.names.size(), kMaxNames);
  out.set("names", names);
  out.set("more", more > 0 ? data(std::to_string(more)) : data(false));
  out.set("slug", group.slug);
  out.set("what", group.mistaken == 0 ? group.what
                                      : fmt::format("{} This was named for {} of {}.", group.what,
                                                    group.mistaken, group.of));
  out.set("size", std::to_string(group.size));
  out.set("share", fmt::format("{} of {} ({:.0f} %)", group.names.size(), group.of,
                               100.0 * static_cast<double>(group.names.size()) /
                                   static_cast<double>(group.of)));
  return out;
}

data section(const char* anchor, const char* heading, const char* size_head,
             std::vector<Likeness::Group> groups) {
  data out, rows{data::type::list};
  const std::size_t left_out = groups.size() - std::min(groups.size(), kMaxGroups);
  groups.resize(groups.size() - left_out);
  for (const Likeness::Group& group : groups) rows.push_back(group_data(group));
  out.set("anchor", anchor);
  out.set("heading", heading);
  out.set("size_head", size_head);
  out.set("none", groups.empty());
  out.set("rows", rows);
  out.set("left_out", left_out > 0 ? data(std::to_string(left_out)) : data(false));
  return out;
}

}  // namespace

void Likeness::add(const std::string& name, const std::map<std::string, std::string>& files,
                   const results::Results& exact) {
  ++submissions_;
  const results::Results results = results::presentable(exact);
  for (const results::TaskResult& task : results.tasks) {
    const auto file = files.find(task.slug);
    const bool is_attempted =
        task.state != results::State::not_attempted && task.state != results::State::not_judged;
    if (!is_attempted || file == files.end()) continue;
    const Shape shape = shape_of(file->second);
    const std::string faults = faults_of(task);
    const auto wrong = std::ranges::count_if(
        task.promises, [](const auto& promise) { return !promise.failures.empty(); });
    files_[task.slug].push_back({name, base::sha256(file->second), base::sha256(shape.text),
                                 faults.empty() ? "" : base::sha256(faults), what_is_wrong(task),
                                 task.mistake.name, shape.tokens, static_cast<std::size_t>(wrong)});
  }
}

std::vector<Likeness::Group> Likeness::groups(std::string File::*same, std::string File::*different,
                                              std::size_t File::*size) const {
  std::vector<Group> found;
  for (const auto& [slug, files] : files_) {
    std::map<std::string, std::vector<const File*>> alike;
    for (const File& file : files) {
      if (!(file.*same).empty()) alike[file.*same].push_back(&file);
    }
    for (auto& [key, members] : alike) {
      std::ranges::sort(members, {},
                        &File::name);  // else what is shown depends on who is judged first
      const File& first = *members[0];
      std::set<std::string> kinds;
      Group group{slug, first.what, first.*size, {}, files.size(), 0};
      for (const File* file : members) {
        group.names.push_back(file->name);
        if (different != nullptr) kinds.insert(file->*different);
      }
      if (!first.mistake.empty())
        group.mistaken =
            static_cast<std::size_t>(std::ranges::count(files, first.mistake, &File::mistake));
      if (group.names.size() > 1 && (different == nullptr || kinds.size() > 1))
        found.push_back(group);
    }
  }
  // The rarest first; of equally rare ones that which is less likely by chance.
  std::ranges::stable_sort(found, [](const Group& a, const Group& b) {
    const std::size_t left = a.names.size() * b.of, right = b.names.size() * a.of;
    return std::tuple(left, b.size, a.slug, a.names) < std::tuple(right, a.size, b.slug, b.names);
  });
  return found;
}

std::vector<Likeness::Group> Likeness::equal_files() const {
  return groups(&File::text, nullptr, &File::tokens);
}

std::vector<Likeness::Group> Likeness::equal_shapes() const {
  return groups(&File::shape, &File::text, &File::tokens);
}

std::vector<Likeness::Group> Likeness::equal_faults() const {
  return groups(&File::faults, &File::shape, &File::wrong);
}

std::string Likeness::to_html() const {
  data out, sections{data::type::list};
  sections.push_back(section("equal", "Equal files", "Tokens", equal_files()));
  sections.push_back(
      section("shapes", "Equal but for names, comments and layout", "Tokens", equal_shapes()));
  sections.push_back(section("faults", "Other files that are wrong in the same way",
                             "Promises broken", equal_faults()));
  out.set("style", std::string(report::page_css));
  out.set("submissions", std::to_string(submissions_));
  out.set("sections", sections);
  return report::filled(likeness_html, out);
}

}  // namespace grader::platforms
