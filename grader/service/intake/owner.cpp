#include "grader/service/intake/owner.h"

#include "grader/service/intake/entry_path.h"
#include "grader/service/intake/name_forms.h"

#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <set>

namespace grader::intake {

namespace {

// The last form has no words of its own, so it comes last where several fit all names.
constexpr std::array kForms{moodle, d2l, blackboard, autolab, canvas};
constexpr std::size_t kBlackboard = 2, kCanvas = 4;

using Forms = std::vector<Found>;  // one name, as each platform would read it

// Reads uncertain names of Canvas again, now that the numbers of the others' files are known.
void read_again(std::map<std::string, Forms>& all) {
  Numbers certain;
  for (const auto& [name, forms] : all) {
    const Found& label = forms[kCanvas];
    if (!label || !label->certain || label->text) continue;
    certain.least = std::min(certain.least, number(label->order));
    certain.largest = std::max(certain.largest, number(label->order));
    const bool is_number = label->id.find_first_not_of("0123456789") == label->id.npos;
    if (is_number && !label->id.empty())
      certain.largest_id = std::max(certain.largest_id, number(label->id));
  }
  for (auto& [name, forms] : all) {
    Found& label = forms[kCanvas];
    if (label && !label->certain) label = canvas_among(name, certain);
  }
}

// An export of Canvas has one number per file and one name per ID. Other files may have names of
// the same form.
bool is_consistent(const std::map<std::string, Forms>& all) {
  std::set<std::string> numbers;
  std::map<std::string, std::string> learners;
  const auto fits = [&](bool certain) {
    return std::ranges::all_of(all, [&](const auto& each) {
      const Found& label = each.second[kCanvas];
      if (!label || label->certain != certain) return true;
      return (label->text || numbers.insert(label->order).second) &&
             learners.try_emplace(label->id, label->name).first->second == label->name;
    });
  };
  // A learner can only make the reading of a name uncertain.
  return fits(true) && (!learners.empty() || fits(false));
}

// The forms, the one that most names have first.
std::vector<std::size_t> by_number(const std::map<std::string, Forms>& all) {
  std::vector<std::size_t> order;
  const std::size_t forms = all.empty() ? 0 : all.begin()->second.size();
  for (std::size_t i = 0; i < forms; ++i) order.push_back(i);
  std::ranges::stable_sort(order, std::greater{}, [&](std::size_t i) {
    return std::ranges::count_if(all, [&](const auto& each) { return each.second[i].has_value(); });
  });
  return order;
}

// The assignment's name is the beginning that all have in common.
void split_names_of_blackboard(const std::vector<Label*>& labels) {
  std::string common = labels.empty() ? "" : labels[0]->name;
  for (const Label* label : labels) {
    const auto differs = std::ranges::mismatch(common, label->name).in1;
    common.erase(differs, common.end());
  }
  const std::size_t end = common.rfind('_');
  for (Label* label : labels) {
    if (end != common.npos && end + 1 < label->name.size()) label->name.erase(0, end + 1);
  }
}

using Place = std::vector<std::string>;

bool is_ascii(const std::string& text) {
  return std::all_of(text.begin(), text.end(),
                     [](char c) { return static_cast<unsigned char>(c) < 0x80; });
}

// The number of times that files of an owner begin in an archive.
struct Begun {
  int files = 0, folders = 0;
  int rows = 0;  // groups of adjacent entries in the folder

  // An archive may lack entries for folders.
  bool twice() const { return files > 1 || folders > 1 || (folders == 0 && rows > 1); }
};

}  // namespace

Labels::Labels(const std::vector<std::string>& files, const std::vector<std::string>& folders,
               const std::vector<NameForm>& table) {
  std::map<std::string, Forms> all;
  for (const std::vector<std::string>* names : {&files, &folders}) {
    for (const std::string& name : *names) {
      const auto [entry, is_new] = all.try_emplace(name);
      if (!is_new) continue;
      const std::size_t forms = names == &files ? kForms.size() : kCanvas;  // Canvas has no folders
      for (std::size_t i = 0; i < forms; ++i) entry->second.push_back(kForms[i](name));
      entry->second.resize(kForms.size());
      for (const NameForm& form : table) entry->second.push_back(read_by(form, name));
    }
  }
  read_again(all);
  if (!is_consistent(all)) {
    for (auto& [name, forms] : all) forms[kCanvas].reset();
  }
  const std::vector<std::size_t> order = by_number(all);
  std::vector<Label*> of_blackboard;
  for (auto& [name, forms] : all) {
    const auto form = std::ranges::find_if(
        order, [&forms = forms](std::size_t i) { return forms[i].has_value(); });
    if (form == order.end()) continue;
    Label& label = labels_[name] = *forms[*form];
    label.before = name.substr(0, name.size() - std::min(name.size(), label.file.size()));
    if (*form == kBlackboard) of_blackboard.push_back(&label);
  }
  split_names_of_blackboard(of_blackboard);
}

std::optional<Label> Labels::of(const std::string& name) const {
  const auto found = labels_.find(name);
  return found == labels_.end() ? std::nullopt : std::optional(found->second);
}

Owners::Owners(const std::vector<Place>& paths) : depth_(folders_around(paths)) {
  std::vector<std::string> files, folders;
  for (const Place& path : paths) {
    if (path.size() > depth_) (path.size() == depth_ + 1 ? files : folders).push_back(path[depth_]);
  }
  labels_ = Labels(files, folders);
  in_doubt_ = may_be_two(paths);
}

std::string Owners::key(const Place& place) const {
  const std::string& part = place[std::min(depth_, place.size() - 1)];
  const std::optional<Label> label = labels_.of(part);
  return label ? label->key : part;
}

std::vector<Place> Owners::may_be_two(const std::vector<Place>& paths) const {
  std::map<Place, Begun> all;
  Place before;
  for (const Place& path : paths) {
    const std::size_t count = std::min(depth_ + 1, path.size());
    const Place place(path.begin(), path.begin() + static_cast<std::ptrdiff_t>(count));
    if (!is_ascii(place.back()) && !labels_.of(place.back())) {
      Begun& begun = all[place];
      if (path.size() == count) {
        ++begun.files;
      } else if (path.size() == count + 1 && path.back() == kFolderItself) {
        ++begun.folders;
      } else if (place != before) {
        ++begun.rows;
      }
    }
    before = place;
  }
  std::vector<Place> twice;
  for (const auto& [place, begun] : all) {
    if (begun.twice()) twice.push_back(place);
  }
  return twice;
}

}  // namespace grader::intake
