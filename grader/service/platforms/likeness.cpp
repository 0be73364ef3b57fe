#include "grader/service/platforms/likeness.h"

#include "grader/base/printable.h"
#include "grader/base/sha256.h"
#include "grader/report/filled.h"
#include "grader/report/page/sources.h"
#include "grader/results/order.h"
#include "grader/results/presentable.h"
#include "grader/results/summary.h"
#include "grader/service/platforms/page/sources.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <tuple>

#include <fmt/format.h>

namespace grader::platforms {

namespace {

using kainjow::mustache::data;

constexpr std::size_t kMaxGroups = 100, kMaxNames = 12;
constexpr std::size_t kMaxPairs = 10;     // of a task
constexpr std::size_t kMinPrints = 4;     // a shorter file can be written in few ways
constexpr std::size_t kMinForCommon = 4;  // files: what most of fewer share may be copied
constexpr double kMinShare = 0.5;

std::set<std::uint64_t> hashes_of(const std::string& source) {
  std::set<std::uint64_t> hashes;
  for (const Print& print : sketch_of(source)) hashes.insert(print.hash);
  return hashes;
}

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

// The lines of a source; those that hold a print of `shared` are marked.
data lines_of(const std::string& source, const std::set<std::uint64_t>& shared) {
  constexpr std::size_t kMaxShown = std::size_t{16} << 10;  // bytes
  const std::string code = base::printable(source, kMaxShown, true);
  std::set<std::size_t> marked;
  for (const Print& print : sketch_of(source)) {
    for (std::size_t line = print.first_line; line <= print.last_line; ++line) {
      if (shared.contains(print.hash)) marked.insert(line);
    }
  }
  data lines{data::type::list};
  std::size_t number = 0;
  for (std::size_t at = 0; at < code.size();) {
    const std::size_t end = std::min(code.find('\n', at), code.size());
    data line;
    line.set("text", code.substr(at, end - at));
    line.set("is_shared", marked.contains(++number));
    lines.push_back(line);
    at = end + 1;
  }
  return lines;
}

data pair_data(const Likeness::Pair& pair, bool with_known, const Likeness::Source& source) {
  data out;
  const std::string a = source(pair.slug, pair.a), b = source(pair.slug, pair.b);
  const std::set<std::uint64_t> of_a = hashes_of(a), of_b = hashes_of(b);
  std::set<std::uint64_t> shared;
  std::ranges::set_intersection(of_a, of_b, std::inserter(shared, shared.end()));
  out.set("share", fmt::format("{:.0f} %", 100 * pair.share));
  out.set("slug", pair.slug);
  out.set("prints", std::to_string(pair.prints));
  out.set("a", results::one_line(pair.a));
  out.set("b", results::one_line(pair.b));
  out.set("address_a", report::address_of(pair.a + ".html"));
  out.set("address_b", with_known ? data(false) : data(report::address_of(pair.b + ".html")));
  out.set("left", lines_of(a, shared));
  out.set("right", lines_of(b, shared));
  return out;
}

data pairs_section(const char* anchor, const char* heading, const char* note,
                   const std::vector<Likeness::Pair>& pairs, bool with_known,
                   const Likeness::Source& source) {
  data out, rows{data::type::list};
  for (const Likeness::Pair& pair : pairs) rows.push_back(pair_data(pair, with_known, source));
  out.set("anchor", anchor);
  out.set("heading", heading);
  out.set("note", note);
  out.set("none", pairs.empty());
  out.set("rows", rows);
  return out;
}

void sort_pairs(std::vector<Likeness::Pair>& pairs) {
  std::ranges::sort(pairs, [](const Likeness::Pair& x, const Likeness::Pair& y) {
    return std::tuple(-x.share, -static_cast<double>(x.prints), x.slug, x.a, x.b) <
           std::tuple(-y.share, -static_cast<double>(y.prints), y.slug, y.a, y.b);
  });
}

// Adds those of one task that are most alike.
void add_first(std::vector<Likeness::Pair>& all, std::vector<Likeness::Pair> of_task) {
  sort_pairs(of_task);
  of_task.resize(std::min(of_task.size(), kMaxPairs));
  all.insert(all.end(), of_task.begin(), of_task.end());
}

}  // namespace

Likeness::Likeness(const std::map<std::string, Known>& known) {
  for (const auto& [slug, files] : known) {
    Task& task = tasks_[slug];
    task.stub = hashes_of(files.stub);
    for (const auto& [path, text] : files.others) task.others[path] = hashes_of(text);
  }
}

void Likeness::add(const std::string& name, const std::map<std::string, std::string>& files,
                   const results::Results& exact) {
  ++submissions_;
  const results::Results results = results::presentable(exact);
  for (const results::TaskResult& task : results.tasks) {
    const auto file = files.find(task.slug);
    const bool is_attempted =
        task.state != results::State::not_attempted && task.state != results::State::not_judged;
    if (!is_attempted || file == files.end()) continue;
    // Right work that lacks a bonus is not wrong.
    const std::string faults = results::is_fault(task.state) ? faults_of(task) : "";
    const auto wrong = std::ranges::count_if(
        task.promises, [](const auto& promise) { return !promise.failures.empty(); });
    tasks_[task.slug].files.push_back(
        {name, base::sha256(file->second), faults.empty() ? "" : base::sha256(faults),
         what_is_wrong(task), task.mistake.name,
         static_cast<std::size_t>(std::ranges::count(file->second, '\n')),
         static_cast<std::size_t>(wrong), hashes_of(file->second)});
  }
}

std::vector<Likeness::Group> Likeness::groups(std::string File::*same, std::string File::*different,
                                              std::size_t File::*size) const {
  std::vector<Group> found;
  for (const auto& [slug, task] : tasks_) {
    std::map<std::string, std::vector<const File*>> alike;
    for (const File& file : task.files) {
      if (!(file.*same).empty()) alike[file.*same].push_back(&file);
    }
    for (auto& [key, members] : alike) {
      std::ranges::sort(members, {},
                        &File::name);  // else what is shown depends on who is judged first
      const File& first = *members[0];
      std::set<std::string> kinds;
      Group group{slug, first.what, first.*size, {}, task.files.size(), 0};
      for (const File* file : members) {
        group.names.push_back(file->name);
        if (different != nullptr) kinds.insert(file->*different);
      }
      if (!first.mistake.empty())
        group.mistaken =
            static_cast<std::size_t>(std::ranges::count(task.files, first.mistake, &File::mistake));
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
  return groups(&File::text, nullptr, &File::lines);
}

std::vector<Likeness::Group> Likeness::equal_faults() const {
  return groups(&File::faults, &File::text, &File::wrong);
}

// One of equal files, by the first name.
std::vector<const Likeness::File*> Likeness::different_files(const Task& task) {
  std::map<std::string, const File*> first;
  for (const File& file : task.files) {
    const File*& known = first[file.text];
    if (known == nullptr || file.name < known->name) known = &file;
  }
  std::vector<const File*> all;
  for (const auto& [text, file] : first) all.push_back(file);
  std::ranges::sort(all, {}, &File::name);
  return all;
}

// The prints of the stub, and those that more than half of the files have.
Likeness::Prints Likeness::left_out(const Task& task) {
  Prints out = task.stub;
  const std::vector<const File*> files = different_files(task);
  std::map<std::uint64_t, std::size_t> count;
  for (const File* file : files) {
    for (const std::uint64_t print : file->prints) ++count[print];
  }
  for (const auto& [print, times] : count) {
    if (files.size() >= kMinForCommon && 2 * times > files.size()) out.insert(print);
  }
  return out;
}

std::vector<Likeness::Pair> Likeness::pairs() const {
  std::vector<Pair> all;
  for (const auto& [slug, task] : tasks_) {
    const std::vector<const File*> files = different_files(task);
    const Prints out = left_out(task);
    std::map<std::uint64_t, std::vector<std::size_t>> owners;
    std::vector<std::size_t> sizes(files.size()), common(files.size());
    for (std::size_t i = 0; i < files.size(); ++i) {
      for (const std::uint64_t print : files[i]->prints) {
        if (out.contains(print)) continue;
        owners[print].push_back(i);
        ++sizes[i];
      }
    }
    std::vector<Pair> of_task;
    for (std::size_t i = 0; i < files.size(); ++i) {
      std::ranges::fill(common, 0);
      for (const std::uint64_t print : files[i]->prints) {
        const auto others = owners.find(print);
        if (others == owners.end()) continue;
        for (const std::size_t j : others->second) ++common[j];
      }
      for (std::size_t j = i + 1; j < files.size(); ++j) {
        const std::size_t least = std::min(sizes[i], sizes[j]);
        const double share =
            static_cast<double>(common[j]) / static_cast<double>(std::max<std::size_t>(least, 1));
        if (least >= kMinPrints && share >= kMinShare)
          of_task.push_back({slug, files[i]->name, files[j]->name, share, common[j]});
      }
    }
    add_first(all, std::move(of_task));
  }
  sort_pairs(all);
  return all;
}

std::vector<Likeness::Pair> Likeness::known_pairs() const {
  std::vector<Pair> all;
  for (const auto& [slug, task] : tasks_) {
    std::vector<Pair> of_task;
    for (const File* file : different_files(task)) {
      Pair best{slug, file->name, "", 0, 0};
      for (const auto& [path, prints] : task.others) {
        Prints common, own, other;
        std::ranges::set_difference(file->prints, task.stub, std::inserter(own, own.end()));
        std::ranges::set_difference(prints, task.stub, std::inserter(other, other.end()));
        std::ranges::set_intersection(own, other, std::inserter(common, common.end()));
        const std::size_t least = std::min(own.size(), other.size());
        if (least < kMinPrints) continue;
        const double share = static_cast<double>(common.size()) / static_cast<double>(least);
        if (share > best.share) best = {slug, file->name, path, share, common.size()};
      }
      if (best.share >= kMinShare) of_task.push_back(best);
    }
    add_first(all, std::move(of_task));
  }
  sort_pairs(all);
  return all;
}

std::string Likeness::to_html(const Source& source) const {
  data out, sections{data::type::list}, pair_sections{data::type::list};
  pair_sections.push_back(pairs_section("pairs", "Pairs of the class",
                                        "The share is that of the shorter file, without what was "
                                        "handed out and what most files have.",
                                        pairs(), false, source));
  pair_sections.push_back(pairs_section(
      "known", "As in the repository",
      "Solutions that are public: the reference, the fast forms and other right ones. Some of them "
      "are what anybody would write.",
      known_pairs(), true, source));
  sections.push_back(section("equal", "Equal files", "Lines", equal_files()));
  sections.push_back(section("faults", "Other files that are wrong in the same way",
                             "Promises broken", equal_faults()));
  out.set("style", std::string(report::page_css));
  out.set("submissions", std::to_string(submissions_));
  out.set("sections", sections);
  out.set("pair_sections", pair_sections);
  return report::filled(likeness_html, out);
}

}  // namespace grader::platforms
